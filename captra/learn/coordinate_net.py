"""CoordinateNet: which part each point belongs to, and where on it (paper, Sec. "Normalized coordinates")."""

import torch
from jaxtyping import Float
from torch import Tensor, nn

from captra.architecture import FEATURES, XYZ
from captra.learn.pointnet2 import Backbone, NormalizedLinear, TorchNeighborhoods


class CoordinateNet(nn.Module):
    """Segmentation logits and normalized coordinates of each point, from the root's canonical cloud."""

    def __init__(self, num_parts: int, num_classes: int) -> None:
        super().__init__()
        self.num_parts = num_parts
        self.backbone = Backbone(positions=True)
        self.segmentation = nn.Linear(FEATURES, num_classes)
        self.hidden = NormalizedLinear(FEATURES, FEATURES)
        self.coordinates = nn.Linear(FEATURES, XYZ * num_parts)

    def forward(
        self, points: Float[Tensor, "batch points 3"], neighborhoods: TorchNeighborhoods
    ) -> tuple[Float[Tensor, "batch classes points"], Float[Tensor, "batch parts points 3"]]:
        """Logits (softmax over classes gives the segmentation) and coordinates in [-0.5, 0.5], both float32.

        Args:
            points: in farthest-point order, canonical units.
            neighborhoods: their groups and neighbours.
        """
        batch, count = points.shape[:2]
        rows = self.backbone(points, neighborhoods)
        logits = self.segmentation(rows).float().view(batch, count, -1)
        raw = self.coordinates(self.hidden(rows)).float().view(batch, count, self.num_parts, XYZ)
        return logits.transpose(1, 2), (torch.sigmoid(raw) - 0.5).transpose(1, 2)

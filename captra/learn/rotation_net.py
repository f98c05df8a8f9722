"""RotationNet: each part's residual rotation, as every point of its own canonical cloud sees it (paper, appendix)."""

from typing import cast

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from captra.architecture import FEATURES, HEAD_CHANNELS
from captra.learn.fused import cloud_norm_relu
from captra.learn.pointnet2 import Backbone, TorchNeighborhoods

CHANNELS_PER_GROUP = 2


class CloudNorm(nn.Module):
    """Group norm with two channels a group, over all points of one cloud, and ReLU."""

    def __init__(self, channels: int) -> None:
        super().__init__()
        self.weight = nn.Parameter(torch.ones(channels))
        self.bias = nn.Parameter(torch.zeros(channels))
        self.eps = 1e-5

    def forward(self, hidden: Float[Tensor, "batch points channels"]) -> Float[Tensor, "batch points channels"]:
        """Normalize each pair of channels in each cloud."""
        return cloud_norm_relu(hidden, self.weight, self.bias, CHANNELS_PER_GROUP, self.eps)


class RotationHead(nn.Module):
    """128 → 512 → 512 → 256 → 6 (3 for a symmetric object) on every point of one part's cloud."""

    def __init__(self, width: int) -> None:
        super().__init__()
        inputs = (FEATURES, *HEAD_CHANNELS[:-1])
        self.layers = nn.ModuleList(nn.Linear(i, o) for i, o in zip(inputs, HEAD_CHANNELS, strict=True))
        self.norms = nn.ModuleList(CloudNorm(channels) for channels in HEAD_CHANNELS)
        self.output = nn.Linear(HEAD_CHANNELS[-1], width)
        self._start_at_identity()

    def _start_at_identity(self) -> None:
        """Residual rotations are small: the untrained head answers with none."""
        nn.init.normal_(self.output.weight, std=0.01)
        identity = [0.0, 1.0, 0.0] if self.output.out_features == 3 else [1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
        self.output.bias.data = torch.tensor(identity)

    @property
    def blocks(self) -> list[tuple[nn.Linear, CloudNorm]]:
        """Layers before the output, each with its norm."""
        return list(zip(cast("list[nn.Linear]", self.layers), cast("list[CloudNorm]", self.norms), strict=True))

    def forward(self, hidden: Float[Tensor, "batch points 128"]) -> Float[Tensor, "batch points width"]:
        """Raw rotations of each point."""
        for layer, norm in self.blocks:
            hidden = norm(layer(hidden))
        return self.output(hidden)  # type: ignore[no-any-return]


class RotationNet(nn.Module):
    """Raw residual rotations of each point: six numbers, or three for objects symmetric about y."""

    def __init__(self, num_parts: int, symmetric: bool) -> None:
        super().__init__()
        self.num_parts = num_parts
        self.symmetric = symmetric
        self.backbone = Backbone(positions=False)
        self.heads = nn.ModuleList(RotationHead(3 if symmetric else 6) for _ in range(num_parts))

    def forward(
        self,
        points: Float[Tensor, "batch parts points 3"],
        neighborhoods: TorchNeighborhoods,
        head_points: int | None = None,
    ) -> Float[Tensor, "batch parts head_points width"]:
        """Head j on cloud j, float32.

        Args:
            points: each part's canonical cloud in farthest-point order.
            neighborhoods: with a leading axis batch · parts, cloud j of sample b at b · parts + j.
            head_points: run the heads on so many points only, all by default; the first ones cover the whole cloud,
                since a prefix of farthest points is farthest points of its own.
        """
        batch, parts, count = points.shape[:3]
        rows = self.backbone(points.flatten(0, 1), neighborhoods)
        features = rows.view(batch, parts, count, -1)[:, :, :head_points]
        return torch.stack([head(features[:, j]).float() for j, head in enumerate(self.heads)], dim=1)

    def one_part(
        self,
        points: Float[Tensor, "batch points 3"],
        part: Int[Tensor, " batch"],
        neighborhoods: TorchNeighborhoods,
        head_points: int | None = None,
    ) -> Float[Tensor, "batch head_points width"]:
        """As `forward`, for one part of each sample: `points` is its canonical cloud, `part` the head to run on it."""
        batch, count = points.shape[:2]
        features = self.backbone(points, neighborhoods).view(batch, count, -1)[:, :head_points]
        answers: Tensor = features.new_zeros((*features.shape[:2], 3 if self.symmetric else 6), dtype=torch.float32)
        for j, head in enumerate(self.heads):
            chosen = (part == j).nonzero()[:, 0]
            if len(chosen):
                answers = answers.index_copy(0, chosen, head(features[chosen]).float())
        return answers

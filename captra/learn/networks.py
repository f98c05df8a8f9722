"""The networks in PyTorch behind the tracker's protocol: for evaluation while training, and to compare exports with."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import torch
from jaxtyping import Float32

from captra.categories import Category
from captra.joint_projection import UNPROJECTED, JointProjection
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.pointnet2 import TorchNeighborhoods
from captra.learn.rotation_net import RotationNet
from captra.pose_memory import USUAL_ERROR, FoundError
from captra.rotation_fusion import ROTATION_NET_ALONE, RotationFusion
from captra.sampling import InputSampling, Neighborhoods, Profile
from captra.side_by_side import IN_TURN, SideBySide


@dataclass(frozen=True)
class TorchNetworks:
    """Satisfies `captra.looking.Networks`."""

    category: Category
    """What the networks were trained on."""
    profile: Profile
    """Shapes of the inputs."""
    coordinate_net: CoordinateNet
    """In evaluation mode."""
    rotation_net: RotationNet
    """In evaluation mode."""
    input_sampling: InputSampling = field(default_factory=InputSampling)
    """How the points were drawn in training."""
    rotation_fusion: RotationFusion = ROTATION_NET_ALONE
    """Whose word counts for rotations."""
    joint_projection: JointProjection = UNPROJECTED
    """How rotations are kept on the joints."""
    found_error: FoundError = USUAL_ERROR
    """By how much the networks err on one object all the time."""
    side_by_side: SideBySide = IN_TURN
    """PyTorch takes all cores by itself."""
    rotation_share: float = 1.0
    """Share of the points, the first ones, that RotationNet's heads are run on."""

    def coordinates(
        self, points_canonical: Float32[np.ndarray, "points 3"], neighborhoods: Neighborhoods
    ) -> tuple[Float32[np.ndarray, "classes points"], Float32[np.ndarray, "parts points 3"]]:
        """Class probabilities and normalized coordinates, from the root's canonical cloud."""
        points = torch.from_numpy(points_canonical)[None]
        with torch.inference_mode():
            logits, coordinates = self.coordinate_net(points, TorchNeighborhoods.stack([neighborhoods]))
            return torch.softmax(logits[0], dim=0).numpy(), coordinates[0].contiguous().numpy()

    def rotations(
        self, points_canonical: Float32[np.ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[np.ndarray, "parts rotated_points width"]:
        """Raw residual rotations of the first points; part j from cloud j."""
        points = torch.from_numpy(points_canonical)[None]
        rotated = max(1, round(self.rotation_share * points.shape[2]))
        with torch.inference_mode():
            raw = self.rotation_net(points, TorchNeighborhoods.stack(neighborhoods), rotated)
            return raw[0].numpy()  # type: ignore[no-any-return]

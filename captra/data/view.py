"""One simulated frame: a cloud around an object, what each point belongs to, and the object's true pose."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32, UInt8

from captra.geometry import Pose


@dataclass(frozen=True)
class View:
    """A cloud with its truth, camera frame (x right, y down, z forward), metres."""

    points: Float32[np.ndarray, "N 3"]
    """A random subset of the pixels in a ball around the object, or of the object's own ones if it is pre-segmented."""
    labels: UInt8[np.ndarray, " N"]
    """Part of each point; P is background, or a stray point of a pre-segmented cloud."""
    rotation: Float32[np.ndarray, "P 3 3"]
    """R_camera_part."""
    translation: Float32[np.ndarray, "P 3"]
    """Centre of each part's tight box."""
    size: Float32[np.ndarray, "P 3"]
    """Extent of each part's tight box along its axes."""
    joint_values: Float32[np.ndarray, " J"]
    """Joint states, rad or m; empty for rigid objects."""

    @property
    def pose(self) -> Pose:
        """The true pose of all parts."""
        return Pose.from_size(self.rotation.astype(np.float64), self.translation.astype(np.float64), self.size)


def ball_radius(scale: float) -> float:
    """Radius of the ball that a view keeps around the centre of an object of this scale, metres.

    It leaves room for the tracker's crop (0.6 scales, at least 5 cm) around a perturbed pose.
    """
    return max(0.05, 0.6 * scale) * 1.6 + 0.08

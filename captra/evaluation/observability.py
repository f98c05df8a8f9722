"""Which frames say anything about a rotation: a mug whose handle is out of sight looks the same all round."""

import numpy as np
from jaxtyping import Bool, Float

from captra.data.recordings import Recording
from captra.geometry import Pose

FEWEST_HANDLE_POINTS = 15
HANDLE_CLEARANCE_M = 0.003


def handle_points(points: Float[np.ndarray, "points 3"], labels: np.ndarray, truth: Pose) -> int:
    """Number of a mug's points that lie on its handle.

    The body is as wide in x as the box is in z and touches its −x side; what stands out beyond it towards +x is handle.
    """
    own = (points[labels == 0] - truth.translation[0]) @ truth.rotation[0]
    size_x, _, size_z = truth.size[0]
    return int(np.count_nonzero(own[:, 0] > size_z - size_x / 2 + HANDLE_CLEARANCE_M))


def symmetric_frames(recording: Recording) -> Bool[np.ndarray, " frames"]:
    """Frames to score as symmetric about y: all of a symmetric category, and those of a mug that show no handle."""
    if recording.category.symmetric:
        return np.ones(len(recording), bool)
    if recording.category.name != "mug":
        return np.zeros(len(recording), bool)
    counts = [
        handle_points(cloud, labels, recording.truth(frame))
        for frame, (cloud, labels) in enumerate(zip(recording.clouds, recording.labels, strict=True))
    ]
    return np.array(counts) < FEWEST_HANDLE_POINTS

"""Into and out of the last pose (paper, Definition "Pose-canonicalized point cloud")."""

import numpy as np
from jaxtyping import Float, Float32, Float64

from captra.geometry import Pose


def canonicalize(points: Float[np.ndarray, "points 3"], pose: Pose) -> Float32[np.ndarray, "parts points 3"]:
    """Z = R⁻¹ (X − T) / s for each part: camera frame, metres → the part's normalized frame."""
    centred = np.asarray(points, np.float32)[None] - pose.translation.astype(np.float32)[:, None]
    inverse = (pose.rotation / pose.scale[:, None, None]).astype(np.float32)
    return np.ascontiguousarray(centred @ inverse)


def decanonicalize(
    points_canonical: Float[np.ndarray, "parts points 3"], pose: Pose
) -> Float64[np.ndarray, "parts points 3"]:
    """X = s R Z + T for each part: the inverse of `canonicalize`."""
    scaled = points_canonical * pose.scale[:, None, None]
    return np.asarray(scaled @ np.swapaxes(pose.rotation, -1, -2) + pose.translation[:, None])


def compose(last: Pose, residual: Pose) -> Pose:
    """The new pose from the last one and the residual in its canonical frame (Sec. "Pose Canonicalization").

    s' = s ŝ, R' = R R̂, T' = s R T̂ + T; the residual's size is in units of the last scale.
    """
    rotated = np.einsum("pij,pj->pi", last.rotation, residual.translation)
    return Pose(
        rotation=last.rotation @ residual.rotation,
        translation=last.scale[:, None] * rotated + last.translation,
        scale=last.scale * residual.scale,
        size=last.scale[:, None] * residual.size,
    )

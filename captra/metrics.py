"""The paper's measures; angles in degrees and distances in centimetres, as reports print them."""

import numpy as np
from jaxtyping import Bool, Float, Float64

from captra.fitting import closest_gauge
from captra.geometry import Pose, axis_angle, box_corners, rotation_angle
from captra.overlap import intersection_volume

SYMMETRIC_ROTATIONS = 20
"""Rotations of the truth about y among which a symmetric object's IoU is the best (NOCS evaluation)."""


def rotation_error_deg(
    rotation: Float[np.ndarray, "*batch 3 3"], truth: Float[np.ndarray, "*batch 3 3"], *, symmetric: bool
) -> Float64[np.ndarray, "*batch"]:
    """Angle between two rotations; between their y axes for symmetric objects."""
    if symmetric:
        a, b = rotation[..., :, 1], truth[..., :, 1]
        radians = np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), np.sum(a * b, axis=-1))
    else:
        radians = rotation_angle(np.swapaxes(truth, -1, -2) @ rotation)
    return np.asarray(np.degrees(radians))


def translation_error_cm(
    translation: Float[np.ndarray, "*batch 3"], truth: Float[np.ndarray, "*batch 3"]
) -> Float64[np.ndarray, "*batch"]:
    """Distance between two centres."""
    return np.asarray(100 * np.linalg.norm(translation - truth, axis=-1))


def within(
    rotation_deg: Float[np.ndarray, "*batch"],
    translation_cm: Float[np.ndarray, "*batch"],
    degrees: float = 5.0,
    centimetres: float = 5.0,
) -> Bool[np.ndarray, "*batch"]:
    """Whether both errors are within the bounds: 5°5cm by default."""
    return np.asarray((rotation_deg <= degrees) & (translation_cm <= centimetres))


def _over_symmetry(truth: Pose, *, symmetric: bool) -> Float64[np.ndarray, "rotations 3 3"]:
    count = SYMMETRIC_ROTATIONS if symmetric else 1
    turns = axis_angle(np.tile([0.0, 1.0, 0.0], (count, 1)), 2 * np.pi * np.arange(count) / count)
    return np.asarray(truth.rotation[0] @ turns)


def iou_oriented(estimate: Pose, truth: Pose, *, symmetric: bool) -> float:
    """Intersection over union of the two boxes as they stand; both poses hold one part."""
    best = 0.0
    volume = float(np.prod(truth.size[0]) + np.prod(estimate.size[0]))
    for rotation in _over_symmetry(truth, symmetric=symmetric):
        shared = intersection_volume(
            truth.size[0],
            estimate.size[0],
            rotation.T @ estimate.rotation[0],
            rotation.T @ (estimate.translation[0] - truth.translation[0]),
        )
        best = max(best, shared / (volume - shared))
    return best


def iou_nocs(estimate: Pose, truth: Pose, *, symmetric: bool) -> float:
    """Intersection over union of the axis-aligned bounds of the two posed boxes, as the NOCS benchmark computes it."""
    low_a, high_a = _bounds(estimate.rotation[0], estimate)
    best = 0.0
    for rotation in _over_symmetry(truth, symmetric=symmetric):
        low_b, high_b = _bounds(rotation, truth)
        shared = np.prod(np.maximum(np.minimum(high_a, high_b) - np.maximum(low_a, low_b), 0))
        union = np.prod(high_a - low_a) + np.prod(high_b - low_b) - shared
        best = max(best, float(shared / union))
    return best


def _bounds(
    rotation: Float64[np.ndarray, "3 3"], pose: Pose
) -> tuple[Float64[np.ndarray, "3"], Float64[np.ndarray, "3"]]:
    corners = box_corners(pose.size[0]) @ rotation.T + pose.translation[0]
    return corners.min(axis=0), corners.max(axis=0)


def scale_error_percent(estimate: Pose, truth: Pose) -> Float64[np.ndarray, " parts"]:
    """Relative error of the similarity's scale."""
    return np.asarray(100 * np.abs(estimate.scale / truth.scale - 1))


def average_distance_accuracy(
    points_part: Float[np.ndarray, "points 3"], estimate: Pose, truth: Pose, *, symmetric: bool, fraction: float = 0.1
) -> bool:
    """AD-10 %: whether model points land, on average, within `fraction` of the part's diameter of where they belong.

    A symmetric estimate is first turned about y to where it is closest. The scale has no part in it.
    """
    rotation = closest_gauge(estimate.rotation[0], truth.rotation[0]) if symmetric else estimate.rotation[0]
    a = points_part @ rotation.T + estimate.translation[0]
    b = points_part @ truth.rotation[0].T + truth.translation[0]
    return bool(np.linalg.norm(a - b, axis=-1).mean() <= fraction * truth.scale[0])

"""From the networks' answers to the pose of every part, with the numbers that tell how far to trust it."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float32, Float64, Int

from captra import fitting
from captra.categories import Category
from captra.geometry import Pose, rotation_angle, rotation_from_6d, rotation_from_axis
from captra.health import Evidence, PartEvidence
from captra.rotation_fusion import ROTATION_NET_ALONE, RotationFusion

FEWEST_POINTS = 4
"""A part with fewer keeps its last pose (METHOD, "Step")."""

INLIER_RESIDUAL = 0.05
"""Canonical distance below which a point agrees with the fit."""


LARGEST_GROWTH = 1.5
"""An object that seems to grow or shrink by more from one frame to the next was not seen right."""

LARGEST_LEAP = 1.0
"""Likewise one whose centre moves by more than so many scales."""


@dataclass(frozen=True)
class Prediction:
    """What both networks said about N points."""

    segmentation: Float32[np.ndarray, "classes points"]
    """Class probabilities."""
    coordinates: Float32[np.ndarray, "parts points 3"]
    """Normalized coordinates of every point under every part's frame."""
    labels: Int[np.ndarray, " points"]
    """Most probable class."""
    delta_rotations: Float64[np.ndarray, "parts rotated_points 3 3"]
    """Residual rotation of every part, as each of the first points sees it; these cover the whole cloud."""


@dataclass(frozen=True)
class PartFit:
    """One part's new similarity and box."""

    rotation: Float64[np.ndarray, "3 3"]
    """R_camera_part."""
    scale: float
    """Metres."""
    translation: Float64[np.ndarray, "3"]
    """Metres."""
    size: Float64[np.ndarray, "3"]
    """Metres."""
    evidence: PartEvidence
    """How well it fits."""


def per_point_rotations(
    raw: Float32[np.ndarray, "parts points width"], category: Category
) -> Float64[np.ndarray, "parts points 3 3"]:
    """RotationNet's raw answers as matrices."""
    return rotation_from_axis(raw) if category.symmetric else rotation_from_6d(raw)


def residual_rotation(rotations: Float64[np.ndarray, "points 3 3"], category: Category) -> Float64[np.ndarray, "3 3"]:
    """The part's residual rotation: the mean over its points; identity for a part without points or finite answers."""
    if len(rotations) == 0 or not np.isfinite(rotations).all():
        return np.eye(3)
    return fitting.mean_axis_rotation(rotations) if category.symmetric else fitting.mean_rotation(rotations)


def solve(
    points: Float32[np.ndarray, "points 3"],
    prediction: Prediction,
    last: Pose,
    category: Category,
    fusion: RotationFusion = ROTATION_NET_ALONE,
) -> tuple[Pose, Evidence]:
    """Rotations first, then scale and translation in closed form, part by part."""
    fits = []
    for part in range(category.num_parts):
        mask = prediction.labels == part
        seen = prediction.delta_rotations[part]
        delta = residual_rotation(seen[mask[: len(seen)]], category)
        fit = fit_part(points[mask], prediction.coordinates[part, mask], delta, last.part(part), category, fusion)
        fits.append(fit)
    pose = Pose(
        rotation=np.stack([fit.rotation for fit in fits]),
        translation=np.stack([fit.translation for fit in fits]),
        scale=np.array([fit.scale for fit in fits]),
        size=np.stack([fit.size for fit in fits]),
    )
    foreground = prediction.segmentation[: category.num_parts].sum(axis=0)
    return pose, Evidence(tuple(fit.evidence for fit in fits), float(foreground.mean()))


def reject_leaps(pose: Pose, last: Pose) -> Pose:
    """Keep parts that grew, shrank or moved beyond belief where they were: one bad frame cannot throw a track away."""
    growth = np.abs(np.log(pose.scale / last.scale))
    leap = np.linalg.norm(pose.translation - last.translation, axis=-1) / last.scale
    kept = (growth > np.log(LARGEST_GROWTH)) | (leap > LARGEST_LEAP)
    return Pose(
        rotation=np.where(kept[:, None, None], last.rotation, pose.rotation),
        translation=np.where(kept[:, None], last.translation, pose.translation),
        scale=np.where(kept, last.scale, pose.scale),
        size=np.where(kept[:, None], last.size, pose.size),
    )


def hold_gauge(pose: Pose, last: Pose, category: Category) -> Pose:
    """Turn symmetric parts about their own axis to where they were, so that they do not spin; others are left alone."""
    if not category.symmetric:
        return pose
    held = [fitting.closest_gauge(new, old) for new, old in zip(pose.rotation, last.rotation, strict=True)]
    return replace(pose, rotation=np.stack(held))


def fit_part(
    points: Float32[np.ndarray, "points 3"],
    coordinates: Float32[np.ndarray, "points 3"],
    delta: Float64[np.ndarray, "3 3"],
    last: Pose,
    category: Category,
    fusion: RotationFusion,
) -> PartFit:
    """Scale and translation of one part given RotationNet's residual rotation; `last` holds that part alone.

    A part with three or fewer points, or without a finite positive scale, keeps its last scale and translation.
    """
    from_rotation_net = last.rotation[0] @ delta
    missing = PartEvidence.missing(len(points), last.translation[0])
    kept = PartFit(from_rotation_net, float(last.scale[0]), last.translation[0], last.size[0], missing)
    if len(points) < FEWEST_POINTS or not np.isfinite(coordinates).all():
        return kept
    aligned = np.asarray(coordinates, np.float64)
    if category.symmetric:
        aligned = aligned @ fitting.symmetric_alignment(aligned, points @ from_rotation_net).T
    from_coordinates = fitting.umeyama(aligned, points).rotation
    rotation = fusion(from_rotation_net, from_coordinates)
    rotated = aligned @ rotation.T
    scale, translation = fitting.scale_and_translation(rotated, points)
    if not np.isfinite(scale) or scale <= 0:
        return kept
    size = scale * 2 * np.abs(coordinates).max(axis=0)
    residuals = np.linalg.norm(scale * rotated + translation - points, axis=-1) / scale
    evidence = PartEvidence(
        points=len(points),
        centroid=points.mean(axis=0, dtype=np.float64),
        residual=float(np.sqrt(np.mean(residuals**2))),
        inliers=float(np.mean(residuals < INLIER_RESIDUAL)),
        disagreement_rad=_disagreement(from_coordinates, from_rotation_net, category),
        rotation_jump_rad=_disagreement(rotation, last.rotation[0], category),
        translation_jump=float(np.linalg.norm(translation - last.translation[0]) / last.scale[0]),
        scale_jump=float(abs(np.log(scale / last.scale[0]))),
    )
    return PartFit(rotation, scale, translation, size, evidence)


def _disagreement(a: Float64[np.ndarray, "3 3"], b: Float64[np.ndarray, "3 3"], category: Category) -> float:
    """Angle between two rotations, radians; between their y axes for symmetric objects."""
    if category.symmetric:
        return float(np.arctan2(np.linalg.norm(np.cross(a[:, 1], b[:, 1])), a[:, 1] @ b[:, 1]))
    return float(rotation_angle(a.T @ b))

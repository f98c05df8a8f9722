"""From the networks' answers to the pose of every part, with the numbers that tell how far to trust it."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float32, Float64, Int

from captra import fitting
from captra.categories import Category
from captra.evidence import (
    SMALLEST_SIDE_M,
    Evidence,
    PartEvidence,
    agreement,
    inside_box,
    shape_jump,
    share_outside,
    thickness,
)
from captra.geometry import Pose, project_to_rotation, rotation_from_6d, rotation_from_axis
from captra.joint_projection import UNPROJECTED, JointProjection
from captra.riding import carried
from captra.rotation_fusion import ROTATION_NET_ALONE, RotationFusion
from captra.turn import Turn, angle_between

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

    def of_part(self, part: int, mask: Bool[np.ndarray, " points"]) -> Float64[np.ndarray, "own 3 3"]:
        """The residual rotations that the points of a part see."""
        seen = self.delta_rotations[part]
        return np.asarray(seen[mask[: len(seen)]])


def per_point_rotations(
    raw: Float32[np.ndarray, "parts points width"], category: Category
) -> Float64[np.ndarray, "parts points 3 3"]:
    """RotationNet's raw answers as matrices."""
    return rotation_from_axis(raw) if category.symmetric else rotation_from_6d(raw)


@dataclass(frozen=True)
class PartRotation:
    """What both networks say of one part's rotation."""

    rotation: Float64[np.ndarray, "3 3"]
    """R_camera_part to go on with."""
    aligned: Float64[np.ndarray, "points 3"] | None
    """The part's coordinates in the gauge of the rotation; none for a part that cannot be fitted."""
    disagreement_rad: float
    """Angle between RotationNet's rotation and that of the full Umeyama fit."""
    spread: float
    """How far the points' own rotations are from agreeing, see `residual_rotation`."""
    turn: Turn
    """What the part's points tell of its turn about y."""


def residual_rotation(
    rotations: Float64[np.ndarray, "points 3 3"], category: Category
) -> tuple[Float64[np.ndarray, "3 3"], float]:
    """The mean over a part's points, and their spread; identity for a part without points or finite answers.

    The spread is one minus the length of the mean: of the y axes for symmetric objects, else of the matrices over √3.
    """
    mean = rotations.sum(axis=0) / max(len(rotations), 1)
    if len(rotations) == 0 or not np.isfinite(mean).all():
        return np.eye(3), 1.0
    if category.symmetric:
        return rotation_from_axis(mean[:, 1]), float(1 - np.linalg.norm(mean[:, 1]))
    return project_to_rotation(mean), float(1 - np.linalg.norm(mean) / np.sqrt(3))


def solve(
    points: Float32[np.ndarray, "points 3"],
    prediction: Prediction,
    last: Pose,
    category: Category,
    fusion: RotationFusion = ROTATION_NET_ALONE,
    projection: JointProjection = UNPROJECTED,
) -> tuple[Pose, Evidence]:
    """Rotations first, then scale and translation in closed form, part by part; `last` is the pose looked around.

    A part of which nothing is seen keeps its pose, and binds those on its joints as if it had gone with them.
    """
    masks = [prediction.labels == part for part in range(category.num_parts)]
    found = [
        fit_rotation(points[mask], prediction, part, mask, last, category, fusion) for part, mask in enumerate(masks)
    ]
    seen = np.array([0 if one.aligned is None else mask.sum() for mask, one in zip(masks, found, strict=True)])
    turned = replace(last, rotation=np.stack([one.rotation for one in found]))
    allowed = projection(carried(turned, last, seen).rotation, seen, category)
    rotations = np.where((seen > 0)[:, None, None], allowed, turned.rotation)
    fits = [
        fit_part(points, prediction, part, mask, replace(one, rotation=rotation), last.part(part))
        for part, (mask, one, rotation) in enumerate(zip(masks, found, rotations, strict=True))
    ]
    translation, scale, size, parts = zip(*fits, strict=True)
    pose = Pose(rotations, np.stack(translation), np.array(scale), np.stack(size))
    foreground = prediction.segmentation[: category.num_parts].sum(axis=0)
    return pose, Evidence(parts, float(foreground.mean()), len(points))


def fit_rotation(
    points: Float32[np.ndarray, "own 3"],
    prediction: Prediction,
    part: int,
    mask: Bool[np.ndarray, " points"],
    last: Pose,
    category: Category,
    fusion: RotationFusion,
) -> PartRotation:
    """One part's rotation from RotationNet and from its coordinates; `points` are those labelled as the part."""
    delta, spread = residual_rotation(prediction.of_part(part, mask), category)
    from_rotation_net = last.rotation[part] @ delta
    aligned = prediction.coordinates[part, mask].astype(np.float64)
    if len(points) < FEWEST_POINTS or not np.isfinite(aligned).all():
        return PartRotation(from_rotation_net, None, np.pi, spread, Turn(0.0, 0.0))
    if category.symmetric:
        aligned = aligned @ fitting.symmetric_alignment(aligned, points @ from_rotation_net).T
    from_coordinates = fitting.umeyama(aligned, points).rotation
    turn = Turn.seen(prediction.coordinates[part, mask], last.size[part] / last.scale[part], category)
    disagreement = angle_between(from_coordinates, from_rotation_net, turn)
    return PartRotation(fusion(from_rotation_net, from_coordinates), aligned, disagreement, spread, turn)


def fit_part(
    points: Float32[np.ndarray, "points 3"],
    prediction: Prediction,
    part: int,
    mask: Bool[np.ndarray, " points"],
    found: PartRotation,
    last: Pose,
) -> tuple[Float64[np.ndarray, "3"], float, Float64[np.ndarray, "3"], PartEvidence]:
    """Translation, scale and size of one part, metres, given its rotation; `last` holds that part alone.

    A part with three or fewer points, or without a finite positive scale, keeps its last scale and translation.
    """
    own = points[mask]
    kept = (last.translation[0], float(last.scale[0]), last.size[0])
    missing = PartEvidence.missing(len(own), last.translation[0])
    if found.aligned is None:
        return *kept, missing
    rotated = found.aligned @ found.rotation.T
    scale, translation = fitting.scale_and_translation(rotated, own)
    if not np.isfinite(scale) or scale <= 0:
        return *kept, missing
    size = scale * 2 * np.abs(prediction.coordinates[part, mask]).max(axis=0)
    residual, near = agreement(scale * rotated + translation, own, INLIER_RESIDUAL * scale)
    boxed = inside_box(points, last)
    in_box = np.count_nonzero(boxed)
    evidence = PartEvidence(
        points=len(own),
        centroid=own.mean(axis=0, dtype=np.float64),
        explained=own[near].astype(np.float64),
        residual=residual / scale,
        inliers=np.count_nonzero(near) / len(own),
        disagreement_rad=found.disagreement_rad,
        rotation_jump_rad=angle_between(found.rotation, last.rotation[0], found.turn),
        translation_jump=float(np.linalg.norm(translation - last.translation[0]) / last.scale[0]),
        scale_jump=float(abs(np.log(scale / last.scale[0]))),
        spread=found.spread,
        shape_jump=shape_jump(size, last.size[0]),
        share=len(own) / len(points),
        filled=np.count_nonzero(mask & boxed) / in_box if in_box else 0.0,
        certainty=float(prediction.segmentation[part, mask].mean()),
        outside=share_outside((own - translation) @ found.rotation, size),
        thickness=thickness(own) / scale,
        guessed_turn=found.turn.guessed,
        diagonal_error=float(abs(np.log(max(float(np.linalg.norm(size)), SMALLEST_SIDE_M) / scale))),
    )
    return translation, scale, size, evidence


def reject_leaps(pose: Pose, evidence: Evidence, last: Pose) -> tuple[Pose, Evidence]:
    """Keep parts that grew, shrank or moved beyond belief where they were: one bad frame cannot throw a track away."""
    growth = np.abs(np.log(pose.scale / last.scale))
    leap = np.linalg.norm(pose.translation - last.translation, axis=-1) / last.scale
    kept = (growth > np.log(LARGEST_GROWTH)) | (leap > LARGEST_LEAP)
    held = Pose(
        rotation=np.where(kept[:, None, None], last.rotation, pose.rotation),
        translation=np.where(kept[:, None], last.translation, pose.translation),
        scale=np.where(kept, last.scale, pose.scale),
        size=np.where(kept[:, None], last.size, pose.size),
    )
    return held, evidence.keeping(kept)


def hold_gauge(pose: Pose, last: Pose, category: Category) -> Pose:
    """Turn symmetric parts about their own axis to where they were, so that they do not spin; others are left alone."""
    if not category.symmetric:
        return pose
    held = [fitting.closest_gauge(new, old) for new, old in zip(pose.rotation, last.rotation, strict=True)]
    return replace(pose, rotation=np.stack(held))

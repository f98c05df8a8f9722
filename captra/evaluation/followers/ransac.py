"""Canonicalized CoordinateNet alone: rotation, scale and translation from its coordinates, by RANSAC."""

import zlib
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32

from captra.canonical import canonicalize
from captra.evaluation.followers.follower import Track, follow
from captra.evaluation.sequences import Sequence
from captra.fitting import umeyama_ransac
from captra.geometry import Pose
from captra.looking import Networks, choose_points
from captra.observations import PointCloud
from captra.sampling import build_neighborhoods
from captra.solving import FEWEST_POINTS, INLIER_RESIDUAL, hold_gauge


@dataclass(frozen=True)
class CoordinatesWithRansac:
    """The paper's ablation "C-CoordinateNet"; it remembers nothing but the last pose."""

    label: str = "C-CoordinateNet + RANSAC"
    """As tables name it."""

    def __call__(self, networks: Networks, sequence: Sequence) -> Track:
        """Follow the object; draws are the same in every run."""
        rng = np.random.default_rng(zlib.crc32(sequence.recording.name.encode()))
        return Track(
            follow(sequence, sequence.recording.init, lambda cloud, _, last: _step(networks, cloud, last, rng))
        )


def _step(networks: Networks, cloud: Float32[np.ndarray, "all 3"], last: Pose, rng: np.random.Generator) -> Pose:
    category = networks.category
    crop = choose_points(PointCloud.of(cloud), last, category, networks.profile.points, networks.input_sampling)
    points = crop.points
    canonical = canonicalize(points, last.part(category.root))[0]
    segmentation, coordinates = networks.coordinates(canonical, build_neighborhoods(canonical, networks.profile))
    labels = segmentation.argmax(axis=0)
    parts = [
        _fit(coordinates[part, labels == part], points[labels == part], last.part(part), rng)
        for part in range(category.num_parts)
    ]
    fields = ("rotation", "translation", "scale", "size")
    pose = Pose(**{field: np.concatenate([getattr(part, field) for part in parts]) for field in fields})
    return hold_gauge(pose, last, category)


def _fit(
    coordinates: Float32[np.ndarray, "points 3"],
    points: Float32[np.ndarray, "points 3"],
    last: Pose,
    rng: np.random.Generator,
) -> Pose:
    """One part; it stays where it was without enough points or a sensible scale."""
    if len(points) < FEWEST_POINTS or not np.isfinite(coordinates).all():
        return last
    fit = umeyama_ransac(coordinates, points, INLIER_RESIDUAL * float(last.scale[0]), rng)
    if not np.isfinite(fit.scale) or fit.scale <= 0:
        return last
    size = fit.scale * 2 * np.abs(coordinates).max(axis=0).astype(np.float64)
    return Pose(fit.rotation[None], fit.translation[None], np.array([fit.scale]), size[None])

"""Closed-form fits: means of rotations, similarity between coordinates and points, the symmetric gauge, joint axes."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64, Int

from captra.geometry import axis_angle, project_to_rotation, rotation_from_axis
from captra.moments import Moments

Y = np.array([0.0, 1.0, 0.0])
SMALLEST_SQUARE = 1e-12
"""Keeps points that all are in one place from having an infinite scale."""


@dataclass(frozen=True)
class Similarity:
    """target ≈ scale · rotation · source + translation."""

    scale: float
    """Dimensionless or metres, by what the source is in."""
    rotation: Float64[np.ndarray, "3 3"]
    """R_target_source."""
    translation: Float64[np.ndarray, "3"]
    """In the target's units."""

    def apply(self, source: Float[np.ndarray, "points 3"]) -> Float64[np.ndarray, "points 3"]:
        """Map source points to the target's frame."""
        return np.asarray(self.scale * source @ self.rotation.T + self.translation)


def mean_rotation(
    rotations: Float[np.ndarray, "points 3 3"], weights: Int[np.ndarray, " points"] | None = None
) -> Float64[np.ndarray, "3 3"]:
    """Euclidean mean: the arithmetic mean projected back onto SO(3) (appendix "Euclidean Mean of Rotations")."""
    return project_to_rotation(np.average(np.asarray(rotations, np.float64), axis=0, weights=weights))


def mean_axis_rotation(rotations: Float[np.ndarray, "points 3 3"]) -> Float64[np.ndarray, "3 3"]:
    """Mean for objects symmetric about y: the normalized mean of the y axes, in the gauge of `rotation_from_axis`."""
    return rotation_from_axis(np.asarray(rotations, np.float64)[:, :, 1].mean(axis=0))


def scale_and_translation(
    rotated: Float[np.ndarray, "points 3"], points: Float[np.ndarray, "points 3"]
) -> tuple[float, Float64[np.ndarray, "3"]]:
    """Least-squares s and t of points ≈ s · rotated + t, both sets centred first.

    Source: appendix "Scale and Translation Computation".
    """
    return _scale_and_translation(Moments.of(rotated, points), np.eye(3))


def _scale_and_translation(moments: Moments, rotation: Float64[np.ndarray, "3 3"]) -> tuple[float, np.ndarray]:
    """The same for source points that are still to be rotated: Σ w·c is tr(Rᵀ Σ c wᵀ), and lengths stay."""
    scale = float(np.sum(rotation * moments.products)) / max(moments.source_square, SMALLEST_SQUARE)
    return scale, moments.target_mean - scale * rotation @ moments.source_mean


def symmetric_alignment(
    coordinates: Float[np.ndarray, "points 3"], points: Float[np.ndarray, "points 3"]
) -> Float64[np.ndarray, "3 3"]:
    """The rotation about y that best turns `coordinates` onto `points`, both in the object's axes.

    2D Umeyama in the xz-plane (appendix "Scale and Translation Computation").
    """
    products = Moments.of(coordinates, points).products
    return axis_angle(Y, np.arctan2(products[0, 2] - products[2, 0], products[0, 0] + products[2, 2]))


def umeyama(source: Float[np.ndarray, "points 3"], target: Float[np.ndarray, "points 3"]) -> Similarity:
    """Least-squares similarity target ≈ s R source + t (Umeyama 1991)."""
    moments = Moments.of(source, target)
    rotation = project_to_rotation(moments.products)
    scale, translation = _scale_and_translation(moments, rotation)
    return Similarity(scale, rotation, translation)


def umeyama_ransac(
    source: Float[np.ndarray, "points 3"],
    target: Float[np.ndarray, "points 3"],
    tolerance: float,
    rng: np.random.Generator,
    iterations: int = 64,
    sample_size: int = 5,
) -> Similarity:
    """Umeyama on the largest set of points that agree within `tolerance` (target units), refitted on all of them."""
    best = np.zeros(len(source), bool)
    for _ in range(iterations):
        chosen = rng.choice(len(source), min(sample_size, len(source)), replace=False)
        candidate = umeyama(source[chosen], target[chosen])
        inliers = np.linalg.norm(candidate.apply(source) - target, axis=-1) < tolerance
        if inliers.sum() > best.sum():
            best = inliers
    if best.sum() < sample_size:
        return umeyama(source, target)
    return umeyama(source[best], target[best])


def closest_gauge(
    rotation: Float[np.ndarray, "3 3"], reference: Float[np.ndarray, "3 3"]
) -> Float64[np.ndarray, "3 3"]:
    """Turn a rotation about its own y axis until it is as close to `reference` as it can be.

    A symmetric object that is reported in this gauge does not spin.
    """
    return np.asarray(rotation @ rotation_about_axis(np.swapaxes(rotation, -1, -2) @ reference, Y))


def rotation_about_axis(rotation: Float[np.ndarray, "3 3"], axis: Float[np.ndarray, "3"]) -> Float64[np.ndarray, "3 3"]:
    """The rotation about `axis` nearest to `rotation` in the Frobenius norm: the paper's Rot. Proj."""
    return axis_angle(axis, angle_about_axis(rotation, axis))


def angle_about_axis(rotation: Float[np.ndarray, "3 3"], axis: Float[np.ndarray, "3"]) -> float:
    """Signed angle, radians, of the rotation about `axis` nearest to `rotation`: it maximizes tr(Rᵀ R(axis, θ))."""
    a = np.asarray(axis, np.float64) / np.linalg.norm(axis)
    r = np.asarray(rotation, np.float64)
    vector = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    return float(np.arctan2(a @ vector, np.trace(r) - a @ r @ a))

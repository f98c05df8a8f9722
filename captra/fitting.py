"""Closed-form fits: means of rotations, similarity between coordinates and points, the symmetric gauge, joint axes."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

from captra.geometry import axis_angle, project_to_rotation, rotation_from_axis

Y = np.array([0.0, 1.0, 0.0])


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


def mean_rotation(rotations: Float[np.ndarray, "points 3 3"]) -> Float64[np.ndarray, "3 3"]:
    """Euclidean mean: the arithmetic mean projected back onto SO(3) (appendix "Euclidean Mean of Rotations")."""
    return project_to_rotation(np.asarray(rotations, np.float64).mean(axis=0))


def mean_axis_rotation(rotations: Float[np.ndarray, "points 3 3"]) -> Float64[np.ndarray, "3 3"]:
    """Mean for objects symmetric about y: the normalized mean of the y axes, in the gauge of `rotation_from_axis`."""
    return rotation_from_axis(np.asarray(rotations, np.float64)[:, :, 1].mean(axis=0))


def scale_and_translation(
    rotated: Float[np.ndarray, "points 3"], points: Float[np.ndarray, "points 3"]
) -> tuple[float, Float64[np.ndarray, "3"]]:
    """Least-squares s and t of points ≈ s · rotated + t, both sets centred first.

    Source: appendix "Scale and Translation Computation".
    """
    w, c = np.asarray(rotated, np.float64), np.asarray(points, np.float64)
    w_centred, c_centred = w - w.mean(axis=0), c - c.mean(axis=0)
    scale = float(np.sum(w_centred * c_centred) / np.maximum(np.sum(w_centred * w_centred), 1e-12))
    return scale, (c - scale * w).mean(axis=0)


def symmetric_alignment(
    coordinates: Float[np.ndarray, "points 3"], points: Float[np.ndarray, "points 3"]
) -> Float64[np.ndarray, "3 3"]:
    """The rotation about y that best turns `coordinates` onto `points`, both in the object's axes.

    2D Umeyama in the xz-plane (appendix "Scale and Translation Computation").
    """
    x, z = (np.asarray(coordinates, np.float64) - np.mean(coordinates, axis=0))[:, [0, 2]].T
    u, w = (np.asarray(points, np.float64) - np.mean(points, axis=0))[:, [0, 2]].T
    return axis_angle(Y, np.arctan2(np.sum(u * z - w * x), np.sum(u * x + w * z)))


def umeyama(source: Float[np.ndarray, "points 3"], target: Float[np.ndarray, "points 3"]) -> Similarity:
    """Least-squares similarity target ≈ s R source + t (Umeyama 1991)."""
    x, y = np.asarray(source, np.float64), np.asarray(target, np.float64)
    x_mean, y_mean = x.mean(axis=0), y.mean(axis=0)
    rotation = project_to_rotation((y - y_mean).T @ (x - x_mean))
    scale, translation = scale_and_translation(x @ rotation.T, y)
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

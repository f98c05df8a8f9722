"""Poses around the truth, as a tracker would have them from the frame before (paper, "Training Data Generation")."""

from dataclasses import dataclass

import numpy as np

from captra.categories import Category
from captra.geometry import Pose, axis_angle

FULL_TURN = 2 * np.pi


@dataclass(frozen=True)
class PerturbationMix:
    """How the paper's Gaussians are widened and narrowed, so that a track neither drifts near the truth nor breaks away from it."""

    spreads: tuple[float, ...] = (0.3, 1.0, 1.0, 1.6)
    """Factors on all three standard deviations; one is drawn per pose."""
    wide_axis: tuple[float, float, float] | None = None
    """Object axis about which rotation is weakly observed and is perturbed further; None for none."""
    wide_angle_deg: float = 15.0
    """Standard deviation of that further rotation."""
    wide_share: float = 0.6
    """Share of poses that receive it."""
    aspect: float = 0.05
    """Relative standard deviation of each side of the box: a tracked box is never exact."""

    @staticmethod
    def for_category(category: Category) -> "PerturbationMix":
        """Widened about y for the upright objects that one small feature orients."""
        upright = category.background and not category.symmetric
        return PerturbationMix(wide_axis=(0.0, 1.0, 0.0) if upright else None)


def random_direction(rng: np.random.Generator) -> np.ndarray:
    """A unit vector, uniform on the sphere."""
    vector = rng.standard_normal(3)
    return np.asarray(vector / np.linalg.norm(vector))


def perturb(truth: Pose, category: Category, rng: np.random.Generator, spread: float = 1.0) -> Pose:
    """s' = s (1 + n_s), R' = R R_rand, T' = T + n_T per part, all standard deviations times `spread`."""
    sigma = category.perturbation
    factor = 1 + np.clip(rng.normal(0, sigma.scale * spread, truth.num_parts), -0.5, 0.5)
    angles = np.radians(rng.normal(0, sigma.rotation_deg * spread, truth.num_parts))
    turns = np.stack([axis_angle(random_direction(rng), angle) for angle in angles])
    lengths = rng.normal(0, sigma.translation_m * spread, truth.num_parts)
    offsets = np.stack([length * random_direction(rng) for length in lengths])
    return Pose(
        rotation=truth.rotation @ turns,
        translation=truth.translation + offsets,
        scale=truth.scale * factor,
        size=truth.size * factor[:, None],
    )


def perturb_for_training(truth: Pose, category: Category, mix: PerturbationMix, rng: np.random.Generator) -> Pose:
    """A perturbed pose from the widened mixture; a symmetric object is also turned freely about its axis."""
    pose = perturb(truth, category, rng, spread=float(rng.choice(mix.spreads)))
    turn = np.eye(3)
    if category.symmetric:
        turn = axis_angle(np.array([0.0, 1.0, 0.0]), rng.uniform(0, FULL_TURN))
    elif mix.wide_axis is not None and rng.random() < mix.wide_share:
        turn = axis_angle(np.array(mix.wide_axis), np.radians(rng.normal(0, mix.wide_angle_deg)))
    size = pose.size * np.clip(1 + rng.normal(0, mix.aspect, pose.size.shape), 0.7, 1.4)
    return Pose(pose.rotation @ turn, pose.translation, pose.scale, size)

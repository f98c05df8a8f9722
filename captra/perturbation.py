"""Poses around the truth, as a tracker would have them from the frame before (paper, "Training Data Generation")."""

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.geometry import Pose, axis_angle


def random_direction(rng: np.random.Generator) -> Float64[np.ndarray, "3"]:
    """A unit vector, uniform on the sphere."""
    vector = rng.standard_normal(3)
    return np.asarray(vector / np.linalg.norm(vector))


def perturb(truth: Pose, category: Category, rng: np.random.Generator, spread: float = 1.0) -> Pose:
    """S' = s (1 + n_s), R' = R R_rand, T' = T + n_T per part, all standard deviations times `spread`."""
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

"""Clouds to compare networks on: partial views of boxes and what surrounds them, made up from a seed."""

import numpy as np
from jaxtyping import Float32

from captra.sampling import Profile, farthest_points


def made_up_clouds(parts: int, profile: Profile, seed: int = 0) -> Float32[np.ndarray, "parts N 3"]:
    """Canonical clouds of several parts, each in the same farthest-point order: three faces of a box, and a table."""
    rng = np.random.default_rng(seed)
    count = 2 * profile.points
    faces = rng.uniform(-0.5, 0.5, (count, 3))
    faces[np.arange(count), rng.integers(3, size=count)] = 0.5
    table = rng.uniform(-0.7, 0.7, (count // 2, 3)) * [1, 0, 1] - [0, 0.3, 0]
    scene = np.concatenate([faces * rng.uniform(0.3, 0.7, 3), table]) + rng.normal(0, 0.005, (count + count // 2, 3))
    scene = scene.astype(np.float32)
    points = scene[farthest_points(scene, profile.points)]
    shifts = rng.normal(0, 0.1, (parts, 1, 3)).astype(np.float32)
    return np.ascontiguousarray(points[None] + shifts)

"""Means and products of two lists of corresponding points: all that the closed-form fits need to know of them."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

from captra.compiled import compiled


@dataclass(frozen=True, eq=False)
class Moments:
    """Of source and target points, in their own units."""

    source_mean: Float64[np.ndarray, "3"]
    """Mean of the source points."""
    target_mean: Float64[np.ndarray, "3"]
    """Mean of the target points."""
    products: Float64[np.ndarray, "3 3"]
    """Sum over points of target · sourceᵀ, both centred."""
    source_square: float
    """Sum over points of the squared length of the source, centred."""

    @staticmethod
    def of(source: Float[np.ndarray, "points 3"], target: Float[np.ndarray, "points 3"]) -> "Moments":
        """Sum up, in double precision; not a number without any points."""
        return Moments(*_moments(doubles(source), doubles(target)))


def doubles(values: Float[np.ndarray, "*shape"]) -> Float64[np.ndarray, "*shape"]:
    """In the one form that kernels are compiled for."""
    return np.ascontiguousarray(values, np.float64)


def warm_up() -> None:
    """Compile or load the kernel."""
    Moments.of(np.zeros((1, 3)), np.zeros((1, 3)))


@compiled
def _moments(
    source: Float64[np.ndarray, "points 3"], target: Float64[np.ndarray, "points 3"]
) -> tuple[Float64[np.ndarray, "3"], Float64[np.ndarray, "3"], Float64[np.ndarray, "3 3"], float]:
    source_mean, target_mean, products, square = np.zeros(3), np.zeros(3), np.zeros((3, 3)), 0.0
    for i in range(len(source)):
        for axis in range(3):
            source_mean[axis] += source[i, axis]
            target_mean[axis] += target[i, axis]
    count = len(source) if len(source) > 0 else np.nan
    source_mean, target_mean = source_mean / count, target_mean / count
    for i in range(len(source)):
        for column in range(3):
            centred = source[i, column] - source_mean[column]
            square += centred * centred
            for row in range(3):
                products[row, column] += (target[i, row] - target_mean[row]) * centred
    return source_mean, target_mean, products, square

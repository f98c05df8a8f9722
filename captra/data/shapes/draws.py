"""Small vocabulary for drawing shape parameters."""

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

Option = TypeVar("Option")


def between(rng: np.random.Generator, low: float, high: float) -> float:
    """Uniform in [low, high]."""
    return float(rng.uniform(low, high))


def chance(rng: np.random.Generator, probability: float) -> bool:
    """True with this probability."""
    return bool(rng.random() < probability)


def pick(rng: np.random.Generator, options: Sequence[tuple[float, Option]]) -> Option:
    """One of several options, by weight."""
    weights = np.array([weight for weight, _ in options])
    return options[int(rng.choice(len(options), p=weights / weights.sum()))][1]

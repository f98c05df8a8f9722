"""States of joints: drawn for single views, moving for sequences."""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.draws import between, pick
from captra.data.shapes.shape import Shape

AVERAGE_CHANGE: Mapping[str, float] = MappingProxyType(
    {
        "glasses": float(np.radians(19.19)),
        "scissors": float(np.radians(34.32)),
        "laptop_articulated": float(np.radians(26.13)),
        "drawers": 0.0372,
    }
)
"""Average change of each joint within 100 frames, rad or m (paper, Table "Statistics")."""
FRAMES = 100


def draw_joint_values(shape: Shape, rng: np.random.Generator) -> Float64[np.ndarray, " J"]:
    """Anywhere in the range, all joints alike, or some of them at their end nearest to rest."""
    count = len(shape.joint_limits)
    if count == 0:
        return np.zeros(0)
    rest, far = _ends(shape)
    kind = pick(rng, ((5, "any"), (2, "alike"), (2, "some")))
    share = np.full(count, rng.random()) if kind == "alike" else rng.random(count)
    if kind == "some":
        share *= rng.random(count) < 0.5
    return np.asarray(rest + share * (far - rest))


def _ends(shape: Shape) -> tuple[Float64[np.ndarray, " J"], Float64[np.ndarray, " J"]]:
    """Limits nearest to rest and farthest from it."""
    limits = shape.joint_limits.astype(np.float64)
    order = np.argsort(np.abs(limits), axis=1)
    near, far = np.take_along_axis(limits, order, axis=1).T
    return near, far


def draw_joint_path(shape: Shape, frames: int, rng: np.random.Generator) -> Float64[np.ndarray, "F J"]:
    """Joints that swing smoothly; within 100 frames each changes by 0.5 to 1.5 times the paper's average."""
    columns = [_swing(shape.category, low, high, frames, rng) for low, high in shape.joint_limits.astype(np.float64)]
    return np.stack(columns, axis=-1) if columns else np.zeros((frames, 0))


def _swing(category: str, low: float, high: float, frames: int, rng: np.random.Generator) -> Float64[np.ndarray, " F"]:
    change = min(AVERAGE_CHANGE[category] * between(rng, 0.5, 1.5), 0.95 * (high - low))
    phase, turns = between(rng, 0, 2 * np.pi), between(rng, 0.3, 0.9)

    def wave(at: Float64[np.ndarray, " F"]) -> Float64[np.ndarray, " F"]:
        return np.asarray(np.sin(phase + 2 * np.pi * turns * at / FRAMES))

    once = wave(np.arange(FRAMES))
    gain = change / float(np.ptp(once))
    path = gain * wave(np.arange(frames))
    smallest, largest = low - float(path.min()), high - float(path.max())
    if smallest > largest:  # a longer sequence swings further than the first 100 frames do
        path *= (high - low) / float(np.ptp(path))
        smallest = largest = low - float(path.min())
    return np.asarray(path + between(rng, smallest, largest)).clip(low, high)

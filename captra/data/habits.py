"""How objects of a category are met: how they rest, how they are looked at and held, what is near or in them."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np

from captra.data.shapes.draws import between, chance

Rest = Literal["upright", "upside down", "lying", "leaning"]
Resting = tuple[tuple[float, Rest], ...]


def mostly_upright(weight: float) -> Resting:
    """Weights of how an object rests, upright having this one."""
    return ((weight, "upright"), (0.8, "upside down"), (2.2, "lying"), (0.8, "leaning"))


USUAL = mostly_upright(6.2)


@dataclass(frozen=True)
class Habits:
    """Weights and probabilities that scenes are drawn by."""

    resting: Resting = USUAL
    """How it stands or lies."""
    facing: float = 0.0
    """Share seen more or less from their front (+z); the others from any side."""
    held: float = 1.0
    """Factor of how often a hand holds it."""
    tumbled: float = 0.6
    """Share of held objects that are held at any orientation; the others upright, more or less."""
    contents: float = 0.0
    """How often something lies in or on it while it is upright."""
    neighbours: tuple[str, ...] = ("bottle", "mug")
    """Categories whose instances may stand around."""

    def yaw(self, rng: np.random.Generator) -> float:
        """Angle about y, rad: 0 faces the camera."""
        if self.facing > 0 and chance(rng, self.facing):
            return float(np.radians(rng.normal(0, 45)))
        return between(rng, 0, 2 * np.pi)


_ALL_RIGID = ("bottle", "bowl", "camera", "can", "laptop", "mug")

HABITS: Mapping[str, Habits] = MappingProxyType(
    {
        "bowl": Habits(
            resting=((7.2, "upright"), (1.2, "upside down"), (0.8, "lying"), (0.8, "leaning")),
            contents=0.3,
            neighbours=_ALL_RIGID,
        ),
        "camera": Habits(neighbours=_ALL_RIGID),
        "can": Habits(neighbours=_ALL_RIGID),
        "laptop": Habits(
            resting=((9.0, "upright"), (0.2, "upside down"), (0.5, "lying"), (0.5, "leaning")),
            held=0.45,
            contents=0.08,
            neighbours=_ALL_RIGID,
        ),
        "glasses": Habits(facing=0.3),
        "laptop_articulated": Habits(mostly_upright(12.0), facing=0.6, tumbled=0.35),
        "drawers": Habits(mostly_upright(40.0), facing=0.75, tumbled=0.15),
    }
)


def habits_of(category: str) -> Habits:
    """Habits of a category; the usual ones if it has none of its own."""
    return HABITS.get(category, Habits())

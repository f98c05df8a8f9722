"""Whether points tell an object's turn about its y axis: a can has none, and a mug's is told by its handle alone."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

from captra.categories import Category
from captra.geometry import rotation_angle

HANDLE_CLEARANCE = 0.02
"""How far a mug's handle stands out beyond its body, in canonical units, before a point counts as its."""

TELLING_SHARE = 0.03
"""Share of a mug's points on the handle that tells the turn as well as it can be told."""


@dataclass(frozen=True)
class Turn:
    """How much of a part's turn about y there is to know, and to see."""

    known: float
    """How far a turn counts when rotations are compared: not at all where there is none or none to be seen."""
    guessed: float
    """How far it is guesswork: 0 for objects without one, and for those that show it."""

    @staticmethod
    def seen(coordinates: Float[np.ndarray, "points 3"], aspect: Float[np.ndarray, "3"], category: Category) -> "Turn":
        """What the points of a part tell of its turn.

        A mug's body is as wide in x as its box is in z and touches the box's −x side; what stands out towards +x is its
        handle.

        Args:
            coordinates: normalized coordinates of the points, as CoordinateNet gives them.
            aspect: sides of the part's box in units of its scale.
            category: of the object.
        """
        if category.symmetric:
            return Turn(0.0, 0.0)
        if category.name != "mug":
            return Turn(1.0, 0.0)
        on_handle = coordinates[:, 0] > aspect[2] - aspect[0] / 2 + HANDLE_CLEARANCE
        known = min(1.0, float(on_handle.mean()) / TELLING_SHARE)
        return Turn(known, 1 - known)


def angle_between(a: Float64[np.ndarray, "3 3"], b: Float64[np.ndarray, "3 3"], turn: Turn) -> float:
    """Angle between two rotations, radians, of which the turn about y counts as far as it is known."""
    tilt = float(np.arctan2(np.linalg.norm(np.cross(a[:, 1], b[:, 1])), a[:, 1] @ b[:, 1]))
    return tilt + turn.known * (float(rotation_angle(a.T @ b)) - tilt) if turn.known else tilt

"""Where to look while a track does not hold: where it was last found, and around the last pose that was trusted."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from jaxtyping import Float64

from captra.geometry import Pose, axis_angle
from captra.health import State

REACH_M = 0.06
"""Length of the first shifts around the trusted pose; a look finds what is some 4 cm away from where it looks."""

TURN_RAD = np.radians(15.0)
"""Angle of the turns that go with them."""

START_REACH = 4 / 3
"""Length of the shifts around a given pose, in units of the standard deviation of its centre."""

STARTS_A_LOOK = 4
"""Shifts around a given pose for every look that a later frame may take: a first frame is worth waiting for."""

SAME_PLACE = 0.1
"""Centres this near each other, in units of the object's scale, are the same finding."""

FEWEST_LOOKS, MOST_LOOKS = 2, 8
"""What a search may take a frame: one look would never go anywhere but where the object was lost."""


def most_agreed(told: Float64[np.ndarray, " N"], centres_m: Float64[np.ndarray, "N 3"], scale_m: float) -> int:
    """The surest of the poses that most confidence gathers around: wrong ones lie here and there, right ones together.

    Args:
        told: confidence of each pose by itself.
        centres_m: where each has the object.
        scale_m: of the object.
    """
    near = np.linalg.norm(centres_m[:, None] - centres_m, axis=-1) <= SAME_PLACE * scale_m
    return int(np.argmax(np.where(near[np.argmax(near @ told)], told, -1.0)))


class SearchBudget(Protocol):
    """How many looks a frame may take."""

    def looks(self) -> int:
        """At most so many; at least one."""

    def spent(self, milliseconds: float) -> None:
        """One look took so long."""


@dataclass(frozen=True)
class LookBudget:
    """A fixed number of looks, on any machine; one look is no search at all."""

    count: int = 4
    """Looks a frame."""

    def looks(self) -> int:
        """At most so many."""
        return self.count

    def spent(self, milliseconds: float) -> None:
        """Time does not matter."""


class TimeBudget:
    """As many looks as fit into some milliseconds, by how long they took so far: two at least, eight at most."""

    def __init__(self, budget_ms: float) -> None:
        self._budget_ms = budget_ms
        self._look_ms: float | None = None

    def looks(self) -> int:
        """At most so many; the fewest before the first is timed."""
        if self._look_ms is None:
            return FEWEST_LOOKS
        return int(np.clip(self._budget_ms / self._look_ms, FEWEST_LOOKS, MOST_LOOKS))

    def spent(self, milliseconds: float) -> None:
        """Go along slowly, so that one slow look changes little."""
        self._look_ms = milliseconds if self._look_ms is None else 0.8 * self._look_ms + 0.2 * milliseconds


NO_SEARCH: SearchBudget = LookBudget(1)


def _directions() -> Float64[np.ndarray, "14 3"]:
    """Faces and corners of a cube, as unit vectors, opposite ones in turn."""
    faces = np.concatenate([np.eye(3), -np.eye(3)])
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / np.sqrt(3)
    return np.concatenate([faces, corners])


@dataclass(frozen=True)
class Search:
    """What is known of an object that may be lost."""

    trusted: Pose
    """The last pose that was worth going back to."""
    turn: int = 0
    """Where in the round of shifts the search stands."""

    def starts(self, given_error_m: float, looks: int) -> Iterator[Pose]:
        """Where to look for an object whose pose was given: there, and if there may be a search also beside it.

        Args:
            given_error_m: standard deviation of the centre of a given pose.
            looks: what a later frame might take; one means no search.
        """
        yield self.trusted
        if looks > 1:
            for shift in START_REACH * given_error_m * _directions()[: STARTS_A_LOOK * looks]:
                yield replace(self.trusted, translation=self.trusted.translation + shift)

    def hypotheses(self, expected: Pose, state: State, looks: int) -> tuple[Pose, ...]:
        """Poses to look around, most promising first, at most `looks` of them."""
        if state is State.TRACKING:
            return (expected,)
        if state is State.UNCERTAIN:
            return (expected, self.trusted)[:looks]
        shifted = [self._shifted(self.turn + i) for i in range(max(0, looks - 2))]
        return (expected, self.trusted, *shifted)[:looks]

    def updated(self, pose: Pose, state: State, looks: int) -> "Search":
        """The search after one more frame."""
        if state is State.TRACKING:
            return Search(pose)
        return replace(self, turn=self.turn + max(0, looks - 2))

    def _shifted(self, index: int) -> Pose:
        """The trusted pose elsewhere and turned; rounds go outwards."""
        directions = _directions()
        direction = directions[index % len(directions)]
        axis = directions[(3 * index + 1) % len(directions)]
        reach = REACH_M * (1 + 0.5 * ((index // len(directions)) % 3))
        angle = TURN_RAD * (index % 3 - 1)
        pose = self.trusted
        centre = pose.translation.mean(axis=0)
        rotation = axis_angle(axis, angle)
        moved = (pose.translation - centre) @ rotation.T + centre + reach * direction
        return replace(pose, rotation=rotation @ pose.rotation, translation=moved)

"""A part fills its box: how far it is turned in it is told by how far its points reach.

How much a temple splays at rest, or how far a blade leans to its side, is a convention that no point shows: networks
guess it. The given box knows, since it is wide where the part lies across it, and narrow where it lies along it.
"""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Float64

from captra.categories import Category
from captra.containment import FEWEST_POINTS, reach
from captra.evidence import Evidence
from captra.geometry import Pose, rotation_vector
from captra.pose_memory import USUAL_ERROR, FoundError, PoseMemory, given_rotation_error_rad

TURNS: Float64[np.ndarray, " turns"] = np.linspace(-4, 4, 33)
"""Those that are compared, in standard deviations of the networks' error."""

MOST_POINTS = 400
"""Of a part, remembered from many frames: one alone rarely sees both ends."""

NEWEST_POINTS = 20
"""Of one frame, once there are enough."""

STRAYS = 0.01
"""Share of points, at either end of an axis, that may be strays."""

TOO_FAR_ERROR, NOT_FAR_ENOUGH_ERROR = 0.01, 0.02
"""Standard deviations of how far a part's points reach, in units of its scale: sides that are not seen are missing."""

LEAST_LIKELY = -10.0
"""Logarithm: points that reach too far or not far enough by much are hidden, or not the part's, and tell nothing."""


@dataclass(frozen=True)
class BoxTurns:
    """How far each part that turns on a joint is turned about its axis, beyond what the networks find."""

    axes: tuple[int | None, ...]
    """Of every part: 0, 1 or 2 for x, y or z of its own frame; none for parts that are not asked about."""
    turns_rad: Float64[np.ndarray, "parts turns"]
    """Those that are compared."""
    log_prior: Float64[np.ndarray, "parts turns"]
    """What the networks' errors and the given pose say of each."""
    points_part: tuple[Float64[np.ndarray, "remembered 3"], ...]
    """Of every part, metres, in its frame as found: the oldest first."""

    @staticmethod
    def nothing_known(num_parts: int) -> "BoxTurns":
        """Boxes have no say."""
        nothing = np.zeros((num_parts, len(TURNS)))
        return BoxTurns((None,) * num_parts, nothing, nothing, (np.zeros((0, 3)),) * num_parts)

    @staticmethod
    def between(given: Pose, found: Pose, category: Category, error: FoundError = USUAL_ERROR) -> "BoxTurns":
        """From a given pose and where the networks find the object at the same time, before any box has a say.

        An error of the given pose may be much larger than usual (Cauchy), one of the networks may not.
        """
        known = BoxTurns.nothing_known(category.num_parts)
        axes, turns_rad, log_prior = _joint_axes(category), known.turns_rad.copy(), known.log_prior.copy()
        found_error_rad = np.radians(np.broadcast_to(error.rotation_deg, (category.num_parts, 3)))
        given_error_rad = given_rotation_error_rad(category) / np.sqrt(3)
        difference = rotation_vector(np.swapaxes(found.rotation, -1, -2) @ given.rotation)
        for part, axis in enumerate(axes):
            if axis is not None:
                turns_rad[part] = found_error_rad[part, axis] * TURNS
                beside_given = (turns_rad[part] - difference[part, axis]) / given_error_rad
                log_prior[part] = -np.square(TURNS) / 2 - np.log1p(np.square(beside_given) / 2)
        return replace(known, axes=axes, turns_rad=turns_rad, log_prior=log_prior)

    def updated(self, found: Pose, evidence: Evidence) -> "BoxTurns":
        """After one more frame, which found the parts there."""
        remembered = [
            points if axis is None else _remember(points, (part.explained - centre) @ rotation)
            for axis, points, part, centre, rotation in zip(
                self.axes, self.points_part, evidence.parts, found.translation, found.rotation, strict=True
            )
        ]
        return replace(self, points_part=tuple(remembered))

    def refine(self, memory: PoseMemory, size: Float64[np.ndarray, "parts 3"]) -> PoseMemory:
        """What is remembered, with the turns about joints' axes that also fill boxes of that size."""
        turn_part = np.array(memory.turn_part)
        for part, (axis, points) in enumerate(zip(self.axes, self.points_part, strict=True)):
            if axis is not None and len(points) >= FEWEST_POINTS:
                turns_rad = self.turns_rad[part]
                likely = self.log_prior[part] + _log_likelihood(turns_rad, points, size[part], axis)
                weights = np.exp(likely - likely.max())
                turn_part[part, axis] = weights @ turns_rad / weights.sum()
        return replace(memory, turn_part=turn_part)


def _joint_axes(category: Category) -> tuple[int | None, ...]:
    """Which of its own axes every part turns about, on whichever side of a joint it is."""
    axes: list[int | None] = [None] * category.num_parts
    for joint in category.joints:
        if joint.kind == "revolute":
            axes[joint.child] = axes[joint.parent] = int(np.argmax(np.abs(joint.axis)))
    return tuple(axes)


def _remember(
    remembered: Float[np.ndarray, "remembered 3"], seen: Float[np.ndarray, "seen 3"]
) -> Float64[np.ndarray, "kept 3"]:
    """Points of many frames: as many as there is room for, and a few of each frame from then on."""
    room = max(MOST_POINTS - len(remembered), NEWEST_POINTS)
    chosen = np.linspace(0, len(seen) - 1, min(room, len(seen))).astype(int)
    return np.concatenate([remembered, seen[chosen]])[-MOST_POINTS:]


def _log_likelihood(
    turns_rad: Float64[np.ndarray, " turns"],
    points_part: Float[np.ndarray, "points 3"],
    size: Float[np.ndarray, "3"],
    axis: int,
) -> Float64[np.ndarray, " turns"]:
    """Of turns of the frame about `axis`, from how far the points reach along the two others."""
    first, second = (axis + 1) % 3, (axis + 2) % 3
    cos, sin = np.cos(turns_rad)[:, None], np.sin(turns_rad)[:, None]
    x, y = points_part[:, first], points_part[:, second]
    scale = float(np.linalg.norm(size))
    likely = np.zeros(len(turns_rad))
    for side, coordinates in ((first, cos * x + sin * y), (second, cos * y - sin * x)):
        start, end = reach(coordinates, STRAYS)
        likely += _log_reach((end - start - size[side]) / scale)
    return likely


def _log_reach(beyond: Float[np.ndarray, " turns"]) -> Float64[np.ndarray, " turns"]:
    """From how far points reach beyond a box, in units of the scale; below zero if they stay inside."""
    deviations = beyond / np.where(beyond > 0, TOO_FAR_ERROR, NOT_FAR_ENOUGH_ERROR)
    return np.asarray(np.maximum(-np.square(deviations) / 2, LEAST_LIKELY))

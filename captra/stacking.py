"""Drawers lie inside their cabinet, one above the other, and never in each other.

Fronts look alike, and networks that mistake one for its neighbour find both in the same place; where the given pose is
only a little off, the boxes tell who is who.
"""

from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.geometry import Pose
from captra.joints import offset_from_parent
from captra.pose_memory import USUAL_ERROR, FoundError

ACROSS, UP = 0, 1
"""Axes of the parent: its width and its height."""

SWEEPS = 20
"""How often neighbours push each other apart, since who makes way may be pushed against the next."""

MOST_ERRORS = 4
"""How many standard deviations the networks may err by."""

SMALLEST_DOUBT_M = 0.01
"""Of where a part was found: no two agree better than that with a given pose."""


def stacked(found: Pose, given: Pose, category: Category, error: FoundError = USUAL_ERROR) -> Pose:
    """What was found, with parts on slides moved, as little as need be, into their parent and out of each other.

    Parts come in the order of their joints, from the lowest; of two that overlap the one found further from where it
    was given makes way. What the given pose already has outside, or overlapping, may stay so, and nothing moves
    further than the networks may err.
    """
    most = MOST_ERRORS * np.broadcast_to(error.centre, (category.num_parts, 3)) * found.scale[:, None]
    translation = np.array(found.translation)
    for parent in {slide.parent for slide in category.slides}:
        slides = [slide for slide in category.slides if slide.parent == parent]
        children = [slide.child for slide in slides]
        offset, expected = (np.stack([offset_from_parent(one, pose) for one in slides]) for pose in (found, given))
        room = np.maximum((found.size[parent] - found.size[children]) / 2, np.abs(expected))
        height = found.size[children, UP]
        distance = np.minimum((height[1:] + height[:-1]) / 2, np.diff(expected[:, UP]))
        doubt = np.square(offset[:, UP] - expected[:, UP]) + SMALLEST_DOUBT_M**2
        apart = np.array(offset)
        apart[:, ACROSS] = np.clip(offset[:, ACROSS], -room[:, ACROSS], room[:, ACROSS])
        apart[:, UP] = _pushed_apart(offset[:, UP], distance, room[:, UP], doubt)
        shift = np.clip(apart - offset, -most[children], most[children])
        translation[children] += shift @ found.rotation[parent].T
    return replace(found, translation=translation)


def _pushed_apart(
    middle: Float64[np.ndarray, " stack"],
    distance: Float64[np.ndarray, " gaps"],
    room: Float64[np.ndarray, " stack"],
    doubt: Float64[np.ndarray, " stack"],
) -> Float64[np.ndarray, " stack"]:
    """Middles pushed at least `distance` from the next, and each at most `room` from zero; the doubted move most."""
    apart = np.array(middle)
    for _ in range(SWEEPS):
        apart = np.clip(apart, -room, room)
        for lower, needed in enumerate(distance):
            pair = slice(lower, lower + 2)
            missing = max(needed - (apart[lower + 1] - apart[lower]), 0.0)
            apart[pair] += missing * doubt[pair] / doubt[pair].sum() * np.array([-1, 1])
    return np.asarray(np.clip(apart, -room, room))

"""Drawers lie inside their cabinet, one above the other, and never in each other.

Fronts look alike, and networks that mistake one for its neighbour find both in the same place; where the given pose is
only a little off, the boxes tell who is who.
"""

from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.geometry import Pose

ACROSS, UP = 0, 1
"""Axes of the parent: its width and its height."""

SWEEPS = 20
"""How often neighbours push each other apart, since who makes way may be pushed against the next."""

SMALLEST_DOUBT_M = 0.01
"""Of where a part was found: no two agree better than that with a given pose."""


def stacked(found: Pose, given: Pose, category: Category) -> Pose:
    """What was found, with parts on slides moved, as little as need be, into their parent and out of each other.

    Parts come in the order of their joints, from the lowest; of two that overlap the one found further from where it
    was given makes way. Those of other joints stay where they are.
    """
    translation = np.array(found.translation)
    for parent in {joint.parent for joint in category.joints if joint.kind == "prismatic"}:
        children = [joint.child for joint in category.joints if joint.parent == parent and joint.kind == "prismatic"]
        offset, expected = _offsets(found, parent, children), _offsets(given, parent, children)
        room = np.maximum(found.size[parent] - found.size[children], 0.0) / 2
        doubt = np.square(offset[:, UP] - expected[:, UP]) + SMALLEST_DOUBT_M**2
        apart = np.array(offset)
        apart[:, ACROSS] = np.clip(offset[:, ACROSS], -room[:, ACROSS], room[:, ACROSS])
        apart[:, UP] = _pushed_apart(offset[:, UP], found.size[children, UP], room[:, UP], doubt)
        translation[children] += (apart - offset) @ found.rotation[parent].T
    return replace(found, translation=translation)


def _offsets(pose: Pose, parent: int, children: list[int]) -> Float64[np.ndarray, "children 3"]:
    """From the parent's centre to those of its children, in its own frame."""
    return np.asarray((pose.translation[children] - pose.translation[parent]) @ pose.rotation[parent])


def _pushed_apart(
    middle: Float64[np.ndarray, " stack"],
    height: Float64[np.ndarray, " stack"],
    room: Float64[np.ndarray, " stack"],
    doubt: Float64[np.ndarray, " stack"],
) -> Float64[np.ndarray, " stack"]:
    """Middles of intervals that overlap less and less, each at most `room` from zero; the most doubted move most."""
    apart = np.array(middle)
    for _ in range(SWEEPS):
        apart = np.clip(apart, -room, room)
        for lower in range(len(apart) - 1):
            pair = slice(lower, lower + 2)
            overlap = height[pair].sum() / 2 - (apart[lower + 1] - apart[lower])
            apart[pair] += max(overlap, 0.0) * doubt[pair] / doubt[pair].sum() * np.array([-1, 1])
    return np.clip(apart, -room, room)

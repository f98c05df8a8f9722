"""An object is inside its box: poses whose box leaves points outside move until it holds them.

Coordinates of what a camera sees of a box say little of how far it reaches where nothing is seen: the front of a drawer
looks the same however deep the drawer is. At a size that is known, the points alone tell where the box can be.
"""

from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float, Float64

from captra.categories import Category
from captra.evidence import Evidence
from captra.geometry import Pose

FEWEST_POINTS = 20
"""Fewer say nothing of where a box ends."""

STRAYS = 0.005
"""Share of points, at either end of each axis, that may be strays of an object that comes alone."""

STRAYS_OF_SCENES = 0.02
"""Likewise of one that is told from its surroundings by the networks."""

TIGHT = 0.015
"""In units of the scale: a box is filled from side to side by points that reach as far as its side is long, within
this."""


def contained(pose: Pose, evidence: Evidence, category: Category) -> Pose:
    """The pose with every part's box moved, as little as need be, to hold the points that its fit explains."""
    strays = STRAYS_OF_SCENES if category.background else STRAYS
    shifts = [_shift(points, size, strays) for points, size in zip(_own_points(pose, evidence), pose.size, strict=True)]
    moved = np.einsum("pij,pj->pi", pose.rotation, np.stack(shifts))
    return replace(pose, translation=pose.translation + moved)


def filled(pose: Pose, evidence: Evidence) -> Bool[np.ndarray, "parts 3"]:
    """Along which of its axes each part reaches from side to side of its box, which then can be nowhere else."""
    return np.stack([_fills(points, size) for points, size in zip(_own_points(pose, evidence), pose.size, strict=True)])


def _own_points(pose: Pose, evidence: Evidence) -> list[Float[np.ndarray, "points 3"]]:
    """What the fit explains of every part, metres, in the part's frame."""
    return [
        (part.explained - centre) @ rotation
        for part, centre, rotation in zip(evidence.parts, pose.translation, pose.rotation, strict=True)
    ]


def _fills(points_part: Float[np.ndarray, "points 3"], size: Float64[np.ndarray, "3"]) -> Bool[np.ndarray, "3"]:
    if len(points_part) < FEWEST_POINTS:
        return np.zeros(3, bool)
    first, last = reach(points_part.T, STRAYS)
    return np.asarray(np.abs(last - first - size) < TIGHT * np.linalg.norm(size))


def _shift(
    points_part: Float[np.ndarray, "points 3"], size: Float64[np.ndarray, "3"], strays: float
) -> Float64[np.ndarray, "3"]:
    """How far to move a centred box along its own axes; points that reach further than it end up around its middle."""
    if len(points_part) < FEWEST_POINTS:
        return np.zeros(3)
    first, last = reach(points_part.T, strays)
    ends = last - size / 2, first + size / 2
    return np.asarray(np.clip(0.0, np.minimum(*ends), np.maximum(*ends)))


def reach(
    coordinates: Float[np.ndarray, "rows points"], strays: float
) -> tuple[Float[np.ndarray, " rows"], Float[np.ndarray, " rows"]]:
    """The first and the last coordinate of every row, where a share `strays` of them at either end does not count."""
    left_out, last = int(strays * coordinates.shape[1]), coordinates.shape[1] - 1
    ordered = np.partition(coordinates, (left_out, last - left_out), axis=1)
    return ordered[:, left_out], ordered[:, last - left_out]

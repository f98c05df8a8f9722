"""Where a drawer's front is seen, the drawer is behind it.

Coordinates of a drawer err by centimetres along its slide, since nothing that is seen of it tells how deep it is; how
deep it is was given, and its front, or the handle on it, is where the points end.
"""

from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category, Joint
from captra.containment import FEWEST_POINTS, STRAYS, reach
from captra.evidence import Evidence
from captra.geometry import Pose
from captra.joints import offset_from_parent
from captra.pose_memory import PoseMemory

FURTHEST = 0.04
"""In units of the scale: points that end further from where the front is expected end at something else."""

THICKNESS = 0.06
"""In units of the scale: how far behind the handle's end the front itself may be."""

LEAST_SPAN = 0.5
"""Of the box's sides: points that end with less of a front are cut off by something before them."""

MOST_SLANTED = 0.02
"""Sine of the angle between the front and the ray to its middle, below which the front is not seen."""

FASTEST = 0.01
"""In units of the scale: a front that moves back by more between two frames has rather lost its handle from sight."""

DOUBT = 0.2
"""How far to follow it nevertheless."""


def behind_fronts(memory: PoseMemory, pose: Pose, last: Pose, evidence: Evidence, category: Category) -> PoseMemory:
    """The memory with every drawer whose front a frame shows behind it; others stay as far off as they were then.

    Args:
        memory: how far parts are from where they are found.
        pose: as found, at the size that is believed.
        last: where the object was believed to be before.
        evidence: of the same frame.
        category: says which parts are on slides, and in which direction they open.
    """
    offset_part = np.array(memory.offset_part)
    for slide in category.slides:
        axis, part = np.array(slide.axis), slide.child
        remembered, resting = axis @ offset_part[part], _resting(memory, pose, last, slide)
        seen = _front(pose, evidence, slide) - np.abs(axis) @ pose.size[part] / 2
        furthest, fastest = np.array([FURTHEST, FASTEST]) * np.linalg.norm(pose.size[part])
        if -furthest < seen - resting < -fastest:
            seen = resting + DOUBT * (seen - resting)
        if min(abs(seen - remembered), abs(seen - resting)) < furthest:
            offset_part[part] += (seen - remembered) * axis
    return replace(memory, offset_part=offset_part)


def _resting(memory: PoseMemory, pose: Pose, last: Pose, slide: Joint) -> float:
    """How far ahead of where it was found a part is that has not moved on its slide, metres."""
    parent, part = slide.parent, slide.child
    rotation = pose.rotation[parent]
    centre = pose.translation[parent] + rotation @ (memory.offset_part[parent] + offset_from_parent(slide, last))
    return float(np.array(slide.axis) @ ((centre - pose.translation[part]) @ pose.rotation[part]))


def _front(pose: Pose, evidence: Evidence, slide: Joint) -> float:
    """How far ahead of a part's centre its front is, metres along its slide; NaN if it is not seen."""
    axis, part = np.array(slide.axis), slide.child
    rotation, centre, size = pose.rotation[part], pose.translation[part], pose.size[part]
    own = (evidence.parts[part].explained - centre) @ rotation
    camera: Float64[np.ndarray, "3"] = -centre @ rotation
    facing = axis @ camera - np.abs(axis) @ size / 2
    if len(own) < FEWEST_POINTS or facing < MOST_SLANTED * np.linalg.norm(camera):
        return np.nan
    end = float(reach((own @ axis)[None], STRAYS)[1][0])
    start, stop = reach(own[own @ axis > end - THICKNESS * np.linalg.norm(size)].T, STRAYS)
    spans = (stop - start)[axis == 0] > LEAST_SPAN * size[axis == 0]
    return end if spans.all() else np.nan

"""Keeps drawers on their slides: a part on a prismatic joint moves along its axis and in no other direction.

Coordinates confuse one drawer's height with another's where fronts look alike; where a slide runs was told with the
given pose, and does not change. A drawer that is seen from edge to edge tells it better still.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Bool, Float64, Int64

from captra.categories import Category, Joint
from captra.geometry import Pose
from captra.joints import offset_from_parent

SEEN_ERROR = 0.4
"""Standard deviation of where a drawer is that is seen from edge to edge, however often, in units of that of where it
was told to be."""

FRAME_ERROR = 1.5
"""Likewise of what one frame adds to that; frames that follow each other err alike."""

FURTHEST = 0.4
"""Of its sides: a drawer that is seen further off its slide was mistaken for another."""


@dataclass(frozen=True)
class Slide:
    """A line that the child's centre moves on: from the parent's centre to a point of it, metres, in its frame."""

    told: Float64[np.ndarray, "3"]
    """As the given pose and the first frame have it."""
    seen: Float64[np.ndarray, "3"]
    """Mean of the frames in which the child filled its box, along each axis."""
    frames: Int64[np.ndarray, "3"]
    """How many those were."""

    @property
    def offset_parent(self) -> Float64[np.ndarray, "3"]:
        """Each counts by the inverse of its variance."""
        variance = SEEN_ERROR**2 + FRAME_ERROR**2 / np.maximum(self.frames, 1)
        return np.where(self.frames > 0, self.told + (self.seen - self.told) / (1 + variance), self.told)

    def updated(
        self, offset_parent: Float64[np.ndarray, "3"], filled: Bool[np.ndarray, "3"], size: Float64[np.ndarray, "3"]
    ) -> "Slide":
        """After a frame in which the child was found there."""
        believed = filled & (np.abs(offset_parent - self.offset_parent) < FURTHEST * size)
        frames = self.frames + believed
        gain = believed / np.maximum(frames, 1)
        return replace(self, seen=self.seen + gain * (offset_parent - self.seen), frames=frames)


@dataclass(frozen=True)
class Slides:
    """Where slides run."""

    of_joint: Mapping[Joint, Slide] = field(default_factory=dict)
    """Joints that are not named hold nothing."""

    @staticmethod
    def through(pose: Pose, category: Category) -> "Slides":
        """Slides that run through where the parts are."""
        nothing = np.zeros(3, np.int64)
        offsets = {joint: offset_from_parent(joint, pose) for joint in category.slides}
        return Slides({joint: Slide(offset, offset, nothing) for joint, offset in offsets.items()})

    def updated(self, pose: Pose, filled: Bool[np.ndarray, "parts 3"]) -> "Slides":
        """After one more frame, given along which axes parts filled their boxes (`captra.containment.filled`)."""
        return Slides(
            {
                joint: slide.updated(offset_from_parent(joint, pose), filled[joint.child], pose.size[joint.child])
                for joint, slide in self.of_joint.items()
            }
        )

    def apply(self, pose: Pose) -> Pose:
        """The pose with every child moved straight onto its slide; parents stay."""
        translation = np.array(pose.translation)
        for joint, slide in self.of_joint.items():
            axis = np.array(joint.axis)
            astray = slide.offset_parent - offset_from_parent(joint, pose)
            translation[joint.child] += pose.rotation[joint.parent] @ (astray - axis * (axis @ astray))
        return replace(pose, translation=translation)


NO_SLIDES = Slides()
"""Every part moves as it likes."""

"""Keeps drawers on their slides: a part on a prismatic joint moves along its axis and in no other direction.

Coordinates confuse one drawer's height with another's where fronts look alike; where a slide runs was told with the
given pose, and does not change.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category, Joint
from captra.geometry import Pose
from captra.joints import offset_from_parent


@dataclass(frozen=True)
class Slides:
    """Where slides run."""

    offset_parent: Mapping[Joint, Float64[np.ndarray, "3"]] = field(default_factory=dict)
    """From the parent's centre to a point of the line that the child's centre moves on, metres, in the parent's
    frame; joints that are not named hold nothing."""

    @staticmethod
    def through(pose: Pose, category: Category) -> "Slides":
        """Slides that run through where the parts are."""
        return Slides({joint: offset_from_parent(joint, pose) for joint in category.slides})

    def apply(self, pose: Pose) -> Pose:
        """The pose with every child moved straight onto its slide; parents stay."""
        translation = np.array(pose.translation)
        for joint, offset in self.offset_parent.items():
            axis = np.array(joint.axis)
            astray = offset - offset_from_parent(joint, pose)
            translation[joint.child] += pose.rotation[joint.parent] @ (astray - axis * (axis @ astray))
        return replace(pose, translation=translation)


NO_SLIDES = Slides()
"""Every part moves as it likes."""

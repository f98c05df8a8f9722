"""What a track remembers of one object beyond its last pose: all that one look alone cannot tell."""

from dataclasses import dataclass, replace

import numpy as np

from captra.box_turns import BoxTurns
from captra.categories import Category
from captra.containment import contained, filled
from captra.evidence import Evidence
from captra.fronts import behind_fronts
from captra.geometry import Pose
from captra.pose_memory import FoundError, PoseMemory
from captra.size_memory import SizeMemory
from captra.slides import NO_SLIDES, Slides
from captra.stacking import stacked


@dataclass(frozen=True)
class Remembered:
    """Never changed: every frame makes another."""

    category: Category
    """What the object is."""
    found_error: FoundError
    """By how much networks err on one object all the time."""
    size: SizeMemory
    """How large it is."""
    pose: PoseMemory
    """Where its parts are, as against where they are found."""
    box_turns: BoxTurns
    """How far parts are turned in their boxes."""
    slides: Slides
    """Where slides run."""

    @staticmethod
    def of(given: Pose, category: Category, given_size_error: float, found_error: FoundError) -> "Remembered":
        """Of an object of which nothing is known but a given pose."""
        return Remembered(
            category,
            found_error,
            SizeMemory.of(given, given_size_error, found_error),
            PoseMemory.nothing_known(category.num_parts),
            BoxTurns.nothing_known(category.num_parts),
            NO_SLIDES,
        )

    def measured(self, found: Pose, evidence: Evidence) -> "Remembered":
        """With the size that one more frame measured."""
        return replace(self, size=self.size.updated(found, evidence.fitted))

    def sized(self, found: Pose, evidence: Evidence) -> Pose:
        """What was found, at the remembered size and around the points."""
        return contained(self.size.apply(found, evidence.centroid), evidence, self.category)

    def beside(self, given: Pose, found: Pose, evidence: Evidence) -> "Remembered":
        """With what a given pose tells that the frame in which parts were found there cannot."""
        error = self.found_error.seen_by(evidence)
        possible = stacked(found, given, self.category, error)
        pose = PoseMemory.between(given, possible, self.category, error)
        return replace(
            self,
            pose=pose,
            box_turns=BoxTurns.between(given, possible, self.category, error),
            slides=Slides.through(pose.apply(possible, evidence.fitted), self.category),
        )

    def updated(self, found: Pose, last: Pose, evidence: Evidence) -> "Remembered":
        """After one more frame, which found parts there; before, the object was where `last` says."""
        box_turns = self.box_turns.updated(found, evidence)
        updated = replace(self, pose=box_turns.refine(self.pose, found.size), box_turns=box_turns)
        return updated._on_slides(found, last, evidence) if self.category.slides else updated

    def _on_slides(self, found: Pose, last: Pose, evidence: Evidence) -> "Remembered":
        """With what a frame tells of parts on slides: how far they are out, and where their slides run."""
        pose = behind_fronts(self.pose, found, last, evidence, self.category)
        root, translation = self.category.root, np.array(found.translation)
        translation[root] = pose.apply(found, evidence.fitted).translation[root]
        slides = self.slides.updated(replace(found, translation=translation), filled(found, evidence))
        return replace(self, pose=pose, slides=slides)

    def place(self, found: Pose, evidence: Evidence) -> Pose:
        """Where parts are believed to be that were found there."""
        return self.slides.apply(self.pose.apply(found, evidence.fitted))

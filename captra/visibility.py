"""How much of its object a track is used to see: one of which suddenly little is left is on its way out of sight."""

from dataclasses import dataclass, replace

import numpy as np

from captra.evidence import Evidence
from captra.observations import Crop

LEAST_LEFT = 0.01
"""A smaller share of what is usual tells nothing more."""

FRAMES = 10
"""In so many a track gets used to what it sees."""

NEAREST_M = 0.25
"""No depth camera sees what is nearer: in the frame of something else, whose origin objects may come close to, their
distances are no measure of how many points they have."""

NEXT_TO_NOTHING = 1e-9
"""What is seen of an object that nothing is seen of."""


def visible(evidence: Evidence, crop: Crop) -> float:
    """How much of the object is seen, in points times m²: what is farther away has fewer points.

    Args:
        evidence: fits to the points of the crop.
        crop: in the sensor's frame, chosen to stand for all that there were.
    """
    explained = np.concatenate([part.explained for part in evidence.parts])
    if not len(explained):
        return 0.0
    squared_distances = np.maximum(np.square(explained).sum(axis=1), NEAREST_M**2)
    return float(len(explained) / len(crop) * crop.total * squared_distances.mean())


@dataclass(frozen=True)
class Visibility:
    """What a track is used to."""

    usual_log: float | None = None
    """Running mean of the logarithms of `Evidence.visible`; none before the first frame."""

    def judged(self, evidence: Evidence) -> Evidence:
        """The evidence of a frame, and how much less is seen in it than usual."""
        if self.usual_log is None:
            return evidence
        gone = np.clip(self.usual_log - _log(evidence.visible), 0.0, -np.log(LEAST_LEFT))
        return replace(evidence, vanished=float(gone))

    def updated(self, evidence: Evidence) -> "Visibility":
        """After one more frame in which the object was where it was found."""
        seen = _log(evidence.visible)
        return Visibility(seen if self.usual_log is None else self.usual_log + (seen - self.usual_log) / FRAMES)


def _log(seen: float) -> float:
    return float(np.log(max(seen, NEXT_TO_NOTHING)))

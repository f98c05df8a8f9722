"""What a campaign trains of each category, one stretch after the other, and in which order of categories."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from captra.learn.plan import COORDINATE, ROTATION, NetworkName, Plan


@dataclass(frozen=True)
class Stretch:
    """A part of a category's training, with a run of its own."""

    run: str
    """Names the folder of its state."""
    milestones: tuple[float, ...]
    """Shares of the samples after which the networks are exported and scored."""
    networks: tuple[NetworkName, ...]
    """Which are trained; the other is that of the bundle that ships."""
    served_by: Mapping[str, str] = field(default_factory=dict)
    """Categories that the run of another serves, by name: it is trained once, on the views of all of them."""
    anew: bool = False
    """Whether RotationNet starts from CoordinateNet's backbone, not from its own weights."""

    def owner(self, category: str) -> str:
        """The category whose run it is."""
        return self.served_by.get(category, category)

    def shown(self, category: str) -> tuple[str, ...]:
        """The categories whose views are trained on, the owner first."""
        owner = self.owner(category)
        return (owner, *(name for name, other in self.served_by.items() if other == owner))


BOTH = Stretch("run", (0.25, 0.5, 0.75, 0.9, 1.0), Plan.networks)
"""Both networks; RotationNet soon starts from the little that CoordinateNet has learned."""
ROUND = MappingProxyType({"bowl": "bottle", "can": "bottle"})
ROTATION_ANEW = Stretch("anew", (0.5, 0.75, 1.0), (ROTATION,), ROUND, anew=True)
"""RotationNet alone, from all that the best CoordinateNet has learned: where it was better than any other change.

What is round about one axis turns alike, whatever it is called: one network learned more from all three.
"""
COORDINATE_FURTHER = Stretch("further", (0.5, 0.75, 1.0), (COORDINATE,))
"""CoordinateNet alone, from where it stands, with the learning rate high again: it gained by some 100,000 samples."""
ROTATION_FURTHER = Stretch("rotation-further", (0.5, 0.75, 1.0), (ROTATION,), ROUND)
"""Likewise RotationNet, which went on to gain where CoordinateNet no longer did."""
STRETCHES = (BOTH, ROTATION_ANEW, COORDINATE_FURTHER, ROTATION_FURTHER)
COURSE = tuple((stretch, share) for stretch in STRETCHES for share in stretch.milestones)
"""All milestones of a category in turn."""

WARM_STARTS: Mapping[str, str] = MappingProxyType(
    {
        "can": "bottle",
        "bowl": "bottle",
        "laptop": "mug",
        "camera": "mug",
        "laptop_articulated": "mug",
        "scissors": "mug",
        "glasses": "mug",
        "drawers": "mug",
    }
)
"""Whose networks a category starts from; others start from nothing, or from what ships of themselves."""

QUEUE = ("bottle", "mug", "can", "bowl", "laptop", "camera", "laptop_articulated", "scissors", "drawers", "glasses")
"""Those that others start from come first."""

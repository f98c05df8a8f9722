"""Chooses how a bundle's opinions on rotations become one, by tracking validation sequences with every candidate."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from captra.categories import get_category
from captra.evaluation.runner import ExportedNetworks, mean_over
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.summary import Summary
from captra.evaluation.workers import Workers
from captra.joint_projection import JOINT_PROJECTIONS
from captra.looking import Networks
from captra.runtime.bundle import Manifest

ABOUT_Y = ("turn-about-y-from-coordinates", "turn-about-y-half-way")
"""These say nothing about objects that are symmetric about y."""


@dataclass(frozen=True)
class Fusion:
    """How rotations are put together."""

    rotation_fusion: str
    """Of both networks: a name of `captra.rotation_fusion.ROTATION_FUSIONS`."""
    joint_projection: str = "free"
    """Of all parts: a name of `captra.joint_projection.JOINT_PROJECTIONS`."""

    @property
    def name(self) -> str:
        """For tables."""
        return f"{self.rotation_fusion}, {self.joint_projection}"

    def set_in(self, manifest: Manifest) -> Manifest:
        """The manifest with this fusion."""
        return replace(manifest, rotation_fusion=self.rotation_fusion, joint_projection=self.joint_projection)


@dataclass(frozen=True)
class FusedNetworks:
    """A bundle run with another fusion than its manifest names."""

    exported: ExportedNetworks
    """The bundle and how to run it."""
    fusion: Fusion
    """In the place of the manifest's."""

    def load(self) -> Networks:
        """Load both networks."""
        networks = self.exported.load()
        return replace(networks, manifest=self.fusion.set_in(networks.manifest))


def rotation_fusions(category: str) -> tuple[str, ...]:
    """The fusions of both networks that make sense for a category; the coordinates alone are a baseline."""
    return ("rotation-net", "mean", *(() if get_category(category).symmetric else ABOUT_Y))


def choose(category: str, measure: Callable[[Fusion], Summary]) -> tuple[Fusion, list[Summary]]:
    """The best fusion of the networks with free parts, then the best of projections with it; and all that was measured.

    Args:
        category: name of the category.
        measure: tracks the sequences with a fusion; the means carry its name.
    """
    found = _measured((Fusion(name) for name in rotation_fusions(category)), measure)
    if get_category(category).joints:
        best = max(found, key=lambda fusion: worth(found[fusion]))
        others = (replace(best, joint_projection=name) for name in JOINT_PROJECTIONS if name != best.joint_projection)
        found |= _measured(others, measure)
    return max(found, key=lambda fusion: worth(found[fusion])), list(found.values())


def measure(networks: ExportedNetworks, sources: Sequence[SequenceSource], workers: Workers, fusion: Fusion) -> Summary:
    """Means over the sequences with a fusion, under its name."""
    return mean_over(fusion.name, FusedNetworks(networks, fusion), sources, workers)


def _measured(fusions: Iterable[Fusion], measure: Callable[[Fusion], Summary]) -> dict[Fusion, Summary]:
    return {fusion: measure(fusion) for fusion in fusions}


def worth(mean: Summary) -> float:
    """What validation goes by: the mean of 5°5cm and oriented IoU, percent; higher is better."""
    return (mean.within_5deg_5cm_percent + mean.iou_oriented_percent) / 2

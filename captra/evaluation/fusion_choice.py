"""Chooses how a bundle's opinions on rotations become one, by tracking validation sequences with every candidate."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from itertools import product, starmap

from captra.categories import get_category
from captra.evaluation.runner import ExportedNetworks, mean_over
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.summary import Summary
from captra.evaluation.workers import Workers
from captra.joint_projection import JOINT_PROJECTIONS
from captra.looking import Networks
from captra.mirrors import MIRRORS
from captra.runtime.bundle import Manifest

ABOUT_Y = ("turn-about-y-from-coordinates", "turn-about-y-half-way")
"""These say nothing about objects that are symmetric about y."""

LEAST_GAIN = 0.5
"""In the unit of `worth`: a mirror takes CoordinateNet's time once more, and must be worth it."""


@dataclass(frozen=True)
class Fusion:
    """How rotations are put together."""

    rotation_fusion: str
    """Of both networks: a name of `captra.rotation_fusion.ROTATION_FUSIONS`."""
    joint_projection: str = "free"
    """Of all parts: a name of `captra.joint_projection.JOINT_PROJECTIONS`."""
    mirror: str = "none"
    """Of CoordinateNet's cloud: a name of `captra.mirrors.MIRRORS`."""

    @staticmethod
    def of(manifest: Manifest) -> "Fusion":
        """That of a bundle as it is."""
        return Fusion(manifest.rotation_fusion, manifest.joint_projection, manifest.mirror)

    @property
    def name(self) -> str:
        """For tables."""
        return ", ".join((self.rotation_fusion, self.joint_projection, *({self.mirror} - {"none"})))

    def set_in(self, manifest: Manifest) -> Manifest:
        """The manifest with this fusion."""
        return replace(manifest, **asdict(self))


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
    """The best pair of a fusion of the networks and a projection of their parts, then the best of mirrors with it.

    Pairs are tried all: parts that carry each other's rotations can make another network's word the better one.
    All that was measured comes with it.

    Args:
        category: name of the category.
        measure: tracks the sequences with a fusion; the means carry its name.
    """
    chosen = get_category(category)
    projections = tuple(JOINT_PROJECTIONS) if chosen.joints else ("free",)
    found = _measured(starmap(Fusion, product(rotation_fusions(category), projections)), measure)
    best = max(found, key=lambda fusion: worth(found[fusion]))
    if not chosen.symmetric:
        mirrored = _measured((replace(best, mirror=name) for name in MIRRORS if name != best.mirror), measure)
        found |= mirrored
        best = max((best, *mirrored), key=lambda fusion: worth(found[fusion]) - LEAST_GAIN * (fusion in mirrored))
    return best, list(found.values())


def measure(networks: ExportedNetworks, sources: Sequence[SequenceSource], workers: Workers, fusion: Fusion) -> Summary:
    """Means over the sequences with a fusion, under its name."""
    return mean_over(fusion.name, FusedNetworks(networks, fusion), sources, workers)


def _measured(fusions: Iterable[Fusion], measure: Callable[[Fusion], Summary]) -> dict[Fusion, Summary]:
    return {fusion: measure(fusion) for fusion in fusions}


def worth(mean: Summary) -> float:
    """What validation goes by: the mean of 5°5cm and oriented IoU, percent; higher is better."""
    return (mean.within_5deg_5cm_percent + mean.iou_oriented_percent) / 2

"""Chooses whose word counts for a bundle's rotations, by tracking validation sequences with every candidate."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from captra.categories import get_category
from captra.evaluation.runner import ExportedNetworks, evaluate
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.summary import Summary, average, summarize
from captra.evaluation.workers import Workers
from captra.looking import Networks
from captra.runtime.onnx_networks import OnnxNetworks

ABOUT_Y = "turn-about-y-from-coordinates"
"""Says nothing about objects that are symmetric about y."""


@dataclass(frozen=True)
class FusedNetworks:
    """A bundle run with another rotation fusion than its manifest names."""

    exported: ExportedNetworks
    """The bundle and how to run it."""
    rotation_fusion: str
    """A name of `captra.rotation_fusion.ROTATION_FUSIONS`."""

    def load(self) -> Networks:
        """Load both networks."""
        networks: OnnxNetworks = self.exported.load()
        return replace(networks, manifest=replace(networks.manifest, rotation_fusion=self.rotation_fusion))


def candidates(category: str) -> tuple[str, ...]:
    """The fusions that make sense for a category; what the coordinates say alone is a baseline, not a candidate."""
    if get_category(category).symmetric:
        return ("rotation-net", "mean")
    return ("rotation-net", "mean", ABOUT_Y)


def compare(
    exported: ExportedNetworks, category: str, sources: Sequence[SequenceSource], workers: Workers
) -> Iterator[Summary]:
    """Means over the sequences, one a candidate, named after it."""
    for fusion in candidates(category):
        outcomes = evaluate(FusedNetworks(exported, fusion), sources, workers)
        yield average(fusion, [summarize(outcome.score) for outcome in outcomes])


def worth(mean: Summary) -> float:
    """What validation goes by: the mean of 5°5cm and oriented IoU, percent; higher is better."""
    return (mean.within_5deg_5cm_percent + mean.iou_oriented_percent) / 2

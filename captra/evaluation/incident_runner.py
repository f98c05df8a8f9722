"""Watches incidents in sequences, wherever the work is done; what comes back holds no clouds."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from captra.evaluation.incidents import FULL, Span, make_incident
from captra.evaluation.runner import NetworksSource, loaded
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.watching import Watched, watch
from captra.evaluation.workers import Workers
from captra.health import HealthMonitor
from captra.recovery import LookBudget
from captra.tracker import Tracker, TrackerOptions


@dataclass(frozen=True)
class Rehearsal:
    """One sequence, and what is to go wrong in it."""

    source: SequenceSource
    """The sequence."""
    kinds: tuple[str, ...]
    """Keys of `INCIDENTS`, one after the other."""
    seed: int
    """Of the incidents."""
    span: Span = FULL
    """How long they take."""


def watch_all(
    networks: NetworksSource,
    rehearsals: Iterable[Rehearsal],
    workers: Workers,
    health: Mapping[str, Any],
    looks: int,
) -> Iterator[list[Watched]]:
    """What became of every incident, sequence by sequence.

    Args:
        networks: what to track with.
        rehearsals: what happens.
        workers: where.
        health: calibration of the confidence as a manifest holds it; empty for none.
        looks: at most so many a frame while a track does not hold: a fixed number, so that the machine does not matter.
    """
    return workers.map(partial(_watch, networks, health, looks), rehearsals)


def _watch(networks: NetworksSource, health: Mapping[str, Any], looks: int, rehearsal: Rehearsal) -> list[Watched]:
    recording = rehearsal.source.load().recording
    options, monitor = TrackerOptions(search=LookBudget(looks)), HealthMonitor.calibrated(health)
    start = partial(Tracker, loaded(networks), health=monitor, options=options)
    return list(
        watch(start, (make_incident(kind, recording, rehearsal.seed, rehearsal.span) for kind in rehearsal.kinds))
    )

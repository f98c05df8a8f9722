"""What watched incidents tell of the tracker's honesty: calibration, detection, false alarms, recovery."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Int
from rich.table import Table

from captra.evaluation.calibration import auroc
from captra.evaluation.watching import Watched
from captra.health import State
from captra.metrics import within

SAID = frozenset({State.LOST, State.RECOVERING})
"""States that say a track was lost."""

DEADLINE = 5
"""Frames within which a lost track should say so."""

LOST_DEG, LOST_CM = 20.0, 10.0
"""A pose that is further off, or of an object that is not in the cloud, is lost."""

HELD_DEG, HELD_CM = 10.0, 10.0
"""An incident counts as one of a track that held if the pose before it was within these."""

BINS = 5


@dataclass(frozen=True)
class Loss:
    """A track that was lost."""

    delay: int | None
    """Frames until it said so, counting the first as 1; none if it never did."""


@dataclass(frozen=True)
class Recovery:
    """What became of a track whose object came back into sight."""

    kind: str
    """Of the incident."""
    found: bool
    """Whether it was tracking within 10° and 10 cm before the sequence ended."""
    found_well: bool
    """Whether it was tracking within 5° and 5 cm."""


def losses(watched: Iterable[Watched]) -> list[Loss]:
    """Every time a track was lost for longer than the deadline."""
    found = []
    for one in watched:
        gone = ~(within(one.rotation_deg, one.translation_cm, LOST_DEG, LOST_CM).all(axis=1) & one.seen)
        said = np.array([state in SAID for state in one.states])
        found += [_loss(said, first) for first in _beginnings(gone, DEADLINE + 1)]
    return found


def _loss(said: Bool[np.ndarray, " frames"], first: int) -> Loss:
    after = np.flatnonzero(said[first:])
    return Loss(int(after[0]) + 1 if len(after) else None)


def _beginnings(flags: Bool[np.ndarray, " frames"], length: int) -> Int[np.ndarray, " runs"]:
    """Where runs of at least `length` true values begin, after a frame that is false."""
    edges = np.diff(np.r_[1, flags.astype(int), 0])
    starts, stops = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    stops = stops[stops > starts[0]] if len(starts) else stops[:0]
    return np.asarray(starts[stops - starts >= length])


def false_alarms(watched: Iterable[Watched]) -> tuple[int, int]:
    """Good frames called lost, and good frames: before anything happens, and after the track holds again."""
    alarms = good = 0
    for one in watched:
        before = np.arange(1, len(one.states) + 1) < one.incident.start
        tracking = np.array([state is State.TRACKING for state in one.states])
        again = np.flatnonzero(tracking & (np.arange(1, len(one.states) + 1) > one.incident.stop))
        counted = before | (np.arange(len(one.states)) >= (again[0] if len(again) else len(one.states)))
        counted &= one.correct
        alarms += int((counted & np.array([state is State.LOST for state in one.states])).sum())
        good += int(counted.sum())
    return alarms, good


def recoveries(watched: Iterable[Watched]) -> list[Recovery]:
    """Every incident of a track that held before it, if the object was back for a while."""
    found = []
    for one in watched:
        before, back = one.incident.start - 2, one.incident.stop - 1
        held = np.asarray(within(one.rotation_deg, one.translation_cm, HELD_DEG, HELD_CM).all(axis=1))
        if one.incident.kind == "nothing" or not held[before] or len(held) - back <= DEADLINE:
            continue
        tracking = np.array([state is State.TRACKING for state in one.states])
        ends = tracking[-DEADLINE:]
        well = bool((ends & one.correct[-DEADLINE:]).any())
        found.append(Recovery(one.incident.kind, bool((ends & held[-DEADLINE:]).any()), well))
    return found


def summary(name: str, watched: Sequence[Watched]) -> Table:
    """All figures of one category."""
    confidence = np.concatenate([one.confidence for one in watched])
    correct = np.concatenate([one.correct for one in watched])
    lost, (alarms, good) = losses(watched), false_alarms(watched)
    delays = np.array([loss.delay for loss in lost if loss.delay is not None])
    table = Table(title=f"{name}: {len(watched)} incidents, {len(correct)} frames, {100 * correct.mean():.0f} % right")
    table.add_column("what", no_wrap=True)
    table.add_column("value", justify="right")
    table.add_row("AUROC of the confidence", f"{auroc(confidence, correct):.3f}")
    in_time = int((delays <= DEADLINE).sum())
    table.add_row(f"losses told within {DEADLINE} frames", _share(in_time, len(lost)))
    if len(delays):
        table.add_row("delay p50 / p95, frames", f"{np.median(delays):.0f} / {np.quantile(delays, 0.95):.0f}")
    table.add_row("good frames called lost", _share(alarms, good))
    for kind in dict.fromkeys(one.incident.kind for one in watched):
        back = [recovery for recovery in recoveries(watched) if recovery.kind == kind]
        if back:
            table.add_row(f"recovered: {kind}", _share(sum(one.found for one in back), len(back)))
            table.add_row("  … within 5° and 5 cm", _share(sum(one.found_well for one in back), len(back)))
    for low in np.arange(BINS) / BINS:
        chosen = (confidence >= low) & (confidence < low + 1 / BINS + (low + 1 / BINS >= 1))
        if chosen.any():
            told = f"confidence {low:.1f}-{low + 1 / BINS:.1f}: mean {confidence[chosen].mean():.2f}, right"
            table.add_row(told, _share(int(correct[chosen].sum()), int(chosen.sum())))
    return table


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} % of {whole}" if whole else "none"

"""What watched incidents tell of the tracker's honesty: calibration, detection, false alarms, recovery."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float64, Int

from captra.evaluation.calibration import auroc
from captra.evaluation.incidents import LEAD
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

BINS = 10
"""Of confidences, in reliability diagrams."""


@dataclass(frozen=True)
class Share:
    """So many of so many."""

    part: int
    """Of them."""
    whole: int
    """All of them."""

    @property
    def percent(self) -> float:
        """NaN of none."""
        return 100 * self.part / self.whole if self.whole else float("nan")

    def __add__(self, other: "Share") -> "Share":
        return Share(self.part + other.part, self.whole + other.whole)

    def __str__(self) -> str:
        return f"{self.percent:.1f} % of {self.whole}" if self.whole else "none"


@dataclass(frozen=True)
class Bin:
    """Frames of like confidence."""

    confidence: float
    """Their mean."""
    right: Share
    """How many of them were right."""


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


@dataclass(frozen=True)
class HealthFigures:
    """Everything that incidents tell of one category, or of several."""

    name: str
    """Of the category."""
    incidents: int
    """How many were watched."""
    right: Share
    """Frames within 5° and 5 cm of an object that is in sight."""
    auroc: float
    """Of the confidence, for telling right frames from wrong ones, over all frames; an object out of sight is wrong."""
    auroc_in_sight: float
    """Likewise, over those frames in which the object is in the cloud."""
    told_in_time: Share
    """Losses that were told within the deadline."""
    delay_p50_frames: float
    """Of losses that were told."""
    delay_p95_frames: float
    """Likewise."""
    good_called_lost: Share
    """Frames that were right and called lost or recovering, before anything happened and after the track held again."""
    recovered: Mapping[str, Share]
    """Tracks that held before an incident and again after it, by its kind."""
    recovered_well: Mapping[str, Share]
    """Likewise within 5° and 5 cm."""
    reliability: tuple[Bin, ...]
    """Bins that are not empty, by rising confidence."""
    calibration_error: float
    """Mean distance between confidence and share of right frames, over frames in bins."""


def figures(name: str, watched: Sequence[Watched]) -> HealthFigures:
    """All figures of some incidents."""
    confidence, correct, seen = (
        np.concatenate([getattr(one, field) for one in watched]) for field in ("confidence", "correct", "seen")
    )
    lost, back = losses(watched), recoveries(watched)
    delays = [loss.delay for loss in lost if loss.delay is not None]
    kinds = list(dict.fromkeys(one.kind for one in back))
    bins = reliability(confidence, correct)
    return HealthFigures(
        name=name,
        incidents=len(watched),
        right=Share(int(correct.sum()), len(correct)),
        auroc=auroc(confidence, correct),
        auroc_in_sight=auroc(confidence[seen], correct[seen]),
        told_in_time=Share(sum(delay <= DEADLINE for delay in delays), len(lost)),
        delay_p50_frames=float(np.median(delays)) if delays else float("nan"),
        delay_p95_frames=float(np.quantile(delays, 0.95)) if delays else float("nan"),
        good_called_lost=false_alarms(watched),
        recovered={kind: _share([one.found for one in back if one.kind == kind]) for kind in kinds},
        recovered_well={kind: _share([one.found_well for one in back if one.kind == kind]) for kind in kinds},
        reliability=bins,
        calibration_error=sum(abs(b.confidence - b.right.percent / 100) * b.right.whole for b in bins) / len(correct),
    )


def by_kind(watched: Sequence[Watched]) -> list[HealthFigures]:
    """All figures of each kind of incident."""
    kinds = dict.fromkeys(one.kind for one in watched)
    return [figures(kind, [one for one in watched if one.kind == kind]) for kind in kinds]


def reliability(confidence: Float64[np.ndarray, " frames"], correct: Bool[np.ndarray, " frames"]) -> tuple[Bin, ...]:
    """Frames in bins of equal width; empty ones are left out."""
    index = np.minimum((confidence * BINS).astype(int), BINS - 1)
    return tuple(
        Bin(float(confidence[index == b].mean()), _share(correct[index == b].tolist())) for b in np.unique(index)
    )


def gone(one: Watched) -> Bool[np.ndarray, " frames"]:
    """Frames in which the track was lost, whatever it said."""
    near = within(one.rotation_deg, one.translation_cm, LOST_DEG, LOST_CM).all(axis=1)
    return np.asarray(~(near & one.seen))


def losses(watched: Iterable[Watched]) -> list[Loss]:
    """Every time a track was lost for longer than the deadline, from its first frame on as well."""
    found = []
    for one in watched:
        said = np.array([state in SAID for state in one.states])
        found += [_loss(said, first) for first in _beginnings(gone(one), DEADLINE + 1)]
    return found


def _loss(said: Bool[np.ndarray, " frames"], first: int) -> Loss:
    after = np.flatnonzero(said[first:])
    return Loss(int(after[0]) + 1 if len(after) else None)


def _beginnings(flags: Bool[np.ndarray, " frames"], length: int) -> Int[np.ndarray, " runs"]:
    """Where runs of at least `length` true values begin."""
    edges = np.diff(np.r_[0, flags.astype(int), 0])
    starts, stops = np.flatnonzero(edges == 1), np.flatnonzero(edges == -1)
    return np.asarray(starts[stops - starts >= length])


def false_alarms(watched: Iterable[Watched]) -> Share:
    """Good frames called lost or recovering: before anything happens, and after the track holds again."""
    total = Share(0, 0)
    for one in watched:
        frames = np.arange(1, len(one.states) + 1)
        tracking = np.array([state is State.TRACKING for state in one.states])
        again = np.flatnonzero(tracking & (frames > one.stop))
        counted = (frames < one.start) | (frames > (again[0] if len(again) else len(frames)))
        counted &= one.correct
        alarms = counted & np.array([state in SAID for state in one.states])
        total += Share(int(alarms.sum()), int(counted.sum()))
    return total


def recoveries(watched: Iterable[Watched]) -> list[Recovery]:
    """Every incident of a track that held before it, if the object was back for a while."""
    found = []
    for one in watched:
        before, back = min(one.start, LEAD) - 2, one.stop - 1  # an occluder comes over the object before it hides it
        if before < 0:
            continue  # it never held
        held = np.asarray(within(one.rotation_deg, one.translation_cm, HELD_DEG, HELD_CM).all(axis=1))
        if one.kind == "nothing" or not held[before] or len(held) - back <= DEADLINE:
            continue
        tracking = np.array([state is State.TRACKING for state in one.states])
        ends = tracking[-DEADLINE:]
        well = bool((ends & one.correct[-DEADLINE:]).any())
        found.append(Recovery(one.kind, bool((ends & held[-DEADLINE:]).any()), well))
    return found


def _share(flags: Sequence[bool]) -> Share:
    return Share(sum(flags), len(flags))

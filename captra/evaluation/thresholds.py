"""Chooses the thresholds of doubt and trust by what they would have said of tracks whose truth is known."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.belief import FORGETFUL, Belief
from captra.confidence import ConfidenceModel
from captra.evaluation.health_figures import DEADLINE, false_alarms, gone, losses
from captra.evaluation.persistence import confidences
from captra.evaluation.watching import Watched
from captra.health import HealthMonitor, State

DOUBTS = (0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6)
"""Lower thresholds to try."""

TRUST_LOGITS = (0.5, 1.0, 1.5, 2.0, 2.5)
"""How far the upper threshold may lie above the lower one, in log odds."""

ALARM_COST, UNEASE_COST, CREDULITY_COST = 20.0, 0.5, 1.0
"""What a share of good frames called lost, of good ones that are not tracking, and of lost ones that are, count beside
that of losses untold.

One good frame in a hundred called lost is as bad as one loss in five untold: both miss what we promise.
"""


def choose_thresholds(model: ConfidenceModel, watched: Sequence[Watched], belief: Belief = FORGETFUL) -> HealthMonitor:
    """The monitor of least cost on these tracks; of equal ones, that which doubts least."""
    told = [confidences(model, one) for one in watched]
    monitors = [
        HealthMonitor(model, doubt, _above(doubt, logits), belief=belief) for doubt in DOUBTS for logits in TRUST_LOGITS
    ]
    return min(monitors, key=lambda monitor: _cost(_retold(monitor, watched, told)))


def states(monitor: HealthMonitor, told: Float64[np.ndarray, " frames"]) -> tuple[State, ...]:
    """What a monitor says of each frame, from its confidences; NaN is a frame without points."""
    found = []
    for confidence in told.tolist():
        monitor = monitor.updated(confidence) if np.isfinite(confidence) else monitor.missed()
        found.append(monitor.state)
    return tuple(found)


def _above(doubt: float, logits: float) -> float:
    return float(1 / (1 + np.exp(-(np.log(doubt / (1 - doubt)) + logits))))


def _retold(
    monitor: HealthMonitor, watched: Sequence[Watched], told: Sequence[Float64[np.ndarray, " frames"]]
) -> list[Watched]:
    return [replace(one, states=states(monitor, mine)) for one, mine in zip(watched, told, strict=True)]


def _cost(retold: Sequence[Watched]) -> float:
    lost, alarms = losses(retold), false_alarms(retold)
    untold = np.mean([loss.delay is None or loss.delay > DEADLINE for loss in lost]) if lost else 0.0
    tracking = np.concatenate([[state is State.TRACKING for state in one.states] for one in retold])
    good, wrong = np.concatenate([one.correct for one in retold]), np.concatenate([gone(one) for one in retold])
    return float(
        untold
        + ALARM_COST * alarms.part / max(alarms.whole, 1)
        + UNEASE_COST * (good & ~tracking).sum() / max(good.sum(), 1)
        + CREDULITY_COST * (wrong & tracking).sum() / max(wrong.sum(), 1)
    )

"""Chooses the thresholds of doubt and trust by what they would have said of tracks whose truth is known."""

import itertools
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.belief import FORGETFUL, Belief, logit, sigmoid
from captra.confidence import ConfidenceModel
from captra.evaluation.health_figures import DEADLINE, false_alarms, gone, losses
from captra.evaluation.watching import Watched
from captra.health import HealthMonitor, State

DOUBTS = (0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6)
"""Lower thresholds to try."""

TRUST_LOGITS = (0.5, 1.0, 1.5, 2.0, 2.5)
"""How far the upper threshold may lie above the lower one, in log odds."""

ALARM_COST, UNEASE_COST, CREDULITY_COST = 20.0, 0.5, 1.0
"""What a share of good frames called lost, of good ones that are not tracking, and of lost ones that are, count beside
that of losses untold.

One good frame in a hundred called lost is as bad as one loss in five untold: both miss what we promise.
"""

USUAL_DOUBT, USUAL_LOGITS, OUTLANDISH_COST = 0.03, 1.0, 0.2
"""Thresholds that suit most categories, and what each of log odds away from them costs: those that fit a few tracks
best tell fewer losses of the next ones, and more that are none."""

BELIEF_STEP = 0.35
"""Log odds that each belief counts as farther away from the first."""


def choose_thresholds(
    model: ConfidenceModel, watched: Sequence[Watched], beliefs: Sequence[Belief] = (FORGETFUL,)
) -> HealthMonitor:
    """The monitor of least cost on these tracks, rather with the first belief and with usual thresholds."""
    told = [confidences(model, one) for one in watched]

    def monitor(belief: Belief, doubt: float, logits: float) -> HealthMonitor:
        return HealthMonitor(model, doubt, sigmoid(logit(doubt) + logits), belief=belief)

    def cost(choice: tuple[Belief, float, float]) -> float:
        belief, doubt, logits = choice
        outlandish = abs(logit(doubt) - logit(USUAL_DOUBT)) + abs(logits - USUAL_LOGITS)
        outlandish += BELIEF_STEP * beliefs.index(belief)
        return _cost(_retold(monitor(*choice), watched, told)) + OUTLANDISH_COST * outlandish

    return monitor(*min(itertools.product(beliefs, DOUBTS, TRUST_LOGITS), key=cost))


def confidences(model: ConfidenceModel, one: Watched) -> Float64[np.ndarray, " frames"]:
    """What a model says of each frame by itself: of its worst part, and NaN where there was nothing to look at."""
    return np.asarray(1 / (1 + np.exp(-model.logit(one.features).min(axis=1))))


def states(monitor: HealthMonitor, told: Float64[np.ndarray, " frames"]) -> tuple[State, ...]:
    """What a monitor says of each frame, from its confidences; NaN is a frame without points."""
    found = []
    for confidence in told.tolist():
        monitor = monitor.updated(confidence) if np.isfinite(confidence) else monitor.missed()
        found.append(monitor.state)
    return tuple(found)


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

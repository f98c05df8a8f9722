"""Fits the confidence to what steps knew, on sequences apart from training and test."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float64

from captra.confidence import FEATURES, UNCALIBRATED, ConfidenceModel
from captra.evaluation.watching import Watched

RIDGE = 1.0
"""Pull towards the uncalibrated weights, per standard deviation of a feature.

Objects of one category differ more from each other than frames of one object: weights fitted freely to a few objects
fit the next one worse than those that suit most categories.
"""

PLATT_RIDGE = 0.3
"""Pull of the last recalibration towards none: it has two parameters only, but few objects tell them."""

NEWTON_STEPS = 30


@dataclass(frozen=True)
class Observations:
    """What steps knew, and whether they were right."""

    features: Float64[np.ndarray, "steps parts features"]
    """As `captra.confidence.FEATURES` orders them."""
    correct: Bool[np.ndarray, "steps parts"]
    """Whether each part was seen, and found within 5° and 5 cm."""


def observations(watched: Sequence[Watched]) -> Observations:
    """All frames in which there was something to look at."""
    features = np.concatenate([one.features for one in watched])
    correct = np.concatenate([one.found for one in watched])
    known = np.isfinite(features).all(axis=(1, 2))
    return Observations(features[known], correct[known])


def fit_confidence(found: Observations) -> ConfidenceModel:
    """The model that fits these observations, of all parts at once.

    Raises:
        ValueError: there are none.
    """
    if not len(found.correct):
        raise ValueError("there is nothing to calibrate on: no frame had points near the object")
    parts = fit(found.features.reshape(-1, len(FEATURES)), found.correct.reshape(-1))
    return _of_the_worst_part(parts, found)


def fit(
    features: Float64[np.ndarray, "rows features"], correct: Bool[np.ndarray, " rows"], ridge: float = RIDGE
) -> ConfidenceModel:
    """Logistic regression by Newton's method, pulled towards the uncalibrated weights.

    Every feature is bad news, so a weight that comes out positive says that its feature says nothing here: it is left
    out, and the others are fitted again.
    """
    y, spread = correct.astype(np.float64), np.maximum(features.std(axis=0), 1e-6)
    usual = np.array([UNCALIBRATED[name] for name in FEATURES]) * spread
    z, used = features / spread, np.ones(len(FEATURES), bool)
    while True:
        bias, weights = _newton(z[:, used], y, np.r_[ConfidenceModel().bias, usual[used]], ridge)
        if (weights <= 0).all():
            break
        used[np.flatnonzero(used)[weights > 0]] = False
    found = np.zeros(len(FEATURES))
    found[used] = weights / spread[used]
    return ConfidenceModel(float(bias), dict(zip(FEATURES, found.tolist(), strict=True)))


def confidences(model: ConfidenceModel, found: Observations) -> Float64[np.ndarray, " steps"]:
    """The model's confidence in every step: that in its worst part."""
    return np.asarray(1 / (1 + np.exp(-model.logit(found.features).min(axis=1))))


def _newton(
    z: Float64[np.ndarray, "rows features"],
    y: Float64[np.ndarray, " rows"],
    towards: Float64[np.ndarray, " features+1"],
    ridge: float,
) -> tuple[float, Float64[np.ndarray, " features"]]:
    """Intercept and slopes of least loss, pulled towards `towards`, which holds the intercept first."""
    x = np.c_[np.ones(len(z)), z]
    weights = towards.copy()
    for _ in range(NEWTON_STEPS):
        p = 1 / (1 + np.exp(-np.clip(x @ weights, -30, 30)))
        gradient = x.T @ (y - p) / len(y) - ridge * (weights - towards)
        hessian = (x * (p * (1 - p))[:, None]).T @ x / len(y) + ridge * np.eye(len(weights))
        step = np.linalg.solve(hessian, gradient)
        weights += step * min(1.0, 5.0 / max(float(np.abs(step).max()), 1e-12))
    return float(weights[0]), weights[1:]


def _of_the_worst_part(parts: ConfidenceModel, found: Observations) -> ConfidenceModel:
    """The model of single parts, recalibrated to speak for all of them at once (Platt scaling of the lowest logit)."""
    lowest = parts.logit(found.features).min(axis=1)
    right = np.asarray(found.correct.all(axis=1), np.float64)
    bias, slopes = _newton(lowest[:, None], right, np.array([0.0, 1.0]), PLATT_RIDGE)
    slope = max(float(slopes[0]), 0.1)
    weights = {name: slope * weight for name, weight in parts.weights.items()}
    return ConfidenceModel(bias + slope * parts.bias, weights)


def auroc(confidence: Float64[np.ndarray, " steps"], correct: Bool[np.ndarray, " steps"]) -> float:
    """Probability that a right step is trusted more than a wrong one (Mann–Whitney); NaN without both kinds."""
    right, wrong = np.sort(confidence[correct]), confidence[~correct]
    if not len(right) or not len(wrong):
        return float("nan")
    below, upto = np.searchsorted(right, wrong, "left"), np.searchsorted(right, wrong, "right")
    return float((len(right) - (below + upto) / 2).sum() / (len(right) * len(wrong)))

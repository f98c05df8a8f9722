"""Fits the confidence to what a step knows, on sequences apart from training and test."""

from collections.abc import Iterable
from dataclasses import dataclass, fields

import numpy as np
from jaxtyping import Bool, Float64

from captra.data.recordings import Recording
from captra.evaluation.observability import symmetric_frames
from captra.health import ConfidenceModel
from captra.metrics import rotation_error_deg, translation_error_cm, within
from captra.perturbation import perturb
from captra.sampling import NoPointsError
from captra.tracker import Networks, Tracker

START_SPREADS = (1.0, 3.0, 6.0)
"""Errors of the first pose, in units of the training perturbation: from tracks that hold to tracks that never do."""

RIDGE = 1e-3
NEWTON_STEPS = 50
LIKELIEST_LOGIT = 12.0


@dataclass(frozen=True)
class Observations:
    """What steps knew, and whether they were right."""

    features: Float64[np.ndarray, "steps features"]
    """As `ConfidenceModel.features` orders them."""
    correct: Bool[np.ndarray, " steps"]
    """Within 5° and 5 cm."""


def observe(networks: Networks, recordings: Iterable[Recording], seed: int = 0) -> Observations:
    """Track every recording from several starts and note evidence and truth of every part and frame."""
    rng = np.random.default_rng(seed)
    features, correct = [], []
    for recording in recordings:
        symmetric = symmetric_frames(recording)
        for spread in START_SPREADS:
            tracker = Tracker(networks, perturb(recording.truth(0), recording.category, rng, spread))
            for frame in range(1, len(recording)):
                try:
                    result = tracker.step(recording.clouds[frame])
                except NoPointsError:
                    break
                truth = recording.truth(frame)
                rotation = rotation_error_deg(result.pose.rotation, truth.rotation, symmetric=bool(symmetric[frame]))
                translation = translation_error_cm(result.pose.translation, truth.translation)
                features += [ConfidenceModel.features(part) for part in result.evidence.parts]
                correct += list(within(rotation, translation))
    return Observations(np.array(features), np.array(correct))


def fit(observations: Observations) -> ConfidenceModel:
    """Logistic regression by Newton's method, with a slight pull towards zero.

    Raises:
        ValueError: when all steps were right, or none.
    """
    if len(set(observations.correct.tolist())) < 2:
        raise ValueError("all steps were right, or none: calibrate on sequences that include both")
    x = np.c_[np.ones(len(observations.features)), observations.features]
    y = observations.correct.astype(np.float64)
    spread = np.maximum(x.std(axis=0), 1e-9)
    spread[0] = 1.0
    z, weights = x / spread, np.zeros(x.shape[1])
    for _ in range(NEWTON_STEPS):
        p = 1 / (1 + np.exp(-np.clip(z @ weights, -LIKELIEST_LOGIT, LIKELIEST_LOGIT)))
        gradient = z.T @ (y - p) / len(y) - RIDGE * weights
        hessian = (z * (p * (1 - p))[:, None]).T @ z / len(y) + RIDGE * np.eye(len(weights))
        weights += np.linalg.solve(hessian, gradient)
    names = [field.name for field in fields(ConfidenceModel)]
    return ConfidenceModel(**dict(zip(names, map(float, weights / spread), strict=True)))


def auroc(confidence: Float64[np.ndarray, " steps"], correct: Bool[np.ndarray, " steps"]) -> float:
    """Probability that a right step is trusted more than a wrong one (Mann–Whitney)."""
    order = np.argsort(np.argsort(confidence, kind="stable"), kind="stable") + 1.0
    right, wrong = int(correct.sum()), int((~correct).sum())
    return float((order[correct].sum() - right * (right + 1) / 2) / (right * wrong))


def confidences(model: ConfidenceModel, observations: Observations) -> Float64[np.ndarray, " steps"]:
    """The model's confidence in every step."""
    return np.array([model.probability(row) for row in observations.features])

"""Fits how much of a track's past its belief keeps, on tracks whose truth is known."""

import itertools
from collections.abc import Sequence

import numpy as np
from jaxtyping import Bool, Float64

from captra.belief import SUREST, Persistence
from captra.confidence import ConfidenceModel
from captra.evaluation.watching import Watched

STAYS = (0.9, 0.95, 0.98, 0.99)
RETURNS = (0.03, 0.06, 0.1, 0.2)
WEIGHTS = (0.3, 0.45, 0.6, 0.8, 1.0)


def fit_persistence(model: ConfidenceModel, watched: Sequence[Watched]) -> Persistence:
    """The parameters under which these tracks, with this model of single frames, are likeliest."""
    told = [confidences(model, one) for one in watched]
    right = [np.asarray(one.found.all(axis=1)) for one in watched]
    known = np.concatenate(right)[np.isfinite(np.concatenate(told))]
    usual = float(np.clip(known.mean(), 0.05, 0.95))
    candidates = [Persistence(*choice, usual) for choice in itertools.product(STAYS, RETURNS, WEIGHTS)]
    return min(candidates, key=lambda one: sum(map(_surprise, [believed(one, mine) for mine in told], right)))


def confidences(model: ConfidenceModel, one: Watched) -> Float64[np.ndarray, " frames"]:
    """What a model says of each frame by itself: of its worst part, and NaN where there was nothing to look at."""
    return np.asarray(1 / (1 + np.exp(-model.logit(one.features).min(axis=1))))


def believed(belief: Persistence, told: Float64[np.ndarray, " frames"]) -> Float64[np.ndarray, " frames"]:
    """What a track that begins from a given pose believes after each frame; frames without points tell of a loss."""
    found, confidence = np.empty(len(told)), 1.0
    for frame, alone in enumerate(np.nan_to_num(told, nan=0.0).tolist()):
        found[frame] = confidence = belief.updated(confidence, alone)
    return found


def _surprise(confidence: Float64[np.ndarray, " frames"], right: Bool[np.ndarray, " frames"]) -> float:
    return float(-np.log(np.where(right, confidence, 1 - confidence) + SUREST).sum())

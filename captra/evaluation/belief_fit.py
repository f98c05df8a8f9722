"""How much each frame of a track tells that those before it did not: fitted to tracks whose truth is known."""

from collections.abc import Sequence

import numpy as np

from captra.belief import Belief, Persistence
from captra.confidence import ConfidenceModel
from captra.evaluation.thresholds import confidences
from captra.evaluation.watching import Watched

SHARES_OF_NEWS = (1.0, 0.7, 0.5, 0.35, 0.25, 0.15)
"""To try, the usual one first."""


def fit_belief(model: ConfidenceModel, watched: Sequence[Watched], usual: float) -> Persistence:
    """The belief of least log loss on these tracks, for frames that are right as often as `usual`."""
    beliefs = [Persistence(usual, news=news) for news in SHARES_OF_NEWS]
    return min(beliefs, key=lambda belief: np.mean([_log_loss(belief, model, one) for one in watched]))


def _log_loss(belief: Belief, model: ConfidenceModel, one: Watched) -> float:
    """Mean over the frames of a track of how surprising the truth is to whoever believes this."""
    believed, losses = 1.0, list[float]()
    for told, correct in zip(confidences(model, one).tolist(), one.correct.tolist(), strict=True):
        if np.isfinite(told):
            believed = belief.updated(believed, told)
            losses.append(-np.log(believed if correct else 1 - believed))
    return float(np.mean(losses)) if losses else 0.0

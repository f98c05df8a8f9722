"""What a track's past says of its present: one that held mostly holds on, one that was lost mostly stays lost."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Protocol

import numpy as np

SUREST = 1e-6
"""No frame is surer than this to be wrong, nor to be right."""


class Belief(Protocol):
    """Weighs what a frame tells against what was believed before it."""

    def updated(self, before: float, told: float) -> float:
        """Probability that the pose is right, from that before the frame and that which the frame alone tells."""

    @property
    def calibration(self) -> dict[str, float]:
        """What a manifest keeps; nothing for one that has no parameters."""


@dataclass(frozen=True)
class Forgetful:
    """Believes every frame by itself."""

    def updated(self, before: float, told: float) -> float:  # noqa: ARG002 - asked for by the protocol
        """What the frame tells."""
        return told

    @property
    def calibration(self) -> dict[str, float]:
        """Nothing."""
        return {}


@dataclass(frozen=True)
class Persistence:
    """A hidden Markov model of two states, right and wrong.

    What a frame alone tells is a probability among `usual` ones, so its odds over the usual odds are the likelihood
    ratio.
    """

    usual: float = 0.65
    """Share of right frames among those that the confidence was fitted to."""
    stays: float = 0.95
    """Probability that a right track is right in the next frame."""
    returns: float = 0.1
    """Probability that a wrong one is."""
    news: float = 1.0
    """Share of a frame's log odds that those before it did not tell: frames of one object look alike, and are doubted
    for the same reason every time."""

    def updated(self, before: float, told: float) -> float:
        """The posterior."""
        prior = self.stays * before + self.returns * (1 - before)
        return sigmoid(logit(prior) + self.news * (logit(told) - logit(self.usual)))

    @property
    def calibration(self) -> dict[str, float]:
        """All parameters."""
        return asdict(self)


FORGETFUL: Belief = Forgetful()


def belief_of(calibration: Mapping[str, Any]) -> Belief:
    """The belief whose `calibration` this is."""
    return Persistence(**calibration) if calibration else FORGETFUL


def logit(probability: float) -> float:
    """Log odds, of no more than `SUREST`."""
    bounded = min(max(probability, SUREST), 1 - SUREST)
    return float(np.log(bounded / (1 - bounded)))


def sigmoid(log_odds: float) -> float:
    """The probability of log odds."""
    return float(1 / (1 + np.exp(-log_odds)))

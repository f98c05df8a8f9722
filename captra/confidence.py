"""From evidence to the calibrated probability that a pose is within 5° and 5 cm."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from jaxtyping import Float64

from captra.evidence import Evidence, PartEvidence

FEATURES = (
    "residual",
    "outliers",
    "disagreement",
    "few_points",
    "sparse_cloud",
    "rotation_jump",
    "translation_jump",
    "scale_jump",
    "shape_jump",
    "spread",
    "unfilled",
    "doubtful_mask",
    "outside_box",
    "flat",
    "diagonal_error",
    "guessed_turn",
    "vanished",
    "stood_still",
)
"""What the model weighs, all of it bad news."""

OWN = [FEATURES.index(name) for name in ("few_points", "stood_still")]
"""Features that a part does not share with what it goes with."""

UNCALIBRATED: Mapping[str, float] = MappingProxyType(
    {
        "residual": -2.3,
        "outliers": -1.5,
        "disagreement": -2.6,
        "few_points": -0.3,
        "sparse_cloud": -8.0,
        "rotation_jump": -1.0,
        "translation_jump": -0.5,
        "scale_jump": -2.0,
        "shape_jump": -1.0,
        "spread": -1.2,
        "unfilled": -0.1,
        "doubtful_mask": -9.0,
        "outside_box": -0.5,
        "flat": -0.6,
        "diagonal_error": -9.0,
        "guessed_turn": -2.0,
        "vanished": -1.0,
        "stood_still": -2.0,
    }
)
"""Weights that suit most categories: a fit to validation sequences of several of them at once.

That of `stood_still` is smaller than theirs, where hinges always move: elsewhere most of them rest.
"""

LIKELIEST_LOGIT = 12.0
LONG_STOOD = 10.0
"""Frames after which it hardly matters any more for how long nothing has told how a hinge stands: most rest, so that a
part that is hidden for good is doubted, but not lost for that."""
FLAT_THICKNESS = 0.02
"""Thickness, in units of the scale, that noise gives to a board."""


def features(evidence: Evidence) -> Float64[np.ndarray, "parts features"]:
    """Every part's evidence in the order of `FEATURES`; logarithms, since what matters are ratios.

    A part that goes with another is as right as that one, as far as its turn is the other's; but it has points of its
    own, few or not, and whether its joint moved meanwhile is not seen.
    """
    stood = {ride.part: ride.stood for ride in evidence.rides}
    rows = np.stack([_features(part, evidence, stood.get(i, 0.0)) for i, part in enumerate(evidence.parts)])
    own = rows[:, OWN].copy()
    for ride in evidence.rides:
        rows[ride.part] = ride.turned * rows[ride.part] + (1 - ride.turned) * rows[ride.by]
    rows[:, OWN] = own
    return rows


def _features(part: PartEvidence, evidence: Evidence, stood: float) -> Float64[np.ndarray, " features"]:
    return np.array(
        [
            np.log(max(part.residual, 1e-3) / 0.02),
            1 - part.inliers,
            np.log1p(10 * part.disagreement_rad),
            -np.log(part.share + 0.005),
            np.exp(-evidence.distinct_points / 100),
            np.log1p(10 * part.rotation_jump_rad),
            np.log1p(10 * part.translation_jump),
            np.log1p(10 * part.scale_jump),
            np.log1p(10 * part.shape_jump),
            np.log(part.spread + 1e-3) - np.log(1e-3),
            1 - part.filled,
            1 - part.certainty,
            np.log1p(20 * part.outside),
            np.exp(-part.thickness / FLAT_THICKNESS),
            part.diagonal_error,
            part.guessed_turn,
            evidence.vanished,
            1 - np.exp(-stood / LONG_STOOD),
        ]
    )


@dataclass(frozen=True)
class ConfidenceModel:
    """Logistic regression on the evidence of the worst part."""

    bias: float = 7.3
    """Logit of perfect evidence."""
    weights: Mapping[str, float] = field(default_factory=lambda: UNCALIBRATED)
    """Change of the logit per unit of each feature; one that is not named, in older manifests, says nothing."""

    def logit(self, features: Float64[np.ndarray, "*rows features"]) -> Float64[np.ndarray, "*rows"]:
        """Log odds that parts with these features are within 5° and 5 cm."""
        weights = np.array([self.weights.get(name, 0.0) for name in FEATURES])
        return np.asarray(np.clip(self.bias + features @ weights, -LIKELIEST_LOGIT, LIKELIEST_LOGIT))

    def __call__(self, evidence: Evidence) -> float:
        """Probability that the pose of every part is right: that of the worst one; none where evidence is no number."""
        worst = self.logit(features(evidence)).min()  # NaN if any is
        return float(1 / (1 + np.exp(-worst))) if np.isfinite(worst) else 0.0

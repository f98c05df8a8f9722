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
)
"""What the model weighs, all of it bad news."""

JUMPS = ("rotation_jump", "translation_jump", "scale_jump")
"""Those that a search around an old pose cannot avoid."""

UNCALIBRATED: Mapping[str, float] = MappingProxyType(
    {
        "residual": -1.5,
        "outliers": -3.0,
        "disagreement": -1.0,
        "few_points": -0.5,
        "sparse_cloud": -2.0,
        "rotation_jump": -0.5,
        "translation_jump": -0.5,
        "scale_jump": -0.5,
        "shape_jump": -0.5,
        "spread": -0.3,
        "unfilled": -1.0,
        "doubtful_mask": -2.0,
        "outside_box": -0.5,
        "flat": -1.0,
        "diagonal_error": -1.0,
    }
)
"""Weights before anything was calibrated: the right signs, and roughly the right size."""

LIKELIEST_LOGIT = 12.0
FLAT_THICKNESS = 0.02
"""Thickness, in units of the scale, that noise gives to a board."""


def features(part: PartEvidence, distinct_points: int) -> Float64[np.ndarray, " features"]:
    """One part's evidence in the order of `FEATURES`; logarithms, since what matters are ratios."""
    return np.array(
        [
            np.log(max(part.residual, 1e-3) / 0.02),
            1 - part.inliers,
            np.log1p(10 * part.disagreement_rad),
            -np.log(part.share + 0.005),
            np.exp(-distinct_points / 100),
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
        ]
    )


@dataclass(frozen=True)
class ConfidenceModel:
    """Logistic regression on the evidence of the worst part."""

    bias: float = 3.2
    """Logit of perfect evidence."""
    weights: Mapping[str, float] = field(default_factory=lambda: UNCALIBRATED)
    """Change of the logit per unit of each feature; one that is not named, in older manifests, says nothing."""

    def logit(self, features: Float64[np.ndarray, "*rows features"]) -> Float64[np.ndarray, "*rows"]:
        """Log odds that parts with these features are within 5° and 5 cm."""
        weights = np.array([self.weights.get(name, 0.0) for name in FEATURES])
        return np.asarray(np.clip(self.bias + features @ weights, -LIKELIEST_LOGIT, LIKELIEST_LOGIT))

    def __call__(self, evidence: Evidence) -> float:
        """Probability that the pose of every part is right: that of the worst one."""
        return self._worst(np.stack([features(part, evidence.distinct_points) for part in evidence.parts]))

    def regardless_of_jumps(self, evidence: Evidence) -> float:
        """The same for a pose that was looked for where it was not expected: only the fit itself counts."""
        rows = np.stack([features(part, evidence.distinct_points) for part in evidence.parts])
        rows[:, [FEATURES.index(name) for name in JUMPS]] = 0
        return self._worst(rows)

    def _worst(self, rows: Float64[np.ndarray, "parts features"]) -> float:
        return float(1 / (1 + np.exp(-self.logit(rows).min())))

"""How far a result can be trusted: confidence from what a step knows, and a state with hysteresis."""

from dataclasses import dataclass, field, replace
from enum import StrEnum

import numpy as np
from jaxtyping import Float64


class State(StrEnum):
    """Whether the track holds."""

    TRACKING = "tracking"
    UNCERTAIN = "uncertain"
    LOST = "lost"
    RECOVERING = "recovering"


@dataclass(frozen=True)
class PartEvidence:
    """How well one part's fit explains the points."""

    points: int
    """Points labelled as the part."""
    centroid: Float64[np.ndarray, "3"]
    """Their mean, metres, in the frame of the cloud; the part's centre for a part that could not be fitted."""
    residual: float
    """RMS distance between fitted coordinates and points, in units of the scale."""
    inliers: float
    """Fraction of the part's points that agree with the fit."""
    disagreement_rad: float
    """Angle between RotationNet's rotation and that of the full Umeyama fit."""
    rotation_jump_rad: float
    """Angle to the last pose."""
    translation_jump: float
    """Distance to the last pose, in units of the last scale."""
    scale_jump: float
    """Absolute logarithm of the ratio to the last scale."""

    @staticmethod
    def missing(points: int, centre: Float64[np.ndarray, "3"]) -> "PartEvidence":
        """Evidence of a part that could not be fitted and keeps its centre."""
        return PartEvidence(points, centre, 1.0, 0.0, np.pi, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Evidence:
    """Everything that confidence is computed from."""

    parts: tuple[PartEvidence, ...]
    """One entry a part."""
    foreground: float
    """Mean probability, over the network's points, of belonging to the object."""

    @property
    def centroid(self) -> Float64[np.ndarray, "parts 3"]:
        """Mean of each part's points."""
        return np.stack([part.centroid for part in self.parts])


@dataclass(frozen=True)
class ConfidenceModel:
    """Logistic regression on the evidence of the worst part; the fields' order is that of `features`."""

    bias: float = 5.0
    """Logit of perfect evidence."""
    residual: float = -30.0
    """Per unit of residual (fraction of the box diagonal)."""
    outliers: float = -2.0
    """Per fraction of the part's points that disagree with the fit."""
    disagreement: float = -6.0
    """Per radian between the two rotations."""
    few_points: float = -4.0
    """When a part has no points at all; fades out towards fifty."""
    jump: float = -6.0
    """Per unit of motion: radians, scales and logarithms of scale added up."""

    @staticmethod
    def features(part: PartEvidence) -> Float64[np.ndarray, " features"]:
        """What the model weighs, all of it bad news."""
        jump = part.rotation_jump_rad + part.translation_jump + part.scale_jump
        few = float(np.exp(-part.points / 50.0))
        return np.array([part.residual, 1 - part.inliers, part.disagreement_rad, few, jump])

    def probability(self, features: Float64[np.ndarray, " features"]) -> float:
        """That a part with these features is within 5° and 5 cm."""
        weights = (self.residual, self.outliers, self.disagreement, self.few_points, self.jump)
        logit = self.bias + float(np.dot(weights, features))
        return float(1.0 / (1.0 + np.exp(-np.clip(logit, -30.0, 30.0))))

    def __call__(self, evidence: Evidence) -> float:
        """Probability that the pose of every part is right: that of the worst one."""
        return min(self.probability(self.features(part)) for part in evidence.parts)


@dataclass(frozen=True)
class HealthMonitor:
    """State of a track: two thresholds, so that it does not flicker, and patience before it is called lost or found."""

    confidence_of: ConfidenceModel = field(default_factory=ConfidenceModel)
    """The calibrated model."""
    doubt_below: float = 0.3
    """Confidence under which a frame counts against the track."""
    trust_above: float = 0.6
    """Confidence over which a frame counts for it."""
    patience: int = 4
    """Frames in doubt before the track is lost, and frames of trust before it is tracking again."""
    state: State = State.TRACKING
    """Verdict on the last frame."""
    confidence: float = 1.0
    """Confidence of the last frame; 1 for a pose that was given."""
    streak: int = 0
    """Frames in doubt, or of trust while recovering, in a row."""

    def restarted(self) -> "HealthMonitor":
        """The monitor of a track that starts from a given pose."""
        return replace(self, state=State.TRACKING, confidence=1.0, streak=0)

    def updated(self, evidence: Evidence) -> "HealthMonitor":
        """The monitor after one more frame."""
        confidence = self.confidence_of(evidence)
        state, streak = self._next(confidence)
        return replace(self, state=state, confidence=confidence, streak=streak)

    def _next(self, confidence: float) -> tuple[State, int]:
        if confidence < self.doubt_below:
            doubt = self.streak + 1 if self.state is State.UNCERTAIN else 1
            lost = self.state is State.LOST or self.state is State.RECOVERING or doubt >= self.patience
            return (State.LOST, 0) if lost else (State.UNCERTAIN, doubt)
        if self.state in (State.LOST, State.RECOVERING):
            if confidence < self.trust_above:
                return self.state, 0
            trust = self.streak + 1
            return (State.TRACKING, 0) if trust >= self.patience else (State.RECOVERING, trust)
        if self.state is State.UNCERTAIN and confidence < self.trust_above:
            return State.UNCERTAIN, self.streak
        return State.TRACKING, 0

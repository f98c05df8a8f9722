"""How far a result can be trusted: confidence from what a step knows, and a state with hysteresis."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from captra.belief import FORGETFUL, Belief, belief_of
from captra.confidence import ConfidenceModel


class State(StrEnum):
    """Whether the track holds."""

    TRACKING = "tracking"
    UNCERTAIN = "uncertain"
    LOST = "lost"
    RECOVERING = "recovering"


@dataclass(frozen=True)
class HealthMonitor:
    """State of a track: two thresholds, so that it does not flicker, and patience before it is called lost or found."""

    confidence_of: ConfidenceModel = field(default_factory=ConfidenceModel)
    """The calibrated model."""
    doubt_below: float = 0.05
    """Confidence under which a frame counts against the track."""
    trust_above: float = 0.3
    """Confidence over which a frame counts for it."""
    patience: int = 3
    """Frames in doubt, with none of trust between them, before the track is lost; and frames of trust in a row before
    it is tracking again."""
    belief: Belief = FORGETFUL
    """What becomes of a frame's own confidence in the light of those before it."""
    state: State = State.TRACKING
    """Verdict on the last frame."""
    confidence: float = 1.0
    """Confidence of the last frame; 1 for a pose that was given."""
    streak: int = 0
    """Frames in doubt since the last one of trust, or frames of trust in a row while recovering."""
    missed_frames: int = 0
    """Frames without any point near the object, in a row."""

    def restarted(self) -> "HealthMonitor":
        """The monitor of a track that starts from a given pose."""
        return replace(self, state=State.TRACKING, confidence=1.0, streak=0, missed_frames=0)

    @staticmethod
    def calibrated(health: Mapping[str, Any]) -> "HealthMonitor":
        """The monitor that a manifest's `health` describes; the defaults where it was never calibrated."""
        if "weights" not in health:
            return HealthMonitor()
        model = ConfidenceModel(health["bias"], dict(health["weights"]))
        belief = belief_of(health.get("belief", {}))
        return HealthMonitor(model, health["doubt_below"], health["trust_above"], belief=belief)

    @property
    def calibration(self) -> dict[str, Any]:
        """What a manifest keeps: the inverse of `calibrated`."""
        model = self.confidence_of
        return {
            "bias": model.bias,
            "weights": dict(model.weights),
            "doubt_below": self.doubt_below,
            "trust_above": self.trust_above,
            "belief": self.belief.calibration,
        }

    @property
    def trusted(self) -> bool:
        """Whether the last pose is worth going back to."""
        return self.state is State.TRACKING

    def updated(self, told: float) -> "HealthMonitor":
        """The monitor after one more frame, which by itself gives its pose this confidence."""
        confidence = self.belief.updated(self.confidence, told)
        state, streak = self._next(confidence)
        return replace(self, state=state, confidence=confidence, streak=streak, missed_frames=0)

    def missed(self) -> "HealthMonitor":
        """The monitor after a frame without any point near the object: one alone changes nothing.

        As soon as another follows, both count against the track, and nothing speaks for it.
        """
        missed = self.missed_frames + 1
        if missed == 1:
            return replace(self, missed_frames=missed)
        before = self._doubted() if missed == 2 else self
        return replace(before._doubted(), missed_frames=missed)

    def _doubted(self) -> "HealthMonitor":
        state, streak = self._next(0.0)
        return replace(self, state=state, confidence=0.0, streak=streak)

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

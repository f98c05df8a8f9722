"""What a session asks of its track beyond the paper's method: all that another process needs to go on likewise."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal

from captra.joint_projection import OntoAxes
from captra.motion import STANDING_STILL, ConstantVelocity, MotionModel
from captra.output_filter import UNFILTERED, OneEuro
from captra.recovery import NO_SEARCH, SearchBudget, TimeBudget
from captra.tracker import TrackerOptions

Prediction = Literal["none", "constant-velocity"]
PREDICTIONS: Mapping[str, MotionModel] = MappingProxyType(
    {"none": STANDING_STILL, "constant-velocity": ConstantVelocity()}
)
"""How the next pose is expected, by the names that clients use."""


@dataclass(frozen=True)
class Smoothing:
    """Settings of the One-Euro filter on published poses."""

    cutoff_hz: float
    """Cut-off frequency at rest."""
    translation_gain: float
    """Hertz of cut-off per m/s."""
    rotation_gain: float
    """Hertz of cut-off per rad/s."""


@dataclass(frozen=True)
class TrackOptions:
    """Options of one session."""

    prediction: str = "none"
    """A name of `PREDICTIONS`."""
    smoothing: Smoothing | None = None
    """Of published poses; none publishes what was found."""
    joint_axes: Mapping[str, tuple[float, float, float]] | None = None
    """Axes, in the parent's frame, that parts may turn about, by joint; those not named are the category's own.
    None leaves it to the bundle."""

    @staticmethod
    def from_json(fields: Mapping[str, Any]) -> "TrackOptions":
        """The options whose fields were written as JSON.

        Raises:
            TypeError, KeyError, ValueError: they are none.
        """
        smoothing, axes = fields["smoothing"], fields["joint_axes"]
        return TrackOptions(
            prediction=fields["prediction"],
            smoothing=None if smoothing is None else Smoothing(**smoothing),
            joint_axes=None if axes is None else {name: (x, y, z) for name, (x, y, z) in axes.items()},
        )

    def tracker_options(self, search_budget_ms: float) -> TrackerOptions:
        """Options of a new tracker, which searches for so many milliseconds a frame while it is not sure; 0 never."""
        search: SearchBudget = TimeBudget(search_budget_ms) if search_budget_ms > 0 else NO_SEARCH
        smooth = self.smoothing
        return TrackerOptions(
            motion=PREDICTIONS[self.prediction],
            search=search,
            projection=None if self.joint_axes is None else OntoAxes(self.joint_axes),
            output_filter=UNFILTERED
            if smooth is None
            else OneEuro(smooth.cutoff_hz, smooth.translation_gain, smooth.rotation_gain),
        )

"""Smooths the poses that are published; what the tracker goes on from stays as it is."""

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from jaxtyping import Float64

from captra.geometry import Pose, rotation_from_vector, rotation_vector

UNSTAMPED_FRAME_S = 1 / 30
"""Time between frames that have no stamps."""


class OutputFilter(Protocol):
    """Smooths a sequence of poses."""

    def restarted(self) -> "OutputFilter":
        """The filter of a track that starts from a given pose."""

    def filtered(self, pose: Pose, time_s: float | None) -> tuple[Pose, "OutputFilter"]:
        """The pose to publish, and the filter after it."""


class Unfiltered:
    """Publishes what was found."""

    def restarted(self) -> "Unfiltered":
        """Itself: it remembers nothing."""
        return self

    def filtered(self, pose: Pose, time_s: float | None) -> tuple[Pose, "Unfiltered"]:  # noqa: ARG002 - asked for
        """What came in."""
        return pose, self


@dataclass(frozen=True)
class OneEuro:
    """The One-Euro filter on translations and rotations: still objects rest, fast ones do not lag.

    A low-pass filter whose cut-off frequency rises with speed (Casiez, Roussel and Vogel, CHI 2012). Sizes pass.
    """

    cutoff_hz: float = 1.0
    """Cut-off frequency at rest: less jitters less and lags more."""
    translation_gain: float = 10.0
    """Hertz of cut-off per m/s."""
    rotation_gain: float = 2.0
    """Hertz of cut-off per rad/s."""
    speed_cutoff_hz: float = 1.0
    """Cut-off frequency of the filter on the speed itself."""
    pose: Pose | None = None
    """The last published pose; none before the first."""
    time_s: float | None = None
    """Its time."""
    linear: Float64[np.ndarray, "parts 3"] | None = None
    """Filtered velocity, m/s."""
    angular: Float64[np.ndarray, "parts 3"] | None = None
    """Filtered angular velocity, rad/s."""

    def restarted(self) -> "OneEuro":
        """The filter before its first pose."""
        return replace(self, pose=None, time_s=None, linear=None, angular=None)

    def filtered(self, pose: Pose, time_s: float | None) -> tuple[Pose, "OneEuro"]:
        """The pose to publish, and the filter after it; frames out of order pass as they are."""
        elapsed_s = self._elapsed_s(time_s)
        if self.pose is None or self.linear is None or self.angular is None or elapsed_s <= 0:
            nothing = np.zeros_like(pose.translation)
            return pose, replace(self, pose=pose, time_s=time_s, linear=nothing, angular=nothing)
        step = pose.translation - self.pose.translation
        turn = rotation_vector(pose.rotation @ np.swapaxes(self.pose.rotation, -1, -2))
        follow = _smoothing(self.speed_cutoff_hz, elapsed_s)
        linear = self.linear + follow * (step / elapsed_s - self.linear)
        angular = self.angular + follow * (turn / elapsed_s - self.angular)
        step_share = _smoothing(self.cutoff_hz + self.translation_gain * _lengths(linear), elapsed_s)
        turn_share = _smoothing(self.cutoff_hz + self.rotation_gain * _lengths(angular), elapsed_s)
        smooth = replace(
            pose,
            translation=self.pose.translation + step_share * step,
            rotation=rotation_from_vector(turn_share * turn) @ self.pose.rotation,
        )
        return smooth, replace(self, pose=smooth, time_s=time_s, linear=linear, angular=angular)

    def _elapsed_s(self, time_s: float | None) -> float:
        return UNSTAMPED_FRAME_S if time_s is None or self.time_s is None else time_s - self.time_s


def _lengths(vectors: Float64[np.ndarray, "parts 3"]) -> Float64[np.ndarray, "parts 1"]:
    return np.asarray(np.linalg.norm(vectors, axis=-1, keepdims=True))


def _smoothing(cutoff_hz: Float64[np.ndarray, "parts 1"] | float, elapsed_s: float) -> Float64[np.ndarray, "parts 1"]:
    """Share of a difference that a first-order low-pass filter takes up in one step."""
    ratio = 2 * np.pi * np.asarray(cutoff_hz) * elapsed_s
    return np.asarray(ratio / (ratio + 1))


UNFILTERED: OutputFilter = Unfiltered()

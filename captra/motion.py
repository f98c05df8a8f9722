"""Where an object is expected in the next frame: where it was, or where its velocity carries it."""

from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from jaxtyping import Float64

from captra.geometry import Pose, rotation_from_vector, rotation_vector

FRAME_S = 1.0
"""Unit of time where frames have no stamps."""


class MotionModel(Protocol):
    """Expects poses."""

    def restarted(self, pose: Pose) -> "MotionModel":
        """The model of a track that starts from a given pose."""

    def expected(self, time_s: float | None) -> Pose:
        """Where every part should be at a time; without one, a frame after the last."""

    def observed(self, pose: Pose, time_s: float | None, *, trusted: bool) -> "MotionModel":
        """The model after one more pose; one that is not trusted says nothing about velocity."""


@dataclass(frozen=True)
class StandStill:
    """Expects every part where it was, as the paper does."""

    pose: Pose | None = None
    """The last pose."""

    def restarted(self, pose: Pose) -> "StandStill":
        """The model of a track that starts from a given pose."""
        return StandStill(pose)

    def expected(self, time_s: float | None) -> Pose:  # noqa: ARG002 - asked for by the protocol
        """The last pose."""
        return _started(self.pose)

    def observed(self, pose: Pose, time_s: float | None, *, trusted: bool) -> "StandStill":  # noqa: ARG002 - likewise
        """The model after one more pose."""
        return StandStill(pose)


@dataclass(frozen=True)
class ConstantVelocity:
    """Expects every part to go on as it moved in the last frames.

    Velocities are running means of differences between poses; they fade by `damping` in each prediction, so that noise
    in them does not push an object that rests.
    """

    gain: float = 0.5
    """Weight of the newest difference in the running mean of velocities."""
    damping: float = 0.8
    """Share of the velocity that a prediction uses."""
    longest_s: float = 0.5
    """A longer pause says nothing about where the object went."""
    pose: Pose | None = None
    """The last pose."""
    time_s: float | None = None
    """Its time; none for a given pose."""
    linear: Float64[np.ndarray, "parts 3"] | None = None
    """Metres per second (per frame where there are no stamps); none before the second trusted pose."""
    angular: Float64[np.ndarray, "parts 3"] | None = None
    """Radians per second about the axes of the cloud's frame."""

    def restarted(self, pose: Pose) -> "ConstantVelocity":
        """The model of a track that starts from a given pose: it is at rest as far as anyone knows."""
        return replace(self, pose=pose, time_s=None, linear=None, angular=None)

    def expected(self, time_s: float | None) -> Pose:
        """The last pose, carried on."""
        pose, elapsed = _started(self.pose), self._elapsed(time_s)
        if self.linear is None or self.angular is None or not 0 < elapsed <= self._longest(time_s):
            return pose
        ahead = self.damping * elapsed
        return replace(
            pose,
            translation=pose.translation + ahead * self.linear,
            rotation=rotation_from_vector(ahead * self.angular) @ pose.rotation,
        )

    def observed(self, pose: Pose, time_s: float | None, *, trusted: bool) -> "ConstantVelocity":
        """The model after one more pose."""
        last, elapsed = _started(self.pose), self._elapsed(time_s)
        if not trusted or not 0 < elapsed <= self._longest(time_s):
            return replace(self, pose=pose, time_s=time_s, linear=None, angular=None)
        linear = (pose.translation - last.translation) / elapsed
        angular = rotation_vector(pose.rotation @ np.swapaxes(last.rotation, -1, -2)) / elapsed
        if self.linear is not None and self.angular is not None:
            linear = self.linear + self.gain * (linear - self.linear)
            angular = self.angular + self.gain * (angular - self.angular)
        return replace(self, pose=pose, time_s=time_s, linear=linear, angular=angular)

    def _elapsed(self, time_s: float | None) -> float:
        if time_s is None:
            return FRAME_S
        return 0.0 if self.time_s is None else time_s - self.time_s

    def _longest(self, time_s: float | None) -> float:
        return FRAME_S if time_s is None else self.longest_s


def _started(pose: Pose | None) -> Pose:
    if pose is None:
        raise ValueError("the motion model has no pose yet: call restarted first")
    return pose


STANDING_STILL: MotionModel = StandStill()

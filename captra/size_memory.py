"""What a track remembers of the object's size: rigid parts do not grow, so every frame measures the same thing."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float64, Int64

from captra.geometry import Pose
from captra.pose_memory import USUAL_ERROR, FoundError

GIVEN_ERROR = 0.03
"""Standard deviation of the logarithm of a given size: whoever knows an object knows its size to some 3 %."""

FRAME_ERROR = 0.3
"""Likewise of what one frame adds to the error that networks always make, taken so large since frames that follow each
other err alike."""

SMALLEST_SIDE_M = 1e-4


@dataclass(frozen=True)
class SizeMemory:
    """The given size, and running means of what frames measured, all in logarithms."""

    given: Pose
    """Its scale and size are what was given."""
    given_error: float
    """Standard deviation of the logarithms of both."""
    found_error: FoundError
    """By how much networks err on one object's size however often they look."""
    mean_log_scale: Float64[np.ndarray, " parts"]
    """Of the measured scales, metres."""
    mean_log_size: Float64[np.ndarray, "parts 3"]
    """Of the measured boxes' sides, metres."""
    frames: Int64[np.ndarray, " parts"]
    """How many were measured of each part: one that is hidden keeps its size, which measures nothing."""

    @staticmethod
    def of(given: Pose, given_error: float = GIVEN_ERROR, found_error: FoundError = USUAL_ERROR) -> "SizeMemory":
        """Before the first frame: only the given pose is known."""
        parts = given.num_parts
        nothing = np.zeros(parts), np.zeros((parts, 3)), np.zeros(parts, np.int64)
        return SizeMemory(given, given_error, found_error, *nothing)

    def updated(self, measured: Pose, seen: Bool[np.ndarray, " parts"]) -> "SizeMemory":
        """After one more frame in which some parts were seen."""
        frames = self.frames + seen
        gain = seen / np.maximum(frames, 1)
        log_size = np.log(np.maximum(measured.size, SMALLEST_SIDE_M))
        return replace(
            self,
            mean_log_scale=self.mean_log_scale + gain * (np.log(measured.scale) - self.mean_log_scale),
            mean_log_size=self.mean_log_size + gain[:, None] * (log_size - self.mean_log_size),
            frames=frames,
        )

    @property
    def scale(self) -> Float64[np.ndarray, " parts"]:
        """What is believed of the scale, metres."""
        error = np.array(self.found_error.scale)[:, 0]
        return self._weighed(self.given.scale, self.mean_log_scale, error, self.frames)

    @property
    def size(self) -> Float64[np.ndarray, "parts 3"]:
        """What is believed of the box's sides, metres."""
        error = np.array(self.found_error.side) * self.given.scale[:, None] / self.given.size
        return self._weighed(self.given.size, self.mean_log_size, error, self.frames[:, None])

    def apply(self, measured: Pose, centroid: Float64[np.ndarray, "parts 3"]) -> Pose:
        """The measured pose at the remembered size.

        The translation that fits a scale s to points of mean c and rotated coordinates of mean w is c − s w, so another
        scale moves the centre towards or away from `centroid`, the mean of each part's points.
        """
        scale = self.scale
        translation = centroid + (scale / measured.scale)[:, None] * (measured.translation - centroid)
        return replace(measured, translation=translation, scale=scale, size=self.size)

    def _weighed(
        self,
        given: Float64[np.ndarray, "*sides"],
        mean_log: Float64[np.ndarray, "*sides"],
        error: Float64[np.ndarray, "..."],
        frames: Int64[np.ndarray, "..."],
    ) -> Float64[np.ndarray, "*sides"]:
        """Each counts by the inverse of its variance; a given size far from the measured one is doubted (Cauchy)."""
        measured_variance = error**2 + FRAME_ERROR**2 / np.maximum(frames, 1)
        difference = mean_log - np.log(given)
        given_variance = self.given_error**2 * (1 + difference**2 / (4 * measured_variance))
        share = given_variance / (given_variance + measured_variance)
        return np.where(frames > 0, given * np.exp(share * difference), given)

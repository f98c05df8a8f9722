"""What a track remembers of the object's size: rigid parts do not grow, so every frame measures the same thing."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float64

from captra.geometry import Pose

GIVEN_WEIGHT_FRAMES = 25.0
"""Frames that the size of a given pose is worth: it is known to some 2 %, one frame tells it to some 10 %."""


SMALLEST_SIDE_M = 1e-4


@dataclass(frozen=True)
class SizeMemory:
    """Running means, in logarithms, of the given size and of what each frame measured."""

    log_scale: Float64[np.ndarray, " parts"]
    """Logarithm of the scale, metres."""
    log_size: Float64[np.ndarray, "parts 3"]
    """Logarithm of the box's sides, metres."""
    weight_frames: float
    """What has gone into the means, in frames."""

    @staticmethod
    def of(given: Pose, weight_frames: float = GIVEN_WEIGHT_FRAMES) -> "SizeMemory":
        """Before the first frame: only the given pose is known."""
        return SizeMemory(np.log(given.scale), np.log(given.size), weight_frames)

    def updated(self, measured: Pose) -> "SizeMemory":
        """After one more frame."""
        gain = 1 / (self.weight_frames + 1)
        return SizeMemory(
            self.log_scale + gain * (np.log(measured.scale) - self.log_scale),
            self.log_size + gain * (np.log(np.maximum(measured.size, SMALLEST_SIDE_M)) - self.log_size),
            self.weight_frames + 1,
        )

    def apply(self, measured: Pose, centroid: Float64[np.ndarray, "parts 3"]) -> Pose:
        """The measured pose at the remembered size.

        The translation that fits a scale s to points of mean c and rotated coordinates of mean w is c − s w, so another
        scale moves the centre towards or away from `centroid`, the mean of each part's points.
        """
        scale = np.exp(self.log_scale)
        translation = centroid + (scale / measured.scale)[:, None] * (measured.translation - centroid)
        return replace(measured, translation=translation, scale=scale, size=np.exp(self.log_size))

"""Packed clouds: N×3 numbers of one type."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32

from captra.observations import PointCloud
from service.codecs.frames import Frame
from service.envelopes import Envelope, unpack_attachment
from service.rejections import (
    CoordinatesOutOfRangeError,
    NotFiniteError,
    TooManyPointsError,
    WrongByteCountError,
)

CLOUD_F32 = "application/vnd.captra.cloud.f32"
"""N×3 little-endian float32, metres."""
CLOUD_I16 = "application/vnd.captra.cloud.i16"
"""N×3 little-endian int16, tenths of a millimetre."""

LARGEST_COORDINATE_M = 1e6
"""Beyond it squares of distances lose their meaning in single precision."""


@dataclass(frozen=True)
class PackedCloudCodec:
    """N×3 numbers of one little-endian type, one point after the other."""

    encoding: str
    """Media type."""
    dtype: np.dtype[np.float32] | np.dtype[np.int16]
    """Type of one coordinate."""
    metres_per_unit: float
    """What one unit on the wire is worth."""
    max_points: int
    """Larger clouds are refused."""

    def open(self, envelope: Envelope) -> Frame:
        """Number and stamp from the attachment."""
        return Frame(unpack_attachment(envelope.attachment), lambda: PointCloud.of(self.points(envelope)))

    def points(self, envelope: Envelope) -> Float32[np.ndarray, "points 3"]:
        """Points in metres, maybe none: a view of the payload for metres in float32, otherwise one new array."""
        payload = envelope.payload
        bytes_per_point = 3 * self.dtype.itemsize
        count, remainder = divmod(len(payload), bytes_per_point)
        if remainder:
            raise WrongByteCountError(
                f"{len(payload)} bytes are no whole number of points: "
                f"{self.encoding} takes {bytes_per_point} bytes a point"
            )
        if count > self.max_points:
            raise TooManyPointsError(
                f"the cloud has {count} points, the limit is {self.max_points}: crop or thin it out before sending"
            )
        points = np.frombuffer(payload, self.dtype).reshape(count, 3).astype(np.float32, copy=False)
        if self.metres_per_unit != 1:
            points *= np.float32(self.metres_per_unit)
        check_coordinates(points)
        return points


def packed_codecs(max_points: int) -> tuple[PackedCloudCodec, ...]:
    """Metres and tenths of a millimetre."""
    metres = PackedCloudCodec(CLOUD_F32, np.dtype("<f4"), 1.0, max_points)
    return metres, PackedCloudCodec(CLOUD_I16, np.dtype("<i2"), 1e-4, max_points)


def check_coordinates(points: Float32[np.ndarray, "points 3"]) -> None:
    """Refuse what no camera can have seen.

    Raises:
        NotFiniteError: a coordinate is NaN or infinite.
        CoordinatesOutOfRangeError: a coordinate is beyond `LARGEST_COORDINATE_M`.
    """
    if points.size == 0:
        return
    lowest, highest = points.min(), points.max()  # both carry NaN through
    if not (np.isfinite(lowest) and np.isfinite(highest)):
        bad = int(np.count_nonzero(~np.isfinite(points).all(axis=1)))
        raise NotFiniteError(
            f"{bad} of {len(points)} points hold NaN or infinity: leave invalid pixels out (or is this another type "
            "than float32?)"
        )
    if max(-lowest, highest) > LARGEST_COORDINATE_M:
        raise CoordinatesOutOfRangeError(
            f"coordinates reach from {lowest:g} to {highest:g} m: clouds are in metres, in the camera frame (or are "
            "these numbers of another type, such as float64?)"
        )

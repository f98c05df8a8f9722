"""Clouds as bytes: the two encodings that the service reads, and how to fit a cloud into one Zenoh batch."""

import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from jaxtyping import Bool, Float

from clients.camera import Camera
from clients.regions import Box, Mask, Region

BATCH_BYTES = 65_000
"""What one Zenoh batch (65,535 bytes) holds beside its headers; more is cut up and may be lost as a whole."""
LARGEST_POINT = 16
"""No point has more numbers, with its colours and all: what is larger both ways is an image."""
I16_METRES = 1e-4
I16_RANGE_METRES = 32767 * I16_METRES


@dataclass(frozen=True)
class CloudEncoding:
    """One way to write a cloud."""

    media_type: str
    """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
    encode: Callable[[Float[np.ndarray, "points 3"]], bytes]
    """From metres to the payload."""
    can_express: Callable[[Float[np.ndarray, "points 3"]], Bool[np.ndarray, " points"]]
    """Which points go over the wire; the others are left out."""


def is_finite(points: Float[np.ndarray, "points 3"]) -> Bool[np.ndarray, " points"]:
    """Whether each point is one, and no pixel without depth."""
    return np.asarray(np.isfinite(points).all(axis=1))


def is_near(points: Float[np.ndarray, "points 3"]) -> Bool[np.ndarray, " points"]:
    """Whether 16 bits can express each point."""
    return np.asarray(np.abs(points).max(axis=1, initial=0.0) <= I16_RANGE_METRES)  # false for NaN


def encode_f32(points: Float[np.ndarray, "points 3"]) -> bytes:
    """N×3 little-endian float32, metres; points that are not finite (pixels without depth) are left out."""
    cloud = as_list(points)
    return bytes(cloud[is_finite(cloud)].astype("<f4"))


def encode_i16(points: Float[np.ndarray, "points 3"]) -> bytes:
    """N×3 little-endian int16, 0.1 mm; points that are not finite or beyond ±3.2767 m are left out.

    Raises:
        ValueError: when every point is beyond: such a cloud needs `encoding="f32"`.
    """
    cloud = as_list(points)
    near = cloud[is_near(cloud)]
    if not len(near) and is_finite(cloud).any():
        raise ValueError(
            f"all points are beyond {I16_RANGE_METRES} m, which i16 cannot express: are they millimetres? clouds are "
            "in metres; where the scene is that far away, open the session with encoding='f32'"
        )
    return bytes(np.rint(near / I16_METRES).astype("<i2"))


ENCODINGS: Mapping[str, CloudEncoding] = MappingProxyType(
    {
        "i16": CloudEncoding("application/vnd.captra.cloud.i16", encode_i16, is_near),
        "f32": CloudEncoding("application/vnd.captra.cloud.f32", encode_f32, is_finite),
    }
)
"""By the names that `open_session` takes."""


def get_encoding(name: str) -> CloudEncoding:
    """The encoding of a name.

    Raises:
        ValueError: listing the known names.
    """
    if name not in ENCODINGS:
        raise ValueError(f"unknown encoding {name!r}: use one of {', '.join(ENCODINGS)}")
    return ENCODINGS[name]


def attachment(seq: int, stamp_ns: int) -> bytes:
    """What goes along with every cloud: seq (uint64) and stamp_ns (int64), little-endian."""
    return struct.pack("<Qq", seq, stamp_ns)


def crop_ball(
    points: Float[np.ndarray, "all 3"], centre: Float[np.ndarray, "3"], radius_m: float
) -> Float[np.ndarray, "points 3"]:
    """The points within `radius_m` of `centre`, both in the cloud's frame.

    The service looks at 0.6 of the object's box diagonal around the last centre, at up to 1.6 while it finds nothing.
    """
    return np.asarray(points[np.linalg.norm(points - centre, axis=1) <= radius_m])


def thin_out(points: Float[np.ndarray, "all 3"], limit: int = BATCH_BYTES // 6) -> Float[np.ndarray, "points 3"]:
    """At most `limit` points at even distances in the list; by default as many as fit one Zenoh batch as i16."""
    if len(points) <= limit:
        return points
    return points[np.linspace(0, len(points) - 1, limit).astype(np.int64)]


@dataclass(frozen=True, eq=False)
class Cloud:
    """Points that go in one of these encodings."""

    points: Float[np.ndarray, "*shape 3"]
    """Metres."""
    encoding: CloudEncoding
    """How they are written."""

    @property
    def media_type(self) -> str:
        """Of the encoding."""
        return self.encoding.media_type

    def payload(self, camera: Camera | None) -> bytes:  # noqa: ARG002 - points need none
        """The points that can be expressed; raises ValueError for what is no cloud."""
        return self.encoding.encode(self.points)

    def region(self, region: Region) -> bytes:
        """A mask without the points that are left out.

        Raises:
            ValueError: the mask is of another size, or it is a box: a list of points has no rows and columns.
        """
        if isinstance(region, Box):
            raise ValueError(
                "a Box counts pixels, but these points go as a list: send a DepthImage or an organized PointCloud2 "
                "with it, or a Mask with these points"
            )
        if region.pixels.shape != np.shape(self.points)[:-1]:
            raise ValueError(
                f"the mask is {region.pixels.shape}, the cloud {np.shape(self.points)}: one value for each point"
            )
        return Mask(region.pixels.reshape(-1)[self.encoding.can_express(as_list(self.points))]).to_png()

    def shown(self, camera: Camera | None) -> np.ndarray:  # noqa: ARG002 - points need none
        """The points (N, 3), metres."""
        return as_list(self.points)


def as_list(points: Float[np.ndarray, "*shape 3"]) -> Float[np.ndarray, "points 3"]:
    """Points (N, 3) in single precision.

    Raises:
        ValueError: this is no cloud; what looks like an image of depth is told.
    """
    shape = np.shape(points)
    if len(shape) < 2 or shape[-1] != 3:
        raise ValueError(f"a cloud has the shape (points, 3) or (rows, columns, 3), not {shape}{remedy(shape)}")
    return np.asarray(points, np.float32).reshape(-1, 3)


def remedy(shape: tuple[int, ...]) -> str:
    """What an array of another shape than a cloud's may be meant for."""
    if len(shape) == 2 and min(shape) > LARGEST_POINT:
        return ": a depth image goes as DepthImage(pixels)"
    if len(shape) == 2 and shape[0] == 3:
        return ": transpose it (points.T)"
    return ": leave out colours and further columns (points[..., :3])"

"""Clouds as bytes: the two encodings that the service reads, and how to fit a cloud into one Zenoh batch."""

import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Float32

BATCH_BYTES = 65_000
"""What one Zenoh batch (65,535 bytes) holds beside its headers; more is cut up and may be lost as a whole."""
I16_METRES = 1e-4
I16_RANGE_METRES = 32767 * I16_METRES


class Frame(NamedTuple):
    """A cloud with the time at which it was captured."""

    points: Float[np.ndarray, "points 3"]
    """Metres, in the camera's frame."""
    stamp_ns: int
    """Capture time in nanoseconds, on whatever clock the results shall be matched with."""


@dataclass(frozen=True)
class CloudEncoding:
    """One way to write a cloud."""

    media_type: str
    """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
    encode: Callable[[Float[np.ndarray, "points 3"]], bytes]
    """From metres to the payload."""


def encode_f32(points: Float[np.ndarray, "points 3"]) -> bytes:
    """N×3 little-endian float32, metres; points that are not finite (pixels without depth) are left out."""
    return bytes(_finite(points).astype("<f4"))


def encode_i16(points: Float[np.ndarray, "points 3"]) -> bytes:
    """N×3 little-endian int16, 0.1 mm; points that are not finite or beyond ±3.2767 m are left out.

    Raises:
        ValueError: when every point is beyond: such a cloud needs `encoding="f32"`.
    """
    finite = _finite(points)
    near = finite[np.abs(finite).max(axis=1, initial=0.0) <= I16_RANGE_METRES]
    if len(finite) and not len(near):
        raise ValueError(f"all points are beyond {I16_RANGE_METRES} m, which i16 cannot express: use encoding='f32'")
    return bytes(np.rint(near / I16_METRES).astype("<i2"))


ENCODINGS: Mapping[str, CloudEncoding] = MappingProxyType(
    {
        "i16": CloudEncoding("application/vnd.captra.cloud.i16", encode_i16),
        "f32": CloudEncoding("application/vnd.captra.cloud.f32", encode_f32),
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


def _finite(points: Float[np.ndarray, "all 3"]) -> Float32[np.ndarray, "points 3"]:
    if np.ndim(points) < 2 or np.shape(points)[-1] != 3:
        raise ValueError(f"a cloud has the shape (points, 3) or (rows, columns, 3), not {np.shape(points)}")
    cloud = np.asarray(points, np.float32).reshape(-1, 3)
    return cloud[np.isfinite(cloud).all(axis=1)]

"""Clouds as viewers get them: thinned, 16 bits a coordinate, in one message with the result they led to."""

import struct
from dataclasses import dataclass

import numpy as np
import orjson
from jaxtyping import Float32

from service.results import Result

MOST_POINTS = 20_000
"""What a browser draws without effort, 120 kB a message."""
LEVELS = 65_535


@dataclass(frozen=True)
class Frame:
    """One cloud to be shown."""

    scene: str
    """`session/<id>` or `preview/<name>`."""
    points: Float32[np.ndarray, "points 3"]
    """Metres, in the frame of the cloud."""
    result: Result | None = None
    """What was found in it; none for a cloud that was rejected, or that no session tracks."""


def thinned(points: Float32[np.ndarray, "all 3"], most: int = MOST_POINTS) -> Float32[np.ndarray, "points 3"]:
    """At most `most` points at even distances in the list."""
    if len(points) <= most:
        return points
    return points[np.linspace(0, len(points) - 1, most).astype(np.intp)]


def encode(frame: Frame) -> bytes:
    """A binary message: uint32 length of a JSON header (a multiple of four), the header, N×3 uint16 coordinates.

    All is little-endian. A coordinate is `origin + step · q`, metres, with `origin` and `step` from the header.
    """
    points = thinned(frame.points)
    origin, highest = points.min(axis=0), points.max(axis=0)
    step = np.maximum((highest - origin) / LEVELS, 1e-9)
    quantized = np.rint((points - origin) / step).astype("<u2")
    header = orjson.dumps(
        {
            "type": "cloud",
            "scene": frame.scene,
            "count": len(points),
            "of": len(frame.points),
            "origin": origin.tolist(),
            "step": step.tolist(),
            "result": frame.result,
        }
    )
    padded = header + b" " * (-len(header) % 4)
    return b"".join((struct.pack("<I", len(padded)), padded, quantized.tobytes()))

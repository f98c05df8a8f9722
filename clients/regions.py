"""Where the object is in a frame, as a detector or a person says: a mask or a bounding box.

Either takes the place of CoordinateNet's segmentation in sessions that were opened with `masks`.
"""

import io
import struct
from dataclasses import dataclass
from math import ceil, floor
from numbers import Integral

import numpy as np
from jaxtyping import Bool, UInt8
from PIL import Image

PACKED_BOX = struct.Struct("<4H")
"""First column, first row, and the column and row behind the last ones, as they travel."""
LARGEST_EDGE = 2**16 - 1
FASTEST = 1
"""Level of compression: masks are small already, and time is what counts."""


@dataclass(frozen=True, eq=False)
class Mask:
    """One value for each pixel of the image, or each point of the cloud, that it goes with."""

    pixels: UInt8[np.ndarray, "rows columns"] | Bool[np.ndarray, "rows columns"]
    """Zero is background. With `masks="object"` all else is the object; with `masks="parts"` k is part k of the
    category, counted from 1. For a list of N points: (N,)."""

    def __post_init__(self) -> None:
        if self.pixels.dtype not in {np.dtype(np.bool_), np.dtype(np.uint8)} or self.pixels.ndim not in {1, 2}:
            raise ValueError(
                f"a mask is a bool or uint8 array (rows, columns), or (points,) for a list of points, "
                f"not {self.pixels.dtype} {self.pixels.shape}: make it so, e.g. by `mask > 0`"
            )

    def to_png(self) -> bytes:
        """8-bit grey; a list of points is one row."""
        buffer = io.BytesIO()
        rows = np.ascontiguousarray(np.atleast_2d(self.pixels), np.uint8)
        Image.fromarray(rows).save(buffer, "PNG", compress_level=FASTEST)
        return buffer.getvalue()


@dataclass(frozen=True)
class Box:
    """A bounding box in pixels: what is outside is background, CoordinateNet decides inside."""

    left: int
    """First column inside."""
    top: int
    """First row inside."""
    right: int
    """First column to the right of it."""
    bottom: int
    """First row below it."""

    @staticmethod
    def around(left: float, top: float, right: float, bottom: float, columns: int, rows: int) -> "Box":
        """A detector's box, of numbers between pixels and beyond edges, on an image of so many columns and rows.

        Raises:
            ValueError: nothing of it is in the image.
        """
        return Box(max(0, floor(left)), max(0, floor(top)), min(columns, ceil(right)), min(rows, ceil(bottom)))

    def __post_init__(self) -> None:
        edges = (self.left, self.top, self.right, self.bottom)
        if not all(isinstance(edge, Integral) for edge in edges):
            raise ValueError(
                f"{self} is not of whole pixels: Box.around(left, top, right, bottom, columns, rows) takes what "
                "detectors give"
            )
        if not (0 <= self.left < self.right <= LARGEST_EDGE and 0 <= self.top < self.bottom <= LARGEST_EDGE):
            raise ValueError(
                f"{self} holds no pixel, or reaches out of the image: left, top, right, bottom, in pixels from the "
                "upper left corner, the last two just outside (not width and height)"
            )

    def to_bytes(self) -> bytes:
        """Four numbers of 16 bits."""
        return PACKED_BOX.pack(self.left, self.top, self.right, self.bottom)


Region = Mask | Box

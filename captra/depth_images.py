"""Depth images: from pixels to the points near the object in one pass, without a cloud in between."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32, Float64, Int64, UInt16

from captra.compiled import compiled
from captra.observations import Crop

Pixels = UInt16[np.ndarray, "rows columns"] | Float32[np.ndarray, "rows columns"]


@dataclass(frozen=True)
class Intrinsics:
    """A pinhole camera without distortion: a point (x, y, z) is seen at u = fx·x/z + cx, v = fy·y/z + cy.

    Pixel (0, 0) is the middle of the upper left one; x points right, y down, z forward.
    """

    fx: float
    """Focal length in columns, pixels."""
    fy: float
    """Focal length in rows, pixels."""
    cx: float
    """Column of the principal point, pixels."""
    cy: float
    """Row of the principal point, pixels."""


@dataclass(frozen=True, eq=False)
class DepthImage:
    """Distances along the optical axis; zero, negative and non-finite ones are pixels without depth."""

    pixels: Pixels
    """Depth in units."""
    metres_per_unit: float
    """What one unit is worth: 0.001 for millimetres."""
    intrinsics: Intrinsics
    """Of the camera."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, columns = self.pixels.shape
        return rows, columns

    def near(self, centre: Float64[np.ndarray, "3"], radius_m: float) -> Crop:
        """The points less than `radius_m` from `centre`; only pixels that can show such a point are read."""
        window = self._window(centre, radius_m)
        return self._read(window, centre, np.float32(radius_m * radius_m))

    def whole(self) -> Crop:
        """All pixels with depth."""
        return self._read((0, self.pixels.shape[0], 0, self.pixels.shape[1]), np.zeros(3), np.float32(np.inf))

    def _read(self, window: tuple[int, int, int, int], centre: Float64[np.ndarray, "3"], squared: np.float32) -> Crop:
        pixels, camera = self.pixels.view(), self.intrinsics
        pixels.setflags(write=False)  # one compiled kernel serves messages and arrays alike
        columns_per_z = ((np.arange(pixels.shape[1]) - camera.cx) / camera.fx).astype(np.float32)
        rows_per_z = ((np.arange(pixels.shape[0]) - camera.cy) / camera.fy).astype(np.float32)
        unit = np.float32(self.metres_per_unit)
        return Crop(*_pixels_near(pixels, unit, columns_per_z, rows_per_z, window, centre.astype(np.float32), squared))

    def _window(self, centre: Float64[np.ndarray, "3"], radius_m: float) -> tuple[int, int, int, int]:
        """Rows and columns, each from and to, of a box around the ball; a box that reaches the camera is seen all over.

        Over a box in front of the camera x/z is smallest and largest at corners.
        """
        rows, columns = self.pixels.shape
        nearest, farthest = float(centre[2]) - radius_m, float(centre[2]) + radius_m
        if nearest <= 0:
            return 0, rows, 0, columns
        camera = self.intrinsics

        def span(middle: float, focal_px: float, principal_px: float, size: int) -> tuple[int, int]:
            low, high = middle - radius_m, middle + radius_m
            first = focal_px * low / (nearest if low < 0 else farthest) + principal_px
            last = focal_px * high / (nearest if high > 0 else farthest) + principal_px
            return int(np.clip(np.floor(first), 0, size)), int(np.clip(np.ceil(last) + 1, 0, size))

        return *span(centre[1], camera.fy, camera.cy, rows), *span(centre[0], camera.fx, camera.cx, columns)


@compiled
def _pixels_near(
    pixels: Pixels,
    metres_per_unit: np.float32,
    columns_per_z: Float32[np.ndarray, " columns"],
    rows_per_z: Float32[np.ndarray, " rows"],
    window: tuple[int, int, int, int],
    centre: Float32[np.ndarray, "3"],
    squared_radius: np.float32,
) -> tuple[Float32[np.ndarray, "points 3"], Int64[np.ndarray, " points"]]:
    first_row, end_row, first_column, end_column = window
    most = max(0, end_row - first_row) * max(0, end_column - first_column)
    points = np.empty((most, 3), np.float32)
    indices = np.empty(most, np.int64)
    found = 0
    for row in range(first_row, end_row):
        for column in range(first_column, end_column):
            z = np.float32(pixels[row, column]) * metres_per_unit
            if not (0 < z < np.inf):
                continue
            x, y = columns_per_z[column] * z, rows_per_z[row] * z
            dx, dy, dz = x - centre[0], y - centre[1], z - centre[2]
            if dx * dx + dy * dy + dz * dz < squared_radius:
                points[found, 0], points[found, 1], points[found, 2] = x, y, z
                indices[found] = row * pixels.shape[1] + column
                found += 1
    return points[:found].copy(), indices[:found].copy()


def warm_up() -> None:
    """Compile or load the kernel for both kinds of pixels."""
    for kind in (np.uint16, np.float32):
        DepthImage(np.ones((2, 2), kind), 1.0, Intrinsics(1.0, 1.0, 0.0, 0.0)).whole()

"""What a sensor saw in one frame, of which only the points near the object are ever read."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from jaxtyping import Float, Float32, Float64, Int64

from captra.compiled import compiled


@dataclass(frozen=True, eq=False)
class Crop:
    """Some points of an observation."""

    points: Float32[np.ndarray, "points 3"]
    """Metres, in the sensor's frame."""
    indices: Int64[np.ndarray, " points"]
    """Which points or pixels of the observation they are, row by row."""
    standing_for: int | None = None
    """How many points they were chosen from to stand for all of them; none if they are all there are."""

    def __len__(self) -> int:
        return len(self.indices)

    @property
    def total(self) -> int:
        """How many points there were before some were chosen to stand for all."""
        return len(self) if self.standing_for is None else self.standing_for

    def kept(self, mask: np.ndarray) -> "Crop":
        """The points where a mask is true, as if the others were not there."""
        return Crop(self.points[mask], self.indices[mask])

    def chosen(self, order: np.ndarray) -> "Crop":
        """The points at some positions of this crop, in that order, to stand for all of it."""
        return Crop(self.points[order], self.indices[order], self.total)


class Observation(Protocol):
    """One frame of a sensor, in whatever form it came."""

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns; a list of points is one row."""

    def near(self, centre: Float64[np.ndarray, "3"], radius_m: float) -> Crop:
        """The points less than `radius_m` from `centre` (metres, the sensor's frame), row by row."""

    def whole(self) -> Crop:
        """Every point that is one, row by row."""


@dataclass(frozen=True, eq=False)
class PointCloud:
    """Coordinates of points in rows, anywhere in memory; a point with a coordinate that is not finite is none."""

    x: Float32[np.ndarray, "rows columns"]
    """Metres."""
    y: Float32[np.ndarray, "rows columns"]
    """Metres."""
    z: Float32[np.ndarray, "rows columns"]
    """Metres."""

    @staticmethod
    def of(points: Float[np.ndarray, "points 3"]) -> "PointCloud":
        """A list of points as one row."""
        x, y, z = np.asarray(points, np.float32).T
        return PointCloud(x[None], y[None], z[None])

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, columns = self.x.shape
        return rows, columns

    def near(self, centre: Float64[np.ndarray, "3"], radius_m: float) -> Crop:
        """The points less than `radius_m` from `centre`, in one pass over the coordinates as they are."""
        x, y, z = self._read_only()
        return Crop(*_points_near(x, y, z, centre.astype(np.float32), np.float32(radius_m * radius_m)))

    def whole(self) -> Crop:
        """All finite points."""
        points = np.stack([self.x.ravel(), self.y.ravel(), self.z.ravel()], axis=-1)
        finite = np.isfinite(points).all(axis=-1)
        return Crop(points if finite.all() else points[finite], np.flatnonzero(finite))

    def _read_only(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        # Kernels are compiled anew for memory that cannot be written, such as a message: always look as if.
        views = (self.x.view(), self.y.view(), self.z.view())
        for view in views:
            view.setflags(write=False)
        return views


def warm_up() -> None:
    """Compile or load the kernel for coordinates side by side and for coordinates one after the other."""
    points = np.zeros((2, 3), np.float32)
    for cloud in (PointCloud.of(points), PointCloud(*np.zeros((3, 2, 2), np.float32))):
        cloud.near(np.zeros(3), 1.0)


@compiled
def _points_near(
    x: Float32[np.ndarray, "rows columns"],
    y: Float32[np.ndarray, "rows columns"],
    z: Float32[np.ndarray, "rows columns"],
    centre: Float32[np.ndarray, "3"],
    squared_radius: np.float32,
) -> tuple[Float32[np.ndarray, "points 3"], Int64[np.ndarray, " points"]]:
    rows, columns = x.shape
    points = np.empty((rows * columns, 3), np.float32)
    indices = np.empty(rows * columns, np.int64)
    found = 0
    for row in range(rows):
        for column in range(columns):
            dx, dy, dz = x[row, column] - centre[0], y[row, column] - centre[1], z[row, column] - centre[2]
            if dx * dx + dy * dy + dz * dz < squared_radius:  # false for NaN and infinity
                points[found, 0], points[found, 1], points[found, 2] = x[row, column], y[row, column], z[row, column]
                indices[found] = row * columns + column
                found += 1
    return points[:found].copy(), indices[:found].copy()

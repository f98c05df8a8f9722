"""Flat things: rounded rectangles in the x-z plane, stacked along y to plates, wells and lofts."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.mesh import Mesh, grid_mesh

_SMALLEST_CORNER = 1e-4
_CORNER_STEPS = 4


@dataclass(frozen=True)
class Rectangle:
    """Axis-aligned rectangle with rounded corners in the x-z plane, metres."""

    low: tuple[float, float]
    """Smallest x and z."""
    high: tuple[float, float]
    """Largest x and z."""
    corner: float = 0.0
    """Radius of the corners, cut to what fits."""
    square_end: Literal["none", "low", "high"] = "none"
    """The end in x whose corners and edges stay sharp, where another plate adjoins."""

    @staticmethod
    def centred(size_x: float, size_z: float, corner: float = 0.0) -> "Rectangle":
        """Around the origin."""
        return Rectangle((-size_x / 2, -size_z / 2), (size_x / 2, size_z / 2), corner)

    def inset(self, low_x: float, high_x: float, z: float) -> "Rectangle":
        """Move the sides inwards (outwards if negative); corners shrink along."""
        low, high = (self.low[0] + low_x, self.low[1] + z), (self.high[0] - high_x, self.high[1] - z)
        return replace(self, low=low, high=high, corner=max(self.corner - max(low_x, high_x, z), 0.0))

    def shrunk(self, distance: float) -> "Rectangle":
        """Move all sides inwards, but for the square end."""
        low, high = (0.0 if self.square_end == end else distance for end in ("low", "high"))
        return self.inset(low, high, distance)

    def moved(self, x: float, z: float) -> "Rectangle":
        """Shift."""
        low, high = (self.low[0] + x, self.low[1] + z), (self.high[0] + x, self.high[1] + z)
        return replace(self, low=low, high=high)

    def outline(self) -> Float64[np.ndarray, "S 2"]:
        """(x, z) counter-clockwise seen from +y; corresponding points of any two rectangles have the same index."""
        half = (np.subtract(self.high, self.low)) / 2
        centre = (np.add(self.high, self.low)) / 2
        corner = float(np.clip(self.corner, _SMALLEST_CORNER, 0.98 * half.min()))
        points = []
        for quadrant in range(4):
            angle = np.pi / 2 * (quadrant + np.linspace(0, 1, _CORNER_STEPS))
            middle = np.pi / 2 * (quadrant + 0.5)
            sign = np.sign([np.cos(middle), -np.sin(middle)])
            square = {"none": 0, "low": -1, "high": 1}[self.square_end] == sign[0]
            radius = _SMALLEST_CORNER if square else corner
            arc = radius * np.column_stack([np.cos(angle), -np.sin(angle)])
            points.append(centre + (half - radius) * sign + arc)
        return np.concatenate(points)


def stacked(layers: Sequence[tuple[Rectangle, float]]) -> Mesh:
    """Connect rectangles at heights y, from the lower outside over the top inwards, to a closed solid."""
    rings = [np.insert(rectangle.outline(), 1, y, axis=1) for rectangle, y in layers]
    return grid_mesh(np.stack(rings), caps=True)


def plate(rectangle: Rectangle, low: float, high: float, bevel: float = 0.0) -> Mesh:
    """Solid between two heights, its upper and lower edges bevelled."""
    return stacked([*_lower_edge(rectangle, low, high, bevel), *_upper_edge(rectangle, low, high, bevel)])


def plate_with_well(
    rectangle: Rectangle, low: float, high: float, well: Rectangle, depth: float, bevel: float = 0.0
) -> Mesh:
    """A plate whose upper side is sunk by `depth` within `well`."""
    edge = [*_lower_edge(rectangle, low, high, bevel), *_upper_edge(rectangle, low, high, bevel)]
    return stacked([*edge, (well, high), (well, high - depth)])


def _lower_edge(rectangle: Rectangle, low: float, high: float, bevel: float) -> list[tuple[Rectangle, float]]:
    cut = min(bevel, 0.45 * (high - low))
    if cut < 1e-5:
        return [(rectangle, low)]
    nearer = 0.3 * cut
    return [
        (rectangle.shrunk(cut), low),
        (rectangle.shrunk(nearer), low + nearer),
        (rectangle, low + cut),
    ]


def _upper_edge(rectangle: Rectangle, low: float, high: float, bevel: float) -> list[tuple[Rectangle, float]]:
    return [(layer, low + high - y) for layer, y in reversed(_lower_edge(rectangle, low, high, bevel))]

"""Which points belong to which part, where something else than CoordinateNet knows (paper, "Ours + RGB seg.")."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from jaxtyping import Float32, Int64, UInt8

from captra.categories import Category
from captra.observations import Crop

BACKGROUND, FIRST_PART = 0, 1
"""Label of what does not belong to the object, and of its first part; the other parts follow."""
OBJECT = 254
"""Label of what belongs to the object, to whichever part."""
UNKNOWN = 255
"""Label of what CoordinateNet has to decide."""


class Segmentation(Protocol):
    """What is known of the points of one frame beforehand."""

    def labels(self, indices: Int64[np.ndarray, " points"]) -> UInt8[np.ndarray, " points"]:
        """Label of each point, by its index in the observation."""


class NothingKnown:
    """CoordinateNet decides."""

    def labels(self, indices: Int64[np.ndarray, " points"]) -> UInt8[np.ndarray, " points"]:
        """Unknown."""
        return np.full(len(indices), UNKNOWN, np.uint8)


NOTHING_KNOWN: Segmentation = NothingKnown()


@dataclass(frozen=True, eq=False)
class LabelImage:
    """One label for each point or pixel of the observation."""

    image: UInt8[np.ndarray, "rows columns"]
    """As many rows and columns as the observation has."""

    def labels(self, indices: Int64[np.ndarray, " points"]) -> UInt8[np.ndarray, " points"]:
        """Looked up."""
        return np.asarray(self.image.reshape(-1)[indices])


@dataclass(frozen=True)
class Box:
    """A bounding box: what is outside is background, what is inside may be either."""

    columns: int
    """Of the observation."""
    left: int
    """First column inside."""
    top: int
    """First row inside."""
    right: int
    """First column to the right of it."""
    bottom: int
    """First row below it."""

    def labels(self, indices: Int64[np.ndarray, " points"]) -> UInt8[np.ndarray, " points"]:
        """Unknown inside, background outside."""
        row, column = np.divmod(indices, self.columns)
        inside = (self.left <= column) & (column < self.right) & (self.top <= row) & (row < self.bottom)
        return np.where(inside, np.uint8(UNKNOWN), np.uint8(BACKGROUND))


def without_background(crop: Crop, segmentation: Segmentation) -> Crop:
    """What is left of a crop when known background is taken away."""
    kept = segmentation.labels(crop.indices) != BACKGROUND
    return crop if kept.all() else crop.kept(kept)


def overrule(
    probabilities: Float32[np.ndarray, "classes points"], labels: UInt8[np.ndarray, " points"], category: Category
) -> Float32[np.ndarray, "classes points"]:
    """CoordinateNet's class probabilities, with certainty where a label is known."""
    if (labels == UNKNOWN).all():
        return probabilities
    parts = category.num_parts
    overruled = probabilities.copy()
    certain = labels < FIRST_PART + parts
    classes = np.where(labels[certain] == BACKGROUND, len(probabilities) - 1, labels[certain].astype(np.int64) - 1)
    overruled[:, certain] = np.arange(len(probabilities))[:, None] == classes
    some_part = labels == OBJECT
    of_parts = np.maximum(probabilities[:parts, some_part], np.finfo(np.float32).tiny)
    overruled[:, some_part] = 0
    overruled[:parts, some_part] = of_parts / of_parts.sum(axis=0)
    return overruled

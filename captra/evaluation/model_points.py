"""Points on the true surface of an object's parts: what an oracle knows, and what AD-10 % measures with."""

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, Float32

from captra.data.recordings import Recording
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.shape import Shape

ModelPoints = Sequence[Float32[np.ndarray, "points 3"]]
"""Points of each part in the part's own frame, metres."""

COUNT = 4000
"""Points a part."""
CELL_SHARE = 0.01
"""Accumulated points closer together than this share of the part's diagonal count once."""


def from_shape(shape: Shape, count: int = COUNT) -> ModelPoints:
    """Points spread evenly over the surface of each part, inside included; the same for the same shape."""
    rng = np.random.default_rng(0)
    centred = [part.moved(translation=-center) for part, center in zip(shape.parts, shape.centers, strict=True)]
    return tuple(surface_points(part, count, rng) for part in centred)


def surface_points(mesh: Mesh, count: int, rng: np.random.Generator) -> Float32[np.ndarray, "points 3"]:
    """Points drawn evenly from the triangles of a mesh."""
    a, b, c = np.moveaxis(mesh.vertices[mesh.faces].astype(np.float64), 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=-1)
    chosen = rng.choice(len(area), count, p=area / area.sum())
    u, v = rng.random((2, count, 1))
    over = u + v > 1
    u, v = np.where(over, 1 - u, u), np.where(over, 1 - v, v)
    return np.asarray(a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen], np.float32)


def from_recording(recording: Recording, every: int = 3) -> ModelPoints:
    """What a recording shows of each part over time, brought together by the true poses.

    For objects whose mesh is not at hand: sides that are never seen are missing, and depth noise is included.
    """
    return tuple(_accumulated(recording, part, every) for part in range(recording.category.num_parts))


def _accumulated(recording: Recording, part: int, every: int) -> Float32[np.ndarray, "points 3"]:
    seen = []
    for frame in range(0, len(recording), every):
        points = recording.clouds[frame][recording.labels[frame] == part]
        seen.append((points - recording.translation[frame, part]) @ recording.rotation[frame, part])
    cell = CELL_SHARE * float(np.linalg.norm(recording.size[part]))
    return _thinned(np.concatenate(seen), cell)[:COUNT]


def _thinned(points: Float[np.ndarray, "all 3"], cell: float) -> Float32[np.ndarray, "some 3"]:
    """One point a cell, in an order that takes no side."""
    shuffled = np.random.default_rng(0).permutation(points)
    _, first = np.unique(np.floor(shuffled / cell).astype(np.int64), axis=0, return_index=True)
    return shuffled[np.sort(first)].astype(np.float32)

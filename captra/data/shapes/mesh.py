"""Triangle meshes as plain arrays, and how to move and join them."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Float32, Int32


class Mesh(NamedTuple):
    """Triangles over shared vertices, metres; faces are wound counter-clockwise seen from outside."""

    vertices: Float32[np.ndarray, "V 3"]
    """Positions in the frame that the owner names."""
    faces: Int32[np.ndarray, "F 3"]
    """Vertex indices."""

    def moved(
        self, rotation: Float[np.ndarray, "3 3"] | None = None, translation: Float[np.ndarray, " 3"] | None = None
    ) -> "Mesh":
        """Rotate, then translate."""
        vertices = self.vertices if rotation is None else self.vertices @ np.asarray(rotation, np.float32).T
        if translation is not None:
            vertices = vertices + np.asarray(translation, np.float32)
        return Mesh(vertices.astype(np.float32, copy=False), self.faces)

    def stretched(self, factors: Float[np.ndarray, " 3"] | float) -> "Mesh":
        """Scale along the axes by positive factors."""
        return Mesh((self.vertices * np.asarray(factors, np.float32)).astype(np.float32), self.faces)

    def bounds(self) -> Float32[np.ndarray, "2 3"]:
        """Smallest and largest coordinates."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)])


def merged(meshes: Iterable[Mesh]) -> Mesh:
    """One mesh of several; surfaces that interpenetrate stay as they are, which ray casting does not mind."""
    vertices, faces, start = [], [], 0
    for mesh in meshes:
        vertices.append(mesh.vertices)
        faces.append(mesh.faces + start)
        start += len(mesh.vertices)
    if not vertices:
        return Mesh(np.empty((0, 3), np.float32), np.empty((0, 3), np.int32))
    return Mesh(np.concatenate(vertices).astype(np.float32), np.concatenate(faces).astype(np.int32))


def grid_mesh(rings: Float[np.ndarray, "K S 3"], *, caps: bool) -> Mesh:
    """Connect K closed rings of S points each; `caps` closes the first and the last ring with a fan.

    Rings run counter-clockwise seen from the side towards which the stack proceeds.
    """
    count, around = rings.shape[:2]
    index = np.arange(count * around, dtype=np.int32).reshape(count, around)
    a, b = index[:-1], np.roll(index, -1, axis=1)[:-1]
    c, d = index[1:], np.roll(index, -1, axis=1)[1:]
    faces = [np.stack([a, b, d], -1).reshape(-1, 3), np.stack([a, d, c], -1).reshape(-1, 3)]
    vertices = [rings.reshape(-1, 3)]
    if caps:
        first, last = count * around, count * around + 1
        vertices.append(np.stack([rings[0].mean(0), rings[-1].mean(0)]))
        start, end = index[0], index[-1]
        faces.append(np.stack([np.full(around, first), np.roll(start, -1), start], -1))
        faces.append(np.stack([np.full(around, last), end, np.roll(end, -1)], -1))
    return Mesh(np.concatenate(vertices).astype(np.float32), np.concatenate(faces).astype(np.int32))

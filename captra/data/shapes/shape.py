"""One object instance: its parts in the object frame, ready to be posed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float32

from captra.data.shapes.mesh import Mesh, merged


@dataclass(frozen=True)
class Shape:
    """An instance of a category at rest, metres; the tight box of the whole object is centred at the origin."""

    category: str
    """Name of the category whose axes the object frame follows."""
    parts: tuple[Mesh, ...]
    """One mesh a part, in the category's order, all in the object frame."""
    joint_origins: Float32[np.ndarray, "J 3"]
    """A point on each joint's axis, object frame."""
    joint_limits: Float32[np.ndarray, "J 2"]
    """Smallest and largest value of each joint, rad or m."""

    @property
    def centers(self) -> Float32[np.ndarray, "P 3"]:
        """Centre of each part's tight box, object frame."""
        return np.stack([part.bounds().mean(0) for part in self.parts])

    @property
    def sizes(self) -> Float32[np.ndarray, "P 3"]:
        """Extent of each part's tight box along the object axes."""
        return np.stack([np.ptp(part.bounds(), axis=0) for part in self.parts])

    @property
    def scale(self) -> float:
        """Diagonal of the whole object's tight box."""
        return float(np.linalg.norm(np.ptp(merged(self.parts).bounds(), axis=0)))


def rigid_shape(category: str, meshes: Sequence[Mesh]) -> Shape:
    """Join meshes into one part and centre its tight box at the origin."""
    mesh = merged(meshes)
    centred = mesh.moved(translation=-mesh.bounds().mean(0))
    return Shape(category, (centred,), np.zeros((0, 3), np.float32), np.zeros((0, 2), np.float32))


def articulated_shape(
    category: str,
    parts: Sequence[Sequence[Mesh]],
    joint_origins: Float[np.ndarray, "J 3"],
    joint_limits: Float[np.ndarray, "J 2"],
) -> Shape:
    """Join the meshes of each part and centre the tight box of the whole, joint origins along with it."""
    meshes = [merged(part) for part in parts]
    middle = merged(meshes).bounds().mean(0)
    return Shape(
        category,
        tuple(mesh.moved(translation=-middle) for mesh in meshes),
        (np.asarray(joint_origins) - middle).astype(np.float32),
        np.asarray(joint_limits, np.float32),
    )

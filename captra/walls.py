"""Cabinets are built at right angles: what their walls and fronts face tells how they are turned.

It tells it to a fraction of a degree, where networks are off by one or two.

The rotation of an object among walls is a "Manhattan frame" (Straub et al., "A Mixture of Manhattan Frames", CVPR
2014): each wall faces along one of its axes. Networks say which; least squares over the directions that local patches
face says exactly how.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float32, Float64, Int, Int32

from captra.categories import Category
from captra.geometry import project_to_rotation, rotation_from_vector, rotation_vector
from captra.joint_projection import JointProjection
from captra.sampling import Neighborhoods

PATCH_GROUP = 1
"""Which of the groups around first-level centroids are patches: those of radius 0.1, some centimetres on a cabinet."""

THICKEST = 0.1
"""Variance of a patch across itself, in shares of that along its shorter side, from which on it tells nothing."""

LARGEST_ANGLES_DEG = (12.0, 12.0, 10.0, 8.0, 6.0, 6.0)
"""Between a patch and the nearest axis, round by round: what faces elsewhere is a handle, a rounding, or not a wall."""

FEW_PATCHES = 5.0
"""That face across an axis: the turn about it is half way between what they and the networks say."""


@dataclass(frozen=True)
class Patches:
    """Small pieces of surface."""

    normal: Float64[np.ndarray, "patches 3"]
    """Unit vectors in the camera's frame, of either sign."""
    flatness: Float64[np.ndarray, " patches"]
    """In [0, 1]; 1 is a plane."""

    @staticmethod
    def of(points: Float32[np.ndarray, "points 3"], groups: Int32[np.ndarray, "patches k"]) -> "Patches":
        """Planes through groups of points; a group that is filled up with its first point counts that once."""
        own = points[groups].astype(np.float64)
        counted = groups != groups[:, :1]
        counted[:, 0] = True
        counts = counted.sum(axis=1)
        middle = (own * counted[..., None]).sum(axis=1) / counts[:, None]
        away = (own - middle[:, None]) * counted[..., None]
        variances, axes = np.linalg.eigh(np.swapaxes(away, -1, -2) @ away)
        thickness = variances[:, 0] / np.maximum(variances[:, 1], np.finfo(np.float64).tiny)
        return Patches(axes[:, :, 0], np.where(counts > 3, np.clip(1 - thickness / THICKEST, 0.0, 1.0), 0.0))


@dataclass(frozen=True)
class AlongWalls:
    """Turns a cabinet's parts, which all face the same way, such that its walls face along their axes."""

    allowed: JointProjection
    """What joints allow, first."""
    patches: Patches
    """Of all that is seen."""

    def __call__(
        self, rotation: Float64[np.ndarray, "parts 3 3"], seen: Int[np.ndarray, " parts"], category: Category
    ) -> Float64[np.ndarray, "parts 3 3"]:
        """The rotations that joints allow, turned together."""
        projected = self.allowed(rotation, seen, category)
        root = projected[category.root]
        turn = square(root, self.patches) @ root.T
        # Projected, since products of rounded rotations, each made from the one before, drift off ever faster.
        return project_to_rotation(turn @ projected)


def along_walls(
    allowed: JointProjection,
    points: Float32[np.ndarray, "points 3"],
    neighborhoods: Neighborhoods,
    category: Category,
) -> JointProjection:
    """What joints allow of objects all whose joints are slides, which have walls; others are left to `allowed`."""
    if not category.joints or len(category.slides) < len(category.joints):
        return allowed
    return AlongWalls(allowed, Patches.of(points, neighborhoods.groups1[PATCH_GROUP]))


def square(rotation: Float64[np.ndarray, "3 3"], patches: Patches) -> Float64[np.ndarray, "3 3"]:
    """The rotation near `rotation` whose axes walls face along, each turn believed by the patches that tell it."""
    found = rotation
    for largest_deg in LARGEST_ANGLES_DEG:
        facing = patches.normal @ found
        nearest = np.abs(facing).argmax(axis=1)
        axis = np.sign(facing[np.arange(len(facing)), nearest])[:, None] * np.eye(3)[nearest]
        angle_deg = np.degrees(np.arccos(np.clip((facing * axis).sum(axis=1), -1.0, 1.0)))
        weight = patches.flatness * np.square(np.clip(1 - np.square(angle_deg / largest_deg), 0.0, 1.0))
        told = weight.sum() * np.eye(3) - (weight[:, None] * facing).T @ facing
        pull = weight @ np.cross(axis, facing) + FEW_PATCHES * rotation_vector(found.T @ rotation)
        found = project_to_rotation(found @ rotation_from_vector(np.linalg.solve(told + FEW_PATCHES * np.eye(3), pull)))
    return found

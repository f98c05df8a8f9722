"""Articulated objects of the mesh library: a folder with a mesh a part and the joints between them."""

import json
from pathlib import Path

import numpy as np
from jaxtyping import Float, Float64

from captra.categories import get_category
from captra.data.shapes.draws import between, chance
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.shape import Shape, articulated_shape
from captra.errors import UserError

LARGEST_SCALE = 1.9
"""Diagonal of the largest object after deformation, metres: it fits into a view."""


class LibraryError(UserError, ValueError):
    """An object of the library does not have the parts or joints of its category."""


def load_articulated(folder: Path, category: str) -> Shape:
    """Read `object.json` and the parts it names, in the category's order.

    The library may count a joint about the opposite axis; limits are turned to the category's.

    Raises:
        FileNotFoundError: without an `object.json`.
        LibraryError: if its parts or joints are not those of the category.
    """
    import trimesh

    entry = json.loads((folder / "object.json").read_text())
    kinematics = get_category(category)
    joints = {(joint["child"], joint["parent"]): joint for joint in entry["joints"]}
    wanted = [(joint.child, joint.parent) for joint in kinematics.joints]
    if len(entry["parts"]) != kinematics.num_parts or sorted(joints) != sorted(wanted):
        raise LibraryError(f"{folder} has other parts or joints than {category}: correct its object.json")
    parts = []
    for part in entry["parts"]:
        loaded = trimesh.load_mesh(folder / part["mesh"], process=False)
        parts.append([Mesh(np.asarray(loaded.vertices, np.float32), np.asarray(loaded.faces, np.int32))])
    origins, limits = [], []
    for joint in kinematics.joints:
        found = joints[joint.child, joint.parent]
        sign = float(np.dot(found["axis"], joint.axis))
        if abs(sign) < 0.99:
            raise LibraryError(f"joint {joint.name} of {folder} does not turn about {joint.axis}: align the object")
        origins.append(found["origin"])
        limits.append(sorted((sign * found["lower"], sign * found["upper"])))
    return articulated_shape(category, parts, np.array(origins), np.array(limits))


def deformed_articulated(shape: Shape, rng: np.random.Generator) -> Shape:
    """Stretch the whole along its axes and parts against each other, so that joints stay where parts meet."""
    factors = np.exp(rng.normal(0, 0.09, 3).clip(-0.2, 0.2)) * between(rng, 0.85, 1.15)
    factors *= min(1.0, LARGEST_SCALE / float(np.linalg.norm(np.ptp(merged(shape.parts).bounds(), axis=0) * factors)))
    origins = shape.joint_origins.astype(np.float64) * factors
    parts = [mesh.stretched(factors) for mesh in shape.parts]
    limits = shape.joint_limits.astype(np.float64)
    if shape.category == "drawers":
        limits = limits * factors[2]
    if chance(rng, 0.7):
        parts = _partwise(shape.category, parts, origins, rng)
    return articulated_shape(shape.category, [[mesh] for mesh in parts], origins, limits)


def _partwise(
    category: str, parts: list[Mesh], origins: Float64[np.ndarray, "J 3"], rng: np.random.Generator
) -> list[Mesh]:
    if category == "glasses":  # both temples alike
        stretch = np.array([1.0, between(rng, 0.75, 1.4), between(rng, 0.85, 1.15)])
        tall = np.array([1.0, between(rng, 0.85, 1.2), 1.0])
        right, left, base = parts
        return [
            _about(right, origins[0], stretch),
            _about(left, origins[1], stretch),
            _about(base, origins.mean(0), tall),
        ]
    if category == "scissors":
        blade, handle = between(rng, 0.8, 1.25), between(rng, 0.85, 1.15)
        return [_lengthened(mesh, float(origins[0, 2]), blade, handle) for mesh in parts]
    if category == "laptop_articulated":  # each grows away from where they meet
        base, display = parts
        top, bottom = base.bounds()[1, 1], display.bounds()[0, 1]
        thicker = [np.array([1.0, between(rng, 0.7, 1.6), 1.0]) for _ in parts]
        return [_about(base, np.array([0, top, 0]), thicker[0]), _about(display, np.array([0, bottom, 0]), thicker[1])]
    return parts


def _about(mesh: Mesh, center: Float[np.ndarray, " 3"], factors: Float[np.ndarray, " 3"]) -> Mesh:
    return mesh.moved(translation=-center).stretched(factors).moved(translation=center)


def _lengthened(mesh: Mesh, pivot: float, blade: float, handle: float) -> Mesh:
    vertices = mesh.vertices.copy()
    along = vertices[:, 2] - pivot
    vertices[:, 2] = pivot + along * np.where(along > 0, blade, handle)
    return Mesh(vertices, mesh.faces)

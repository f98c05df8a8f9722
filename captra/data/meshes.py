"""Objects that people made or scanned, as shapes; deformed for variety where they are mixed into training data."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from captra.categories import get_category
from captra.data.articulated_meshes import LibraryError, deformed_articulated, load_articulated
from captra.data.credits import Credit
from captra.data.shapes.curves import through
from captra.data.shapes.draws import between, chance
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.registry import make_shape
from captra.data.shapes.shape import Shape, rigid_shape

Use = Literal["train", "validate"]

SHARE_PER_MESH = 0.05
"""No single mesh makes up more than this share of the training data."""

_TURNED = ("bottle", "bowl", "can", "mug")
"""Categories that stay what they are if their width varies with height."""

_SUFFIX = "_articulated"
"""Of the folders that hold articulated objects."""


@dataclass(frozen=True)
class MeshObject:
    """One object of the library."""

    name: str
    """`category/object`."""
    credit: Credit
    """Its licence and author; bundles trained on it name them."""
    notes: str
    """Known defects."""
    shape: Shape
    """As made or scanned."""


def load_meshes(folder: Path, category: str, use: Use) -> tuple[MeshObject, ...]:
    """Read the objects of a category with this use; an empty tuple if there is none.

    Raises:
        LibraryError: if the folder has no INDEX.json, or one that cannot be read.
    """
    try:
        index = json.loads((folder / "INDEX.json").read_text())
    except (OSError, json.JSONDecodeError) as error:
        raise LibraryError(
            f"{folder} is no library of meshes ({error}): it needs an INDEX.json, see docs/your-own-category.md"
        ) from error
    names = [name for name in sorted(index) if name.startswith(f"{_section(category)}/") and index[name]["use"] == use]
    return tuple(
        MeshObject(name, Credit.of(index[name]), index[name]["notes"], load_mesh(folder, category, name))
        for name in names
    )


def load_mesh(folder: Path, category: str, name: str) -> Shape:
    """Read one object of a library, `section/object`."""
    read = load_articulated if get_category(category).joints else _load_rigid
    return read(folder / name, category)


def find_mesh(folder: Path, category: str, name: str) -> Shape | None:
    """The object of a category called `name`, whatever its use; None if the library does not hold it."""
    path = folder / _section(category) / name
    if not (path.is_dir() or path.with_name(f"{name}.ply").is_file()):
        return None
    return load_mesh(folder, category, f"{_section(category)}/{name}")


def _section(category: str) -> str:
    return f"{category.removesuffix(_SUFFIX)}{_SUFFIX}" if get_category(category).joints else category


def _load_rigid(path: Path, category: str) -> Shape:
    import trimesh

    loaded = trimesh.load_mesh(path.with_name(f"{path.name}.ply"), process=False)
    mesh = Mesh(np.asarray(loaded.vertices, np.float32), np.asarray(loaded.faces, np.int32))
    return rigid_shape(category, [mesh])


def deformed(shape: Shape, rng: np.random.Generator) -> Shape:
    """Stretch a rigid shape along its axes, a turned one's width by height, and a mug's handle.

    Axes and symmetry are kept, and a camera's lens stays almost round.
    """
    vertices = shape.parts[0].vertices.astype(np.float64)
    size = shape.sizes[0]
    if shape.category == "mug" and chance(rng, 0.7):
        body = (
            size[2] / 2 - size[0] / 2
        )  # x of the body's far side from the handle is -size/2, its near side size[2] further
        beyond = vertices[:, 0] - (body + size[2] / 2)
        vertices[:, 0] += np.where(beyond > 0, beyond * between(rng, -0.3, 0.4), 0)
    if shape.category in _TURNED and chance(rng, 0.7):
        at = np.clip(vertices[:, 1] / size[1] + 0.5, 0, 1)
        center = size[2] / 2 - size[0] / 2 if shape.category == "mug" else 0.0
        width = through((0, 0.35, 0.7, 1), 1 + rng.normal(0, 0.08, 4).clip(-0.16, 0.16), at)
        vertices[:, 0] = center + (vertices[:, 0] - center) * width
        vertices[:, 2] *= width
    sideways = between(rng, 0.85, 1.18)
    upwards = sideways * between(rng, 0.92, 1.08) if shape.category == "camera" else between(rng, 0.75, 1.33)
    factors = np.array([sideways, upwards, sideways]) * between(rng, 0.85, 1.15)
    if not get_category(shape.category).symmetric:
        factors[2] *= between(rng, 0.93, 1.07)
    mesh = Mesh((vertices * factors).astype(np.float32), shape.parts[0].faces)
    return rigid_shape(shape.category, [mesh])


def shape_source(
    category: str, meshes: tuple[MeshObject, ...], mesh_fraction: float
) -> Callable[[np.random.Generator], Shape]:
    """Draw procedural shapes, and deformed library objects in (at most) that fraction of cases."""
    fraction = min(mesh_fraction, SHARE_PER_MESH * len(meshes))
    deform = deformed_articulated if get_category(category).joints else deformed

    def draw(rng: np.random.Generator) -> Shape:
        if meshes and chance(rng, fraction):
            return deform(meshes[int(rng.integers(len(meshes)))].shape, rng)
        return make_shape(category, rng)

    return draw

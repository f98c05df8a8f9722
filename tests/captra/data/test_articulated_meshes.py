import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

from captra.data.articulated_meshes import LibraryError, deformed_articulated, load_articulated
from captra.data.meshes import load_meshes, shape_source
from captra.data.shapes import make_shape
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.mesh import merged
from captra.data.shapes.surfaces import box

JOINT = {"child": 1, "parent": 0, "type": "revolute", "axis": [1.0, 0, 0], "origin": [0, 0.01, -0.1]}


def write_laptop(folder: Path, joints: list[dict[str, object]]) -> None:
    folder.mkdir(parents=True)
    for name, y in (("base", 0.0), ("display", 0.02)):
        mesh = box((0.3, 0.01, 0.2)).moved(translation=np.array([0, y, 0]))
        trimesh.Trimesh(mesh.vertices, mesh.faces).export(folder / f"{name}.ply")
    parts = [{"name": name, "mesh": f"{name}.ply"} for name in ("base", "display")]
    (folder / "object.json").write_text(json.dumps({"parts": parts, "joints": joints}))


@pytest.fixture
def library(tmp_path: Path) -> Path:
    write_laptop(tmp_path / "laptop_articulated" / "slab", [{**JOINT, "lower": -2.0, "upper": -0.1}])
    index = {
        "laptop_articulated/slab": {"use": "train", "licence": "CC0", "notes": ""},
        "laptop/slab": {"use": "train", "licence": "CC0", "notes": ""},
    }
    (tmp_path / "INDEX.json").write_text(json.dumps(index))
    return tmp_path


def test_joints_counted_about_the_opposite_axis_are_turned_round(library: Path) -> None:
    (laptop,) = load_meshes(library, "laptop_articulated", "train")
    shape = laptop.shape
    assert laptop.name == "laptop_articulated/slab"
    np.testing.assert_allclose(shape.joint_limits, [[0.1, 2.0]])
    np.testing.assert_allclose(shape.joint_origins, [[0, 0.0, -0.1]], atol=1e-6)
    np.testing.assert_allclose(merged(shape.parts).bounds().mean(0), 0, atol=1e-6)
    rotation, translation = part_motions(shape, shape.joint_limits[:, 1])
    assert (shape.parts[1].moved(rotation[1], translation[1]).bounds()[1, 1]) > 0.15, "it opens upwards"


@pytest.mark.parametrize("joints", [[], [{**JOINT, "axis": [0.0, 1, 0], "lower": 0, "upper": 1}]])
def test_other_joints_than_those_of_the_category_are_an_error(tmp_path: Path, joints: list[dict[str, object]]) -> None:
    write_laptop(tmp_path / "odd", joints)
    with pytest.raises(LibraryError, match="odd"):
        load_articulated(tmp_path / "odd", "laptop_articulated")


@pytest.mark.parametrize("category", ["drawers", "glasses", "laptop_articulated", "scissors"])
def test_deformed_objects_keep_their_joints_where_parts_meet(category: str) -> None:
    rng = np.random.default_rng(4)
    source = make_shape(category, np.random.default_rng(2))
    sizes = []
    for _ in range(12):
        shape = deformed_articulated(source, rng)
        np.testing.assert_allclose(merged(shape.parts).bounds().mean(0), 0, atol=1e-6)
        sizes.append(shape.sizes / source.sizes)
        if category == "glasses":
            hinge, temple = shape.joint_origins[1], shape.parts[1].bounds()
            before = source.parts[1].bounds()[1, 2] - source.joint_origins[1, 2]
            assert temple[1, 2] - hinge[2] == pytest.approx(before, abs=0.002), "temples still start at the hinge"
        if category == "laptop_articulated":
            gap = shape.parts[1].bounds()[0, 1] - shape.parts[0].bounds()[1, 1]
            assert gap == pytest.approx(source.parts[1].bounds()[0, 1] - source.parts[0].bounds()[1, 1], abs=0.003)
        if category == "drawers":
            depth = shape.sizes[3, 2] / source.sizes[3, 2]
            np.testing.assert_allclose(shape.joint_limits, source.joint_limits * depth, rtol=1e-4)
    assert np.std(sizes, axis=0).min() > 0.03
    assert 0.4 < np.min(sizes) < np.max(sizes) < 2.5


def test_library_objects_are_mixed_in(library: Path) -> None:
    draw = shape_source("laptop_articulated", load_meshes(library, "laptop_articulated", "train"), 0.5)
    rng = np.random.default_rng(0)
    boxes = np.mean([len(draw(rng).parts[1].faces) == 12 for _ in range(200)])
    assert 0.01 < boxes < 0.12

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

from captra.data.articulated_meshes import LibraryError
from captra.data.credits import Credit
from captra.data.meshes import SHARE_PER_MESH, deformed, load_meshes, shape_source
from captra.data.shapes import make_shape
from captra.data.shapes.shape import rigid_shape
from captra.data.shapes.surfaces import box


@pytest.fixture
def library(tmp_path: Path) -> Path:
    index = {}
    for name, use in (("mug/train_me", "train"), ("mug/spare_me", "validate"), ("bottle/other", "train")):
        path = tmp_path / f"{name}.ply"
        path.parent.mkdir(exist_ok=True)
        mesh = box((0.12, 0.1, 0.08)).moved(translation=np.array([0.3, 0, 0]))
        trimesh.Trimesh(mesh.vertices, mesh.faces).export(path)
        index[name] = {"use": use, "licence": "CC0", "extents_m": [0.12, 0.1, 0.08], "notes": "a box"}
    (tmp_path / "INDEX.json").write_text(json.dumps(index))
    return tmp_path


def test_only_objects_of_the_category_and_use_are_read_and_they_are_centred(library: Path) -> None:
    (mug,) = load_meshes(library, "mug", "train")
    assert (mug.name, mug.credit, mug.notes) == ("mug/train_me", Credit("CC0", ""), "a box")
    np.testing.assert_allclose(mug.shape.sizes[0], [0.12, 0.1, 0.08], atol=1e-6)
    np.testing.assert_allclose(mug.shape.centers[0], 0, atol=1e-6)
    assert load_meshes(library, "laptop", "train") == ()


def test_a_missing_library_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(LibraryError, match=r"INDEX\.json"):
        load_meshes(tmp_path, "mug", "train")


@pytest.mark.parametrize("category", ["bottle", "mug"])
def test_deformations_change_proportions_and_keep_centre_and_symmetry(category: str) -> None:
    rng = np.random.default_rng(1)
    source = make_shape(category, np.random.default_rng(8))
    sizes = []
    for _ in range(20):
        shape = deformed(source, rng)
        sizes.append(shape.sizes[0] / source.sizes[0])
        np.testing.assert_allclose(shape.parts[0].bounds().mean(0), 0, atol=1e-6)
        if category == "bottle":
            assert shape.sizes[0, 0] / shape.sizes[0, 2] == pytest.approx(
                source.sizes[0, 0] / source.sizes[0, 2], rel=0.02
            )
    assert np.std(sizes, axis=0).min() > 0.05
    assert 0.5 < np.min(sizes) < np.max(sizes) < 2


def test_deformed_laptops_stay_flat_and_deformed_lenses_almost_round() -> None:
    rng = np.random.default_rng(1)
    laptop, camera = (make_shape(category, np.random.default_rng(8)) for category in ("laptop", "camera"))
    for _ in range(20):
        before = laptop.parts[0].vertices
        away = np.abs(before).min(1) > 0.01
        stretched = deformed(laptop, rng).parts[0].vertices[away] / before[away]
        assert np.ptp(stretched, axis=0).max() < 1e-3, "one factor for all points"
        ratio = deformed(camera, rng).sizes[0] / camera.sizes[0]
        assert ratio[1] / ratio[2] == pytest.approx(1.0, abs=0.18)


def test_library_objects_come_in_at_most_their_share(library: Path) -> None:
    meshes = load_meshes(library, "mug", "train")
    draw = shape_source("mug", meshes, mesh_fraction=0.5)
    rng = np.random.default_rng(0)
    boxes = np.mean([len(draw(rng).parts[0].faces) == 12 for _ in range(400)])
    assert 0.3 * SHARE_PER_MESH < boxes < 2 * SHARE_PER_MESH
    assert all(len(shape_source("mug", (), 0.5)(rng).parts[0].faces) > 12 for _ in range(5))


def test_parts_are_joined_and_centred() -> None:
    shape = rigid_shape("mug", [box((1, 1, 1)), box((1, 1, 1)).moved(translation=np.array([2.0, 0, 0]))])
    np.testing.assert_allclose(shape.sizes, [[3, 1, 1]])
    np.testing.assert_allclose(shape.centers, 0, atol=1e-6)

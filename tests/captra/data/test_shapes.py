import numpy as np
import pytest
import trimesh

from captra.categories import UnknownCategoryError
from captra.data.shapes import Shape, make_shape
from captra.data.shapes.curves import polygon_factor, resampled, rounded_polyline, superellipse
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.registry import MAKERS
from captra.data.shapes.surfaces import box, capsule, revolve, rounded_box, superellipsoid, tube

SEEDS = range(16)


def draw(category: str, seed: int) -> Shape:
    return make_shape(category, np.random.default_rng([17, seed]))


def as_trimesh(mesh: Mesh) -> trimesh.Trimesh:
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)


@pytest.mark.parametrize("category", sorted(MAKERS))
@pytest.mark.parametrize("seed", SEEDS)
def test_instances_are_closed_finite_and_centred(category: str, seed: int) -> None:
    shape = draw(category, seed)
    whole = merged(shape.parts)
    assert np.isfinite(whole.vertices).all()
    assert whole.vertices.dtype == np.float32
    assert whole.faces.min() == 0
    assert whole.faces.max() == len(whole.vertices) - 1
    assert all(as_trimesh(part).is_watertight for part in shape.parts)
    assert all(as_trimesh(part).volume > 0 for part in shape.parts), "faces are wound outwards"
    np.testing.assert_allclose(whole.bounds().mean(0), 0, atol=1e-6)


@pytest.mark.parametrize("category", sorted(MAKERS))
def test_the_same_seed_makes_the_same_instance_and_another_makes_another(category: str) -> None:
    first, again, other = draw(category, 1), draw(category, 1), draw(category, 2)
    np.testing.assert_array_equal(first.parts[0].vertices, again.parts[0].vertices)
    assert not np.allclose(first.sizes, other.sizes)


@pytest.mark.parametrize("category", ["bottle", "mug"])
def test_sizes_are_those_of_household_objects_and_vary(category: str) -> None:
    scales = np.array([draw(category, seed).scale for seed in range(100)])
    assert 0.04 < scales.min() < 0.12
    assert 0.2 < scales.max() < 0.45
    assert scales.std() > 0.03


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mug_has_its_handle_towards_plus_x(seed: int) -> None:
    shape = draw("mug", seed)
    vertices, size = shape.parts[0].vertices, shape.sizes[0]
    tip = vertices[vertices[:, 0] > size[0] / 2 - 0.002]
    assert np.abs(tip[:, 2]).max() < 0.55 * size[2] / 2, "what reaches furthest to +x is narrow: a handle"
    lower = vertices[vertices[:, 0] < 0]
    assert np.abs(lower[:, 2]).max() > 0.7 * size[2] / 2, "the body lies towards -x"


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mug_is_hollow_from_above(seed: int) -> None:
    shape = draw("mug", seed)
    mesh, size = as_trimesh(shape.parts[0]), shape.sizes[0]
    axis_x = -size[0] / 2 + size[2] / 2
    hit = mesh.ray.intersects_location([[axis_x, size[1], 0.001]], [[0, -1.0, 0]])[0]
    assert len(hit) > 0
    depth = size[1] / 2 - hit[:, 1].max()
    assert -1e-6 < depth < size[1]


@pytest.mark.parametrize("seed", SEEDS)
def test_a_bottle_is_symmetric_about_its_box(seed: int) -> None:
    vertices = draw("bottle", seed).parts[0].vertices
    size = np.ptp(vertices, axis=0)
    low = vertices[vertices[:, 1] < -0.2 * size[1]]
    np.testing.assert_allclose((low.max(0) + low.min(0))[[0, 2]] / 2, 0, atol=0.02 * size[0] + 1e-4)


def test_most_bottles_are_round() -> None:
    sizes = np.array([draw("bottle", seed).sizes[0] for seed in range(150)])
    assert np.mean(np.abs(sizes[:, 0] / sizes[:, 2] - 1) < 0.02) > 0.8


def test_an_unknown_category_names_those_that_exist() -> None:
    with pytest.raises(UnknownCategoryError, match="mug"):
        make_shape("teapot", np.random.default_rng(0))


def test_solids_are_closed_and_of_the_right_volume() -> None:
    z = np.array([0.0, 0, 1])
    arc = np.linspace(0, 1, 9)
    bent = np.column_stack([np.cos(arc), np.sin(arc), np.zeros(9)])
    solids = {
        "box": (box((1, 2, 3)), 6.0),
        "cylinder": (revolve(np.array([[0, 0], [1, 0], [1, 2], [0, 2]]), segments=200), 2 * np.pi),
        "ball": (superellipsoid((2, 2, 2), 2.0, 80), 4 / 3 * np.pi),
        "capsule": (capsule(2, 0.5, segments=60), np.pi * 0.25 * 2 + 4 / 3 * np.pi * 0.125),
        "rounded box": (rounded_box((1, 1, 1), 60.0, 1e-4, 400), 1.0),
        "tube": (tube(bent, 0.1, z, 40), np.pi * 0.01),
    }
    for name, (mesh, volume) in solids.items():
        solid = as_trimesh(mesh)
        assert solid.is_watertight, name
        assert solid.volume == pytest.approx(volume, rel=0.12), name


def test_rounding_keeps_the_ends_and_cuts_the_corners() -> None:
    corner = np.array([[0.0, 0], [1, 0], [1, 1]])
    curve = rounded_polyline(corner, 0.3)
    np.testing.assert_array_equal(curve[[0, -1]], corner[[0, -1]])
    assert np.linalg.norm(curve - corner[1], axis=1).min() > 0.1
    np.testing.assert_allclose(np.linalg.norm(np.diff(resampled(corner, 9), axis=0), axis=1), 0.25)


def test_superellipses_pass_through_their_half_axes() -> None:
    for exponent in (2.0, 4.0, 9.0):
        curve = superellipse(16, exponent, (2.0, 1.0))
        np.testing.assert_allclose(curve.max(0), [2, 1])
    assert polygon_factor(np.zeros(1), 6, 0.0)[0] == pytest.approx(1.0)
    assert polygon_factor(np.array([np.pi / 6]), 6, 0.0)[0] == pytest.approx(np.cos(np.pi / 6))

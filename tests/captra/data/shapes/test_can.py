import numpy as np
import pytest
import trimesh

from captra.data.shapes import Shape, make_shape
from captra.data.shapes.can_outlines import canister, drink, flat, food, wall

SEEDS = range(14)


def draw(seed: int) -> Shape:
    return make_shape("can", np.random.default_rng([17, seed]))


def test_cans_are_tall_slim_and_flat() -> None:
    sizes = np.array([draw(seed).sizes[0] for seed in range(100)])
    ratio = sizes[:, 1] / sizes[:, 0]
    assert ratio.min() < 0.6
    assert np.quantile(ratio, 0.9) > 2.0
    assert 0.045 < sizes[:, 0].min() < 0.06
    assert 0.1 < sizes[:, 0].max() < 0.18
    assert sizes[:, 1].max() < 0.32


@pytest.mark.parametrize("seed", SEEDS)
def test_the_axis_of_symmetry_runs_through_the_middle_of_the_box(seed: int) -> None:
    """Dents, tabs and lids that hang on do not shift the box off the axis of the rims."""
    vertices = draw(seed).parts[0].vertices
    low = vertices[:, 1].min()
    foot = vertices[vertices[:, 1] < low + 0.001]
    np.testing.assert_allclose((foot.max(0) + foot.min(0))[[0, 2]] / 2, 0, atol=6e-4)


def test_some_cans_are_open() -> None:
    depth = []
    for seed in range(50):
        shape = draw(seed)
        size = shape.sizes[0]
        mesh = trimesh.Trimesh(*shape.parts[0], process=False)
        hit = mesh.ray.intersects_location([[0.001, size[1], 0.3 * size[2]]], [[0, -1.0, 0]])[0]
        depth.append((size[1] / 2 - hit[:, 1].max()) / size[1])
    assert 0.05 < np.mean(np.array(depth) > 0.3) < 0.4


def test_some_cans_are_dented_but_only_inwards() -> None:
    dented = 0
    for seed in range(50):
        shape = draw(seed)
        vertices, size = shape.parts[0].vertices, shape.sizes[0]
        wall_band = vertices[np.abs(vertices[:, 1]) < 0.2 * size[1]]
        radius = np.hypot(wall_band[:, 0], wall_band[:, 2])
        dented += bool(np.quantile(radius, 0.1) < 0.93 * np.quantile(radius, 0.95))
    assert 3 < dented < 40


def test_walls_run_from_the_table_to_the_rim_at_their_radius() -> None:
    for kind in (drink, food, flat, canister):
        for seed in range(20):
            rng = np.random.default_rng(seed)
            plan = kind(rng)
            outline = wall(rng, plan)
            assert outline[0, 1] == 0
            assert outline[-1, 1] == pytest.approx(plan.height)
            assert (np.diff(outline[:, 1]) >= 0).all()
            assert np.abs(outline[:, 0] / plan.radius - 1).max() < 0.45

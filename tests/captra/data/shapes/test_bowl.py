import numpy as np
import pytest
import trimesh

from captra.data.shapes import Shape, make_shape
from captra.data.shapes.bowl_outlines import FAMILIES

SEEDS = range(14)


def draw(seed: int) -> Shape:
    return make_shape("bowl", np.random.default_rng([17, seed]))


def height_above_axis(shape: Shape) -> float:
    """Highest point of the mesh on the axis of symmetry, from the lower end of the box, relative to the height."""
    mesh = trimesh.Trimesh(*shape.parts[0], process=False)
    size = shape.sizes[0]
    hit = mesh.ray.intersects_location([[1e-4, size[1], 1e-4]], [[0, -1.0, 0]])[0]
    return float((hit[:, 1].max() + size[1] / 2) / size[1])


def test_bowls_are_deep_and_flat_small_and_large() -> None:
    sizes = np.array([draw(seed).sizes[0] for seed in range(100)])
    width, ratio = sizes[:, 0], sizes[:, 1] / sizes[:, 0]
    assert width.min() < 0.11
    assert 0.25 < width.max() < 0.45
    assert 0.12 < np.median(width) < 0.21
    assert np.quantile(ratio, 0.05) < 0.25
    assert np.quantile(ratio, 0.95) > 0.5


def test_most_bowls_are_round_and_some_are_not() -> None:
    sizes = np.array([draw(seed).sizes[0] for seed in range(100)])
    round_ones = np.abs(sizes[:, 0] / sizes[:, 2] - 1) < 0.02
    assert 0.9 < round_ones.mean() < 1.0


def test_bowls_are_hollow() -> None:
    level = np.array([height_above_axis(draw(seed)) for seed in SEEDS])
    assert (level < 0.99).all(), "nothing on the axis stands out above the rim"
    assert np.median(level) < 0.4


@pytest.mark.parametrize("seed", SEEDS)
def test_the_axis_of_symmetry_runs_through_the_middle_of_the_box(seed: int) -> None:
    vertices = draw(seed).parts[0].vertices
    for low, high in ((-0.5, -0.2), (-0.2, 0.2), (0.2, 0.5)):
        at = vertices[:, 1] / np.ptp(vertices[:, 1])
        middle = vertices[(at >= low) & (at <= high)]
        np.testing.assert_allclose((middle.max(0) + middle.min(0))[[0, 2]], 0, atol=4e-4)


def test_every_outline_ends_at_its_rim_and_rises() -> None:
    for _, family in FAMILIES:
        for seed in range(10):
            outline = family(np.random.default_rng(seed))
            assert outline.radius[-1] == pytest.approx(1.0, abs=0.02), family.__name__
            assert (np.diff(outline.height) >= -1e-9).all(), family.__name__
            assert outline.height[0] == pytest.approx(0.0, abs=1e-9)
            assert outline.radius.min() > 0.1

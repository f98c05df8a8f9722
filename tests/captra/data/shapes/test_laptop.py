import numpy as np
import pytest
import trimesh

from captra.data.shapes import Shape, make_shape
from captra.data.shapes.laptop import draw_opening_deg, lid_rotation
from captra.data.shapes.laptop_parts import draw_plan, make_base, make_lid
from captra.data.shapes.mesh import merged
from captra.geometry import is_rotation

SEEDS = range(14)


def draw(seed: int) -> Shape:
    return make_shape("laptop", np.random.default_rng([17, seed]))


def opening_deg(shape: Shape) -> float:
    """Measured on the mesh: direction of the upper half of what stands up."""
    vertices = shape.parts[0].vertices.astype(np.float64)
    high = vertices[vertices[:, 1] > 0.05 * np.ptp(vertices[:, 1])][:, :2]
    along = np.linalg.svd(high - high.mean(0), full_matrices=False)[2][0]
    along = along if along[1] > 0 else -along
    return float(np.degrees(np.arctan2(along[1], along[0])))


@pytest.mark.parametrize("seed", SEEDS)
def test_the_screen_stands_at_minus_x_and_the_keyboard_lies_at_plus_x(seed: int) -> None:
    shape = draw(seed)
    vertices, size = shape.parts[0].vertices, shape.sizes[0]
    if not 75 < opening_deg(shape) < 145:
        pytest.skip("the lid leans over the keyboard or lies almost flat")
    upper = vertices[vertices[:, 1] > 0.1 * size[1]]
    front = vertices[vertices[:, 0] > 0.3 * size[0]]
    assert upper[:, 0].mean() < 0
    assert front[:, 1].max() < 0, "nothing stands on the side of the keyboard"
    assert np.ptp(front[:, 2]) == pytest.approx(size[2], rel=0.25)


def test_opening_angles_span_sixty_to_a_hundred_and_fifty_degrees() -> None:
    angles = np.array([draw_opening_deg(np.random.default_rng(seed)) for seed in range(300)])
    assert 60 <= angles.min() < 68
    assert 142 < angles.max() <= 150
    assert 95 < np.median(angles) < 115
    measured = np.array([opening_deg(draw(seed)) for seed in range(50)])
    assert measured.min() < 85
    assert measured.max() > 130


@pytest.mark.parametrize("angle", [60, 90, 120, 150])
def test_lids_turn_about_the_hinge_and_face_the_keyboard(angle: int) -> None:
    turn = lid_rotation(np.radians(angle))
    assert is_rotation(turn)
    far, front = turn[:, 0], turn[:, 1]
    assert np.degrees(np.arccos(far @ [1, 0, 0])) == pytest.approx(angle)
    assert far[1] > 0
    assert front[0] > 0, "the screen is seen from +x"


def test_sizes_are_those_of_ten_to_seventeen_inches() -> None:
    sizes = np.array([draw(seed).sizes[0] for seed in range(60)])
    assert 0.2 < sizes[:, 2].min() < 0.27
    assert 0.37 < sizes[:, 2].max() < 0.47
    plans = [draw_plan(np.random.default_rng(seed)) for seed in range(100)]
    base = np.array([plan.base_thickness for plan in plans])
    assert base.min() < 0.01
    assert base.max() > 0.028


def test_keyboard_and_screen_are_sunk() -> None:
    for seed in range(20):
        rng = np.random.default_rng(seed)
        plan = draw_plan(rng)
        for meshes in (make_base(rng, plan), make_lid(rng, plan)):
            solid = trimesh.Trimesh(*meshes[0], process=False)
            assert solid.is_watertight
            middle = solid.vertices[-1]
            assert -0.006 < middle[1] < 0, "the middle of the upper side lies below its edge"
            assert merged(meshes).bounds()[1, 1] < 0.004

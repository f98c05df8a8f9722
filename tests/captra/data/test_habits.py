import numpy as np
import pytest

from captra.data.habits import HABITS, Habits, habits_of
from captra.data.holders import HOLDERS, USUAL, make_holder
from captra.data.scenes import held_scene, make_scene, resting_rotation, table_scene
from captra.data.shapes import make_shape
from captra.data.shapes.registry import MAKERS


def test_habits_and_holders_name_known_categories() -> None:
    assert set(HABITS) | set(HOLDERS) <= set(MAKERS)
    assert habits_of("mug") == Habits()
    for habits in HABITS.values():
        assert set(habits.neighbours) <= set(MAKERS)
        assert 0 <= habits.contents <= 1


def test_laptops_stand_more_often_than_cans() -> None:
    upright = {}
    for category in ("laptop", "can"):
        rng = np.random.default_rng(1)
        vertices = make_shape(category, rng).parts[0].vertices
        turns = [resting_rotation(rng, vertices, habits_of(category)) for _ in range(150)]
        upright[category] = np.mean([turn[1, 1] > 0.98 for turn in turns])
    assert upright["laptop"] > 0.8
    assert 0.5 < upright["can"] < 0.8


def test_laptops_are_held_less_often() -> None:
    rng = np.random.default_rng(2)
    laptop, mug = make_shape("laptop", rng), make_shape("mug", rng)
    held = {
        shape.category: np.mean([make_scene(shape, rng, held_fraction=0.9).lowest_elevation_deg < 0 for _ in range(40)])
        for shape in (laptop, mug)
    }
    assert held["mug"] > 0.75
    assert held["laptop"] < 0.65


def test_bowls_contain_things_while_they_are_upright() -> None:
    rng = np.random.default_rng(3)
    bowl = make_shape("bowl", rng)
    filled = 0
    for _ in range(25):
        scene = table_scene(bowl, np.zeros(0), rng)
        things = [mesh for mesh in scene.attached if len(mesh.vertices) < 400]
        filled += bool(things)
        assert scene.rotation[1, 1] > 0.8 or len(scene.attached) <= 1, "what is turned over is empty"
    assert 2 < filled < 18


@pytest.mark.parametrize("category", ["bowl", "camera", "can", "laptop"])
def test_things_are_held_by_one_of_their_holders(category: str) -> None:
    rng = np.random.default_rng(4)
    shape = make_shape(category, rng)
    counts = {len(make_holder(rng, shape.parts[0].vertices, category).vertices) for _ in range(25)}
    assert len(counts) > 3, "several kinds of hands"
    assert sum(weight for weight, _ in HOLDERS.get(category, USUAL)) > 0
    assert len(held_scene(shape, np.zeros(0), rng).attached) <= 1 + 5

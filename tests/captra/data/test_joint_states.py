import numpy as np
import pytest

from captra.data.joint_states import AVERAGE_CHANGE, draw_joint_path, draw_joint_values
from captra.data.shapes import make_shape

CATEGORIES = sorted(AVERAGE_CHANGE)


@pytest.mark.parametrize("category", CATEGORIES)
def test_single_states_fill_the_range_and_favour_its_near_end(category: str) -> None:
    rng = np.random.default_rng(0)
    shape = make_shape(category, rng)
    low, high = shape.joint_limits.T
    values = np.array([draw_joint_values(shape, rng) for _ in range(400)])
    assert (values >= low - 1e-6).all()
    assert (values <= high + 1e-6).all()
    share = (values - low) / (high - low)
    assert share.min() < 0.05
    assert share.max() > 0.95
    near = np.where(np.abs(low) < np.abs(high), low, high)
    assert 0.05 < np.isclose(values, near).mean() < 0.25


@pytest.mark.parametrize("category", CATEGORIES)
def test_paths_change_by_about_the_papers_average_within_100_frames(category: str) -> None:
    rng = np.random.default_rng(1)
    shape = make_shape(category, rng)
    paths = np.array([draw_joint_path(shape, 100, rng) for _ in range(80)])
    change = np.ptp(paths, axis=1)
    assert change.mean() == pytest.approx(AVERAGE_CHANGE[category], rel=0.12)
    assert change.max() <= 1.5 * AVERAGE_CHANGE[category] + 1e-9
    assert (paths >= shape.joint_limits[:, 0] - 1e-6).all()
    assert (paths <= shape.joint_limits[:, 1] + 1e-6).all()
    assert np.abs(np.diff(paths, axis=1)).max() < 0.09 * AVERAGE_CHANGE[category], "smooth"


def test_short_paths_move_at_the_same_pace_and_long_ones_stay_in_range() -> None:
    shape = make_shape("scissors", np.random.default_rng(2))
    rng = np.random.default_rng(3)
    short = np.mean([np.ptp(draw_joint_path(shape, 10, rng)) for _ in range(60)])
    assert short < 0.3 * AVERAGE_CHANGE["scissors"]
    for _ in range(40):
        path = draw_joint_path(shape, 500, rng)
        assert path.min() >= shape.joint_limits[0, 0] - 1e-6
        assert path.max() <= shape.joint_limits[0, 1] + 1e-6


def test_rigid_objects_have_no_joints_and_use_no_random_numbers() -> None:
    shape = make_shape("mug", np.random.default_rng(0))
    rng, untouched = np.random.default_rng(5), np.random.default_rng(5)
    assert draw_joint_values(shape, rng).shape == (0,)
    assert draw_joint_path(shape, 7, rng).shape == (7, 0)
    assert rng.random() == untouched.random()

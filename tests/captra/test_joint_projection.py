import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import CATEGORIES, Category, get_category
from captra.fitting import mean_rotation, rotation_about_axis
from captra.geometry import axis_angle, rotation_angle
from captra.joint_projection import ALONG_AXES, UNPROJECTED, OntoAxes, Pooled, PooledByPoints

ARTICULATED = pytest.mark.parametrize("name", [name for name, one in CATEGORIES.items() if one.joints])


def turned(name: str, seed: int, error_rad: float) -> tuple[np.ndarray, np.ndarray]:
    """True rotations of an object with turned joints, and the same with errors in the children."""
    rng, category = np.random.default_rng(seed), get_category(name)
    truth = np.tile(axis_angle(rng.standard_normal(3), 1.0), (category.num_parts, 1, 1))
    for joint in category.joints:
        if joint.kind == "revolute":
            truth[joint.child] = truth[joint.parent] @ axis_angle(np.array(joint.axis), rng.uniform(0.2, 1.5))
    wrong = truth.copy()
    for joint in category.joints:
        across = np.cross(joint.axis, rng.standard_normal(3))
        wrong[joint.child] = wrong[joint.child] @ axis_angle(across, error_rad)
    return truth, wrong


def all_alike(rotation: np.ndarray) -> np.ndarray:
    """As many points of every part."""
    return np.full(len(rotation), 100)


def error(rotation: np.ndarray, truth: np.ndarray) -> float:
    return float(rotation_angle(np.swapaxes(truth, -1, -2) @ rotation).max())


@ARTICULATED
def test_errors_across_the_axes_go_away(name: str) -> None:
    truth, wrong = turned(name, 0, 0.1)
    projected = OntoAxes()(wrong, all_alike(wrong), get_category(name))
    assert error(projected, truth) < 0.01 < error(wrong, truth)
    np.testing.assert_array_equal(UNPROJECTED(wrong, all_alike(wrong), get_category(name)), wrong)


@ARTICULATED
@given(seed=st.integers(0, 1000), error_rad=st.floats(0, 0.5))
def test_projecting_twice_changes_nothing_more(name: str, seed: int, error_rad: float) -> None:
    category = get_category(name)
    wrong = turned(name, seed, error_rad)[1]
    once = OntoAxes()(wrong, all_alike(wrong), category)
    np.testing.assert_allclose(OntoAxes()(once, all_alike(once), category), once, atol=1e-9)


def test_an_axis_given_by_the_session_is_the_one_about_which_parts_turn() -> None:
    category, axis = get_category("scissors"), (0.0, 0.6, 0.8)
    _, wrong = turned("scissors", 1, 0.2)
    projected = OntoAxes(axes={"pivot": axis})(wrong, all_alike(wrong), category)
    relative = projected[0].T @ projected[1]
    np.testing.assert_allclose(rotation_about_axis(relative, np.array(axis)), relative, atol=1e-9)


@ARTICULATED
def test_pooling_leaves_what_joints_allow_as_it_is(name: str) -> None:
    truth, _ = turned(name, 4, 0.0)
    assert error(Pooled()(truth, all_alike(truth), get_category(name)), truth) < 1e-6


@ARTICULATED
def test_a_wrong_root_is_outvoted_by_its_children(name: str) -> None:
    category = get_category(name)
    truth, wrong = turned(name, 5, 0.0)
    wrong[category.root] = wrong[category.root] @ axis_angle(np.array([0.5, 0.5, 0.7]), 0.2)
    root = category.root

    def off(rotation: np.ndarray) -> float:
        return error(rotation[root : root + 1], truth[root : root + 1])

    assert off(Pooled()(wrong, all_alike(wrong), category)) < 0.95 * off(ALONG_AXES(wrong, all_alike(wrong), category))


def test_four_views_of_one_rotation_become_their_mean() -> None:
    rng = np.random.default_rng(6)
    truth = np.tile(axis_angle(rng.standard_normal(3), 1.0), (4, 1, 1))
    wrong = truth @ axis_angle(rng.standard_normal((4, 3)), np.full(4, 0.1))
    pooled = Pooled()(wrong, all_alike(wrong), get_category("drawers"))
    np.testing.assert_allclose(pooled, np.tile(mean_rotation(wrong), (4, 1, 1)), atol=1e-9)


@pytest.mark.parametrize("category", CATEGORIES.values(), ids=str)
def test_every_joint_hangs_on_the_root(category: Category) -> None:
    assert all(joint.parent == category.root for joint in category.joints)


@pytest.mark.parametrize("hidden", [0, 1])
def test_a_part_of_which_little_is_seen_does_not_turn_away_one_that_is_plain_to_see(hidden: int) -> None:
    category = get_category("laptop_articulated")
    truth, _ = turned("laptop_articulated", 3, 0.0)
    wrong = truth.copy()
    wrong[hidden] = wrong[hidden] @ axis_angle(np.array([0.0, 1.0, 0.0]), 0.3)
    seen = np.where(np.arange(2) == hidden, 50, 950)
    told, alike = (projection(wrong, seen, category) for projection in (PooledByPoints(), Pooled()))
    assert rotation_angle(truth[1 - hidden].T @ told[1 - hidden]) < 0.02
    assert rotation_angle(truth[1 - hidden].T @ alike[1 - hidden]) > 0.1
    assert error(PooledByPoints()(truth, np.zeros(2, int), category), truth) < 1e-6

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import get_category
from captra.geometry import Pose, axis_angle
from captra.pose_memory import NO_ERROR, FoundError
from captra.stacking import stacked
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, surfaces

DRAWERS, GLASSES = get_category("drawers"), get_category("glasses")
BASE = DRAWERS.root
WIDE = FoundError(((0.2, 0.2, 0.2),))


def cabinet(seed: int) -> Pose:
    """Three drawers, one above the other with a little air, in a cabinet that stands anywhere."""
    rng = np.random.default_rng(seed)
    rotation = axis_angle(rng.standard_normal(3), rng.uniform(0, 3))
    place = np.array([[0.0, -0.3, 0.05], [0.0, 0.0, 0.1], [0.0, 0.25, 0.0], [0.0, 0.0, 0.0]])
    size = np.array([[0.5, 0.28, 0.4], [0.5, 0.28, 0.4], [0.5, 0.2, 0.4], [0.6, 0.9, 0.5]])
    return Pose.from_size(np.tile(rotation, (4, 1, 1)), rng.uniform(-1, 1, 3) + place @ rotation.T, size)


def before_camera(seed: int) -> Pose:
    """Two metres away."""
    pose = cabinet(seed)
    return replace(pose, translation=pose.translation - pose.translation[BASE] + [0, 0, 2.0])


def shifted(pose: Pose, part: int, own_m: tuple[float, float, float]) -> Pose:
    translation = np.array(pose.translation)
    translation[part] += pose.rotation[part] @ np.array(own_m)
    return replace(pose, translation=translation)


def own(pose: Pose, truth: Pose) -> np.ndarray:
    return np.asarray((pose.translation - truth.translation) @ truth.rotation[BASE])


@given(st.integers(0, 9))
def test_what_is_in_order_stays(seed: int) -> None:
    pose = cabinet(seed)
    np.testing.assert_allclose(stacked(pose, pose, DRAWERS, WIDE).translation, pose.translation, atol=1e-9)


@given(st.integers(0, 9))
def test_the_drawer_that_was_mistaken_for_its_neighbour_makes_way(seed: int) -> None:
    truth = cabinet(seed)
    left = own(stacked(shifted(truth, 1, (0, -0.28, 0.2)), truth, DRAWERS, WIDE), truth)
    assert abs(left[1, 1]) < 0.04
    assert abs(left[1, 2] - 0.2) < 1e-9
    np.testing.assert_allclose(np.delete(left, 1, axis=0), 0, atol=0.01)


@given(st.integers(0, 9))
def test_no_drawer_is_found_outside_its_cabinet(seed: int) -> None:
    truth = cabinet(seed)
    left = own(stacked(shifted(truth, 2, (0.3, 0.4, 0)), truth, DRAWERS, WIDE), truth)
    np.testing.assert_allclose(left[2], [0.05, 0.1, 0], atol=1e-9)


def test_fronts_that_were_given_outside_or_in_each_other_may_stay_so() -> None:
    odd = shifted(shifted(cabinet(1), 0, (0.2, 0, 0)), 2, (0, -0.1, 0))
    np.testing.assert_allclose(stacked(odd, odd, DRAWERS, WIDE).translation, odd.translation, atol=1e-9)


def test_nothing_moves_further_than_networks_may_err() -> None:
    truth = cabinet(2)
    found = shifted(truth, 1, (0, -0.28, 0))
    assert stacked(found, truth, DRAWERS, NO_ERROR).translation.tolist() == found.translation.tolist()
    little = FoundError(((0.001, 0.001, 0.001),))
    moved = stacked(found, truth, DRAWERS, little).translation - found.translation
    assert 0 < np.abs(moved).max() < 0.004 * truth.scale.max() + 1e-9


def test_parts_that_turn_stay_where_they_are() -> None:
    one = cabinet(3).part(0)
    three = Pose(*(np.repeat(values, 3, axis=0) for values in (one.rotation, one.translation, one.scale, one.size)))
    assert stacked(three, three, GLASSES, WIDE).translation.tolist() == three.translation.tolist()


def test_a_track_keeps_drawers_apart_that_look_alike() -> None:
    rng = np.random.default_rng(4)
    truth = before_camera(4)
    mistaken = shifted(truth, 1, (0, -0.28, 0))
    cloud = surfaces(mistaken, 1500, rng)
    tracker = Tracker(OracleNetworks(DRAWERS, mistaken, truth, found_error=FoundError(((0.03, 0.06, 0.03),))), truth)
    assert np.abs(own(tracker.step(cloud).pose, truth)[1, 1]) < 0.1

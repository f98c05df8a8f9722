from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import get_category
from captra.geometry import Pose, axis_angle
from captra.slides import FURTHEST, NO_SLIDES, Slides
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, surfaces

DRAWERS, SCISSORS = get_category("drawers"), get_category("scissors")
BASE = DRAWERS.root


def cabinet(seed: int) -> Pose:
    """Drawers at random places of a cabinet that stands anywhere; all parts are turned alike."""
    rng = np.random.default_rng(seed)
    rotation = axis_angle(rng.standard_normal(3), rng.uniform(0, 3))
    translation = rng.uniform(-1, 1, 3) + rng.uniform(-0.3, 0.3, (4, 3)) @ rotation.T
    return Pose.from_size(np.tile(rotation, (4, 1, 1)), translation, np.full((4, 3), 0.4))


def pulled(pose: Pose, offsets: np.ndarray) -> Pose:
    """Every part moved along its own axes."""
    return replace(pose, translation=pose.translation + np.einsum("pij,pj->pi", pose.rotation, offsets))


shifts = st.lists(st.floats(-0.2, 0.2), min_size=12, max_size=12).map(lambda flat: np.array(flat).reshape(4, 3))


@given(st.integers(0, 9), shifts)
def test_a_drawer_goes_where_its_slide_goes_and_keeps_how_far_it_is_open(seed: int, astray: np.ndarray) -> None:
    pose = cabinet(seed)
    astray[BASE] = 0
    held = Slides.through(pose, DRAWERS).apply(pulled(pose, astray))
    np.testing.assert_allclose(held.translation, pulled(pose, astray * [0, 0, 1]).translation, atol=1e-9)


@given(st.integers(0, 9), shifts)
def test_slides_go_with_the_cabinet(seed: int, opened: np.ndarray) -> None:
    pose = cabinet(seed)
    turn = axis_angle(np.array([1.0, -2.0, 0.5]), 0.7)
    moved = replace(pose, rotation=turn @ pose.rotation, translation=pose.translation @ turn.T + [0.3, 0.0, -0.2])
    moved = pulled(moved, opened * [0, 0, 1] * (np.arange(4) != BASE)[:, None])
    np.testing.assert_allclose(Slides.through(pose, DRAWERS).apply(moved).translation, moved.translation, atol=1e-9)


FILLED = np.ones((4, 3), bool)


def seen(frames: int, astray: np.ndarray, filled: np.ndarray = FILLED) -> np.ndarray:
    """How far off its slide the lowest drawer is put, metres, after so many frames in which it was seen so far off."""
    pose = cabinet(1)
    slides = Slides.through(pose, DRAWERS)
    off = np.where(np.arange(4)[:, None] == 0, astray, 0.0)
    for _ in range(frames):
        slides = slides.updated(pulled(pose, off), filled)
    return np.asarray((slides.apply(pose).translation - pose.translation)[0] @ pose.rotation[0])


def test_a_drawer_that_is_seen_from_edge_to_edge_tells_where_its_slide_runs_the_better_the_longer() -> None:
    astray = np.array([0.01, -0.02, 0.0])
    shares = np.stack([seen(frames, astray)[:2] / astray[:2] for frames in (0, 1, 10, 1000)])
    assert (np.diff(shares, axis=0) > 0.05).all()
    np.testing.assert_allclose(shares[[0, -1]], [[0.0, 0.0], [0.86, 0.86]], atol=0.01)


def test_each_axis_tells_of_itself_and_only_where_the_box_is_filled() -> None:
    across = FILLED & (np.arange(3) == 0)
    x, y, _ = seen(100, np.array([0.01, 0.01, 0.0]), across)
    assert x > 0.008
    assert y == pytest.approx(0, abs=1e-12)


def test_a_drawer_that_is_mistaken_for_its_neighbour_does_not_move_the_slide() -> None:
    furthest = FURTHEST * cabinet(1).size[0, 1]
    assert seen(100, np.array([0.0, 1.1 * furthest, 0.0]))[1] == pytest.approx(0, abs=1e-12)
    assert seen(100, np.array([0.0, 0.9 * furthest, 0.0]))[1] > 0.7 * furthest


def test_nothing_holds_parts_that_turn_or_are_not_known() -> None:
    pose = cabinet(1)
    assert NO_SLIDES.apply(pose).translation.tolist() == pose.translation.tolist()
    assert not Slides.through(pose.part(0), SCISSORS).of_joint


@pytest.mark.parametrize("again", [False, True])
def test_a_track_keeps_drawers_on_the_slides_of_the_given_pose(again: bool) -> None:
    rng = np.random.default_rng(3)
    truth = pulled(replace(cabinet(3), translation=np.zeros((4, 3))), 0.6 * np.arange(4)[:, None] * [1.0, 0, 0])
    cloud = surfaces(truth, 1500, rng)
    networks = OracleNetworks(DRAWERS, truth, truth)
    tracker = Tracker(networks, truth)
    first = tracker.step(cloud).pose
    networks.truth = pulled(truth, 0.02 * np.array([[0, 1, 1], *np.zeros((3, 3))]))
    if again:
        tracker.reset(networks.truth)
    drawer = (tracker.step(cloud).pose.translation - first.translation)[0] @ truth.rotation[0]
    assert drawer[2] == pytest.approx(0.02, abs=0.008)
    assert drawer[1] == pytest.approx(0.02 if again else 0.0, abs=0.008)

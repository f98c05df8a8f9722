from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import Category, get_category
from captra.containment import TIGHT, contained, filled
from captra.evidence import Evidence
from captra.geometry import Pose, axis_angle
from captra.tracker import Tracker
from tests.captra.test_confidence import GOOD
from tests.oracle import OracleNetworks, box_surface, scene

MUG, SCISSORS = get_category("mug"), get_category("scissors")
SIZE = np.array([0.2, 0.3, 0.1])


def box(seed: int) -> Pose:
    rng = np.random.default_rng(seed)
    return Pose.from_size(axis_angle(rng.standard_normal(3), 1.0)[None], rng.uniform(-1, 1, (1, 3)), SIZE[None])


def points_of(pose: Pose, own: np.ndarray) -> Evidence:
    points = own @ pose.rotation[0].T + pose.translation[0]
    return Evidence((replace(GOOD, explained=points),), 0.5, len(points))


def moved(pose: Pose, shift_own: np.ndarray) -> Pose:
    return replace(pose, translation=pose.translation + pose.rotation[0] @ shift_own)


shifts = st.tuples(*[st.floats(-0.05, 0.05)] * 3).map(np.array)


@given(shifts, st.integers(0, 9))
def test_points_on_every_side_bring_the_box_back(shift: np.ndarray, seed: int) -> None:
    truth = box(seed)
    surface = box_surface(SIZE, 4000, np.random.default_rng(seed))
    found = contained(moved(truth, shift), points_of(truth, surface), MUG)
    np.testing.assert_allclose(found.translation, truth.translation, atol=1e-6)
    np.testing.assert_array_equal(found.rotation, truth.rotation)
    np.testing.assert_array_equal(found.size, truth.size)


@given(shifts, st.integers(0, 9))
def test_a_box_that_holds_its_points_stays(shift: np.ndarray, seed: int) -> None:
    pose = moved(box(seed), shift)
    own = np.random.default_rng(seed).uniform(-0.5, 0.5, (500, 3)) * (SIZE - 2 * np.abs(shift))
    np.testing.assert_allclose(contained(pose, points_of(box(seed), own), MUG).translation, pose.translation, atol=1e-9)


def test_where_only_the_front_is_seen_the_box_moves_along_its_normal_and_no_further_than_it() -> None:
    truth = box(1)
    front = box_surface(SIZE, 4000, np.random.default_rng(1))
    front = front[front[:, 2] > 0.049]
    behind, before = np.array([0.0, 0.0, -0.03]), np.array([0.0, 0.0, 0.03])
    np.testing.assert_allclose(
        contained(moved(truth, behind), points_of(truth, front), MUG).translation, truth.translation, atol=1e-6
    )
    ahead = moved(truth, before)
    np.testing.assert_allclose(contained(ahead, points_of(truth, front), MUG).translation, ahead.translation, atol=1e-6)


def test_points_that_reach_further_than_the_box_end_up_around_its_middle() -> None:
    truth, longer = box(2), box_surface(SIZE * [1, 1.4, 1], 4000, np.random.default_rng(2))
    found = contained(moved(truth, np.array([0.0, 0.2, 0.0])), points_of(truth, longer), MUG)
    offset = truth.rotation[0].T @ (found.translation - truth.translation)[0]
    assert abs(offset[1]) <= 0.2 * SIZE[1] + 1e-6


@pytest.mark.parametrize(("strays", "category"), [(0, MUG), (30, MUG), (10, SCISSORS)])
def test_a_few_strays_and_a_few_points_say_nothing(strays: int, category: Category) -> None:
    truth, rng = box(3), np.random.default_rng(3)
    own = rng.uniform(-0.5, 0.5, (2000, 3)) * SIZE
    own[:strays] += [0.5, 0, 0]
    np.testing.assert_allclose(
        contained(truth, points_of(truth, own), category).translation, truth.translation, atol=1e-9
    )
    np.testing.assert_allclose(
        contained(truth, points_of(truth, own[:19] + 1), category).translation, truth.translation
    )


def test_a_few_points_count_where_nothing_else_is_around() -> None:
    truth, own = box(3), np.random.default_rng(3).uniform(-0.5, 0.5, (2000, 3)) * SIZE * [0.5, 1, 1]
    own[:30, 0] = 0.13
    moved_x = [
        float(
            (contained(truth, points_of(truth, own), one).translation - truth.translation)[0] @ truth.rotation[0, :, 0]
        )
        for one in (MUG, SCISSORS)
    ]
    assert moved_x == pytest.approx([0.0, 0.03], abs=1e-6)


@given(st.integers(0, 2), st.floats(0.5, 1.5), st.integers(0, 9))
def test_a_box_is_filled_along_the_axes_on_which_its_points_reach_from_side_to_side(
    axis: int, length: float, seed: int
) -> None:
    pose, stretched = box(seed), np.where(np.arange(3) == axis, length, 1.0)
    own = box_surface(SIZE * stretched, 4000, np.random.default_rng(seed))
    off = np.abs(length - 1) * SIZE[axis] / pose.scale[0]
    fills = filled(moved(pose, np.array([0.01, 0.02, 0.03])), points_of(pose, own))
    assert fills[0, (np.arange(3) != axis)].all(), "wherever the box was found"
    assert fills[0, axis] == (off < TIGHT)
    assert not filled(pose, points_of(pose, own[:19])).any(), "a few points say nothing"


def test_a_track_stays_around_its_points_though_coordinates_are_off() -> None:
    rng = np.random.default_rng(4)
    category, truth, cloud = scene("laptop_articulated", rng)
    networks = OracleNetworks(category, truth, truth)
    coordinates = networks.coordinates
    networks.coordinates = lambda *cloud: (coordinates(*cloud)[0], coordinates(*cloud)[1] + np.float32(0.05))  # type: ignore[method-assign]
    found = Tracker(networks, truth).step(cloud).pose
    assert np.abs(found.translation - truth.translation).max() < 0.003

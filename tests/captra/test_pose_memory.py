import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import Category, get_category
from captra.geometry import Pose, axis_angle
from captra.metrics import rotation_error_deg
from captra.pose_memory import FEW_POINTS, NO_ERROR, USUAL_ERROR, FoundError, PoseMemory
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, elsewhere, explaining, scene

DRAWERS, MUG = get_category("drawers"), get_category("mug")


def pose(parts: int, size_m: float, seed: int = 0) -> Pose:
    rng = np.random.default_rng(seed)
    rotation = axis_angle(rng.standard_normal((parts, 3)), rng.uniform(0, 3, parts))
    return Pose.from_size(rotation, rng.uniform(-1, 1, (parts, 3)), np.full((parts, 3), size_m))


def off_by(true: Pose, offset_part: np.ndarray) -> Pose:
    return replace(true, translation=true.translation + np.einsum("pij,j->pi", true.rotation, offset_part))


@given(st.integers(0, 9))
def test_what_networks_cannot_see_of_a_cabinet_is_taken_from_the_given_pose_wherever_it_goes(seed: int) -> None:
    true = pose(4, 0.8, seed)
    found = off_by(true, np.array([0.0, 0.0, -0.03]))
    memory = PoseMemory.between(true, found, DRAWERS)
    for where, there in ((true, found), (elsewhere(true), elsewhere(found))):
        left = np.linalg.norm(memory.apply(there, np.ones(4, bool)).translation - where.translation, axis=1)
        assert (left < 0.01).all()


@given(st.integers(0, 9))
def test_what_is_measured_of_an_axis_counts_for_that_axis_alone(seed: int) -> None:
    true = pose(4, 0.8, seed)
    error = FoundError(((0.0, 0.0, 0.05),) * 4, ((0.0, 6.0, 0.0),) * 4)
    off = axis_angle(np.array([1.0, 1.0, 0.0]), np.radians(4.0))
    found = off_by(replace(true, rotation=true.rotation @ off), np.array([0.02, 0.0, 0.02]))
    memory = PoseMemory.between(true, found, DRAWERS, error)
    assert np.abs(memory.offset_part[:, :2]).max() < 1e-12
    assert np.abs(memory.turn_part[:, [0, 2]]).max() < 1e-12
    assert (memory.turn_part[:, 1] < np.radians(-1.5)).all()
    assert (np.abs(memory.offset_part[:, 2]) > 0.01).all()


def test_what_a_manifest_says_is_read_and_what_it_does_not_say_is_usual() -> None:
    error = FoundError(((0.01, 0.02, 0.03),), ((1.0, 2.0, 3.0),), ((0.05,),), ((0.1, 0.2, 0.3),))
    kept = json.loads(json.dumps(error.calibration))
    assert FoundError.measured(kept) == error
    assert FoundError.measured({}) == USUAL_ERROR
    del kept["scale"], kept["side"]
    assert FoundError.measured(kept) == replace(error, scale=USUAL_ERROR.scale, side=USUAL_ERROR.side)


def test_a_centre_found_from_few_points_is_worth_less() -> None:
    error = FoundError(((0.01, 0.02, 0.03),), ((1.0, 2.0, 3.0),))
    seen = error.seen_by(explaining(0, 4, FEW_POINTS, 100 * FEW_POINTS))
    ratio = np.array(seen.centre) / error.centre
    np.testing.assert_allclose(ratio, ratio[:, :1] * np.ones(3))
    assert ratio[0, 0] > ratio[1, 0] > 3
    assert ratio[2, 0] == pytest.approx(np.sqrt(2))
    assert ratio[3, 0] == pytest.approx(1, abs=0.01)
    assert seen.rotation_deg == error.rotation_deg
    assert error.seen_by(explaining(4)) == error, "an object of one part is mistaken for no other"


def test_of_a_small_object_networks_know_the_centre_better_than_people() -> None:
    found = pose(1, 0.08)
    rough = off_by(found, np.array([0.02, -0.01, 0.02]))
    offset = PoseMemory.between(rough, found, MUG).offset_part
    assert np.abs(offset).max() < 0.001


def test_a_given_pose_that_is_far_off_is_doubted() -> None:
    found = pose(4, 0.8)
    offsets = [
        PoseMemory.between(off_by(found, np.array([far, 0.0, 0.0])), found, DRAWERS).offset_part[0, 0] / far
        for far in (0.02, 0.1, 0.5)
    ]
    assert offsets[0] > 0.7
    assert offsets[0] > offsets[1] > offsets[2]
    assert offsets[2] < 0.25


@given(st.integers(0, 9), st.sampled_from([DRAWERS, MUG]))
def test_a_turn_that_networks_are_off_by_all_the_time_is_taken_back_in_part(seed: int, category: Category) -> None:
    true = pose(category.num_parts, 0.1, seed)
    off = axis_angle(np.array([0.0, 1.0, 0.0]), np.radians(6.0))
    found = replace(true, rotation=true.rotation @ off)
    memory, every = PoseMemory.between(true, found, category), np.ones(category.num_parts, bool)
    for where, there in ((true, found), (elsewhere(true), elsewhere(found))):
        left = rotation_error_deg(memory.apply(there, every).rotation, where.rotation, symmetric=False)
        assert (left < 5.3).all()
        assert (left > 2.0).all()


def test_a_first_pose_that_is_turned_by_far_is_forgotten() -> None:
    found = pose(1, 0.1)
    wrong = replace(found, rotation=found.rotation @ axis_angle(np.array([1.0, 0.0, 0.0]), np.radians(50.0)))
    turn = PoseMemory.between(wrong, found, MUG).turn_part
    assert np.degrees(np.linalg.norm(turn)) < 2


def test_networks_may_be_taken_at_their_word() -> None:
    found, given_pose = pose(4, 0.8), pose(4, 0.8, 1)
    memory = PoseMemory.between(given_pose, found, DRAWERS, NO_ERROR)
    for nothing in (memory, PoseMemory.nothing_known(4)):
        np.testing.assert_allclose(nothing.apply(found, np.ones(4, bool)).rotation, found.rotation)
        np.testing.assert_allclose(nothing.apply(found, np.ones(4, bool)).translation, found.translation)


def test_parts_that_were_not_fitted_stay() -> None:
    found, fitted = pose(4, 0.8), np.array([True, False, True, False])
    after = PoseMemory(np.full((4, 3), 0.01), np.full((4, 3), 0.1)).apply(found, fitted)
    for now, before in ((after.translation, found.translation), (after.rotation, found.rotation)):
        np.testing.assert_array_equal(now[~fitted], before[~fitted])
        assert np.abs(now[fitted] - before[fitted]).reshape(2, -1).max(axis=1).min() > 1e-3


@pytest.mark.parametrize("again", [False, True])
def test_a_track_remembers_the_given_centre_until_it_is_given_another(again: bool) -> None:
    rng = np.random.default_rng(1)
    category, small, cloud = scene("glasses", rng)
    truth = Pose(small.rotation, 8 * small.translation, 8 * small.scale, 8 * small.size)
    given_pose = off_by(truth, np.array([0.0, 0.0, 0.02]))
    networks = OracleNetworks(category, truth, given_pose)
    tracker = Tracker(networks, given_pose)
    if again:
        tracker.step(8 * cloud)
        tracker.reset(truth)
    for _ in range(5):
        found = tracker.step(8 * cloud).pose
    error = np.einsum("pji,pj->pi", truth.rotation, found.translation - truth.translation)
    np.testing.assert_allclose(error[:, 2], 0.0 if again else 0.015, atol=0.005)


def test_a_track_holds_on_to_the_given_centre_of_a_part_of_which_little_is_seen() -> None:
    rng = np.random.default_rng(2)
    category, truth, cloud = scene("glasses", rng)
    given_pose = off_by(truth, np.array([0.0, 0.0, 0.015]))
    held = []
    for seen in (cloud, np.concatenate([cloud[:20], cloud[3000:]])):
        networks = OracleNetworks(category, truth, given_pose)
        found = Tracker(networks, given_pose).step(seen).pose
        held.append(np.einsum("pji,pj->pi", truth.rotation, found.translation - truth.translation)[:, 2])
    assert held[1][0] > held[0][0] + 0.002
    np.testing.assert_allclose(held[1][1:], held[0][1:], atol=0.0005)

from dataclasses import replace

import numpy as np
import pytest

from captra.geometry import Pose
from captra.pose_memory import USUAL_ERROR
from captra.size_memory import SizeMemory
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, scene


def pose(scale: float = 0.2, size: tuple[float, float, float] = (0.1, 0.12, 0.1)) -> Pose:
    return Pose(np.eye(3)[None], np.array([[0.0, 0, 1]]), np.array([scale]), np.array([size]))


SEEN = np.ones(1, bool)


def remembered(given: Pose, measured: Pose, frames: int) -> SizeMemory:
    memory = SizeMemory.of(given)
    for _ in range(frames):
        memory = memory.updated(measured, SEEN)
    return memory


def test_before_the_first_frame_the_given_size_is_all_there_is() -> None:
    memory = SizeMemory.of(pose())
    np.testing.assert_array_equal(memory.scale, [0.2])
    np.testing.assert_array_equal(memory.size, [[0.1, 0.12, 0.1]])


def test_networks_that_are_a_little_off_all_the_time_do_not_talk_a_known_size_away() -> None:
    memory = remembered(pose(0.2), pose(0.21, (0.1, 0.13, 0.1)), 5000)
    assert 0.2 < memory.scale[0] < 0.2075
    assert 0.12 < memory.size[0, 1] < 0.1225
    np.testing.assert_allclose(memory.size[0, [0, 2]], 0.1)


def test_a_given_size_that_is_far_off_is_doubted_in_time() -> None:
    assert remembered(pose(0.2), pose(0.3), 1).scale[0] == pytest.approx(0.2, rel=0.02)
    assert remembered(pose(0.2), pose(0.3), 300).scale[0] == pytest.approx(0.3, rel=0.03)
    assert remembered(pose(0.2), pose(0.2, (0.1, 0.3, 0.1)), 300).size[0, 1] == pytest.approx(0.3, rel=0.15)


def test_a_thin_side_is_measured_worse_than_a_long_one() -> None:
    given, measured = pose(0.2, (0.01, 0.15, 0.1)), pose(0.2, (0.015, 0.225, 0.15))
    gained = np.log(remembered(given, measured, 100).size / given.size)[0]
    assert gained[0] < gained[2] < gained[1]


def test_what_networks_were_measured_to_know_badly_is_kept_as_it_was_given() -> None:
    error = replace(USUAL_ERROR, scale=((0.03,),), side=((0.01, 0.3, 0.01),))
    memory = SizeMemory.of(pose(0.2), found_error=error)
    for _ in range(300):
        memory = memory.updated(pose(0.21, (0.11, 0.13, 0.11)), SEEN)
    gained = np.log(memory.size / pose().size)[0] / np.log([1.1, 13 / 12, 1.1])
    assert gained[0] == gained[2] > 0.5
    assert gained[1] < 0.01
    guessed = replace(memory, found_error=replace(error, scale=((0.3,),)))
    assert 1 < guessed.scale[0] / 0.2 < 1.002 < memory.scale[0] / 0.2


@pytest.mark.parametrize(("given_error", "share"), [(0.0, 0.0), (1e3, 1.0)])
def test_a_size_may_be_known_or_a_guess(given_error: float, share: float) -> None:
    memory = SizeMemory.of(pose(0.2), given_error).updated(pose(0.3), SEEN)
    assert memory.scale[0] == pytest.approx(0.2 + 0.1 * share, rel=1e-3)


def test_noise_averages_out() -> None:
    rng, memory = np.random.default_rng(0), SizeMemory.of(pose(0.2), 1e3)
    for _ in range(400):
        memory = memory.updated(pose(0.2 * np.exp(0.1 * rng.standard_normal())), SEEN)
    assert memory.scale[0] == pytest.approx(0.2, rel=0.02)


def test_rescaling_keeps_the_points_where_their_coordinates_say() -> None:
    rng = np.random.default_rng(1)
    rotated, centre = rng.uniform(0, 0.5, (50, 3)), np.array([0.1, 0.2, 0.9])
    measured = replace(pose(0.25), translation=centre[None])
    points = 0.25 * rotated + centre
    applied = SizeMemory.of(pose(0.2)).apply(measured, points.mean(axis=0)[None])
    np.testing.assert_allclose(applied.scale, [0.2])
    expected = (points - 0.2 * rotated).mean(axis=0)
    np.testing.assert_allclose(applied.translation[0], expected)


def test_one_overestimated_frame_hardly_moves_a_track_and_a_reset_forgets_it() -> None:
    rng = np.random.default_rng(2)
    category, truth, cloud = scene("camera", rng)
    larger = Pose(truth.rotation, truth.translation, 1.3 * truth.scale, 1.3 * truth.size)
    networks = OracleNetworks(category, larger, truth)
    tracker = Tracker(networks, truth)
    assert 1 < tracker.step(cloud).pose.scale[0] / truth.scale[0] < 1.01
    tracker.reset(truth)
    np.testing.assert_array_equal(tracker.pose.scale, truth.scale)


def test_frames_in_which_a_part_is_hidden_measure_nothing_of_it() -> None:
    """What a hidden part keeps is the remembered size: taken for measured, it would be believed ever more."""
    given, measured = pose(0.2), pose(0.25)
    memory = remembered(given, measured, 20)
    hidden = replace(given, scale=memory.scale, size=memory.size)
    later = memory
    for _ in range(100):
        later = later.updated(hidden, np.zeros(1, bool))
    np.testing.assert_array_equal(later.size, memory.size)
    np.testing.assert_array_equal(later.scale, memory.scale)

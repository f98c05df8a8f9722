from dataclasses import replace

import numpy as np
import pytest

from captra.geometry import Pose
from captra.size_memory import GIVEN_WEIGHT_FRAMES, SizeMemory
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, scene


def pose(scale: float = 0.2, size: tuple[float, float, float] = (0.1, 0.12, 0.1)) -> Pose:
    return Pose(np.eye(3)[None], np.array([[0.0, 0, 1]]), np.array([scale]), np.array([size]))


def test_before_the_first_frame_the_given_size_is_all_there_is() -> None:
    memory = SizeMemory.of(pose())
    np.testing.assert_allclose(np.exp(memory.log_scale), [0.2])
    np.testing.assert_allclose(np.exp(memory.log_size), [[0.1, 0.12, 0.1]])


def test_many_equal_measurements_outweigh_what_was_given() -> None:
    memory = SizeMemory.of(pose(0.2))
    for _ in range(int(GIVEN_WEIGHT_FRAMES)):
        memory = memory.updated(pose(0.3))
    assert np.exp(memory.log_scale[0]) == pytest.approx(np.sqrt(0.2 * 0.3))
    for _ in range(5000):
        memory = memory.updated(pose(0.3))
    assert np.exp(memory.log_scale[0]) == pytest.approx(0.3, rel=0.01)


def test_noise_averages_out() -> None:
    rng, memory = np.random.default_rng(0), SizeMemory.of(pose(0.2))
    for _ in range(400):
        memory = memory.updated(pose(0.2 * np.exp(0.1 * rng.standard_normal())))
    assert np.exp(memory.log_scale[0]) == pytest.approx(0.2, rel=0.02)


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
    assert tracker.step(cloud).pose.scale[0] / truth.scale[0] == pytest.approx(1.3 ** (1 / 26), rel=0.01)
    tracker.reset(truth)
    np.testing.assert_array_equal(tracker.pose.scale, truth.scale)

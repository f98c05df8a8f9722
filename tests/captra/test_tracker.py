from dataclasses import replace

import numpy as np
import pytest

from captra.categories import CATEGORIES
from captra.geometry import Pose, axis_angle
from captra.health import State
from captra.metrics import rotation_error_deg
from captra.pose_memory import NO_ERROR
from captra.recovery import LookBudget
from captra.sampling import NoPointsError
from captra.tracker import Tracker, TrackerOptions
from tests.oracle import OracleNetworks, scene

NOTHING_REMEMBERED = TrackerOptions(given_size_error=1e3, found_error=NO_ERROR)
"""What networks find is taken as it is."""

EVERY = pytest.mark.parametrize("name", CATEGORIES)


def perturbed(truth: Pose, rng: np.random.Generator) -> Pose:
    parts = truth.num_parts
    return Pose.from_size(
        truth.rotation @ axis_angle(rng.standard_normal((parts, 3)), 0.08),
        truth.translation + 0.01 * rng.standard_normal((parts, 3)),
        truth.size * rng.uniform(0.95, 1.05),
    )


@EVERY
def test_one_step_with_perfect_networks_finds_the_pose_of_every_part(name: str) -> None:
    rng = np.random.default_rng(3)
    category, truth, cloud = scene(name, rng)
    start = perturbed(truth, rng)
    tracker = Tracker(OracleNetworks(category, truth, start), start, options=NOTHING_REMEMBERED)
    result = tracker.step(cloud)
    errors = rotation_error_deg(result.pose.rotation, truth.rotation, symmetric=category.symmetric)
    assert errors.max() < 0.1
    np.testing.assert_allclose(result.pose.translation, truth.translation, atol=1e-3)
    np.testing.assert_allclose(result.pose.scale, truth.scale, rtol=1e-2)
    np.testing.assert_allclose(result.pose.size, truth.size, rtol=0.05)
    assert result.state is State.TRACKING
    assert result.confidence > 0.9
    assert tracker.pose is result.pose
    assert [joint.name for joint in result.joints] == [joint.name for joint in category.joints]


@pytest.mark.parametrize("name", ["bottle", "bowl", "can"])
def test_symmetric_object_does_not_spin(name: str) -> None:
    rng = np.random.default_rng(4)
    category, truth, cloud = scene(name, rng)
    tracker = Tracker(OracleNetworks(category, truth, truth), truth)
    result = tracker.step(cloud)
    assert rotation_error_deg(result.pose.rotation, truth.rotation, symmetric=False).max() < 0.1


def test_a_part_without_points_keeps_its_pose() -> None:
    rng = np.random.default_rng(5)
    category, truth, cloud = scene("laptop_articulated", rng)
    start = perturbed(truth, rng)
    display_only = cloud[3000:]
    result = Tracker(OracleNetworks(category, truth, start), start, options=NOTHING_REMEMBERED).step(display_only)
    np.testing.assert_array_equal(result.pose.translation[0], start.translation[0])
    np.testing.assert_array_equal(result.pose.rotation[0], start.rotation[0])
    assert result.evidence.parts[0].points == 0
    assert result.confidence < 0.2
    np.testing.assert_allclose(result.pose.translation[1], truth.translation[1], atol=1e-3)


def test_cloud_without_the_object_is_refused_and_changes_nothing() -> None:
    rng = np.random.default_rng(6)
    category, truth, cloud = scene("mug", rng)
    tracker = Tracker(OracleNetworks(category, truth, truth), truth)
    with pytest.raises(NoPointsError):
        tracker.step(cloud + 5)
    assert tracker.pose is truth


def test_a_given_pose_is_remembered_however_late_the_object_comes() -> None:
    """Before it is in the cloud the track is called lost; what the given pose told is used all the same."""
    category, truth, cloud = scene("mug", np.random.default_rng(6))
    start = replace(truth, translation=truth.translation + 0.004)
    late, at_once = (Tracker(OracleNetworks(category, truth, start), start) for _ in range(2))
    for _ in range(4):
        with pytest.raises(NoPointsError):
            late.step(np.zeros((3, 3), np.float32))
    assert late.health.state is State.LOST
    found, expected = late.step(cloud).pose, at_once.step(cloud).pose
    assert not np.allclose(expected.translation, truth.translation, atol=1e-4), "the given pose tells nothing here"
    np.testing.assert_array_equal(found.translation, expected.translation)
    np.testing.assert_array_equal(found.size, expected.size)


def test_nearly_empty_segmented_cloud_is_refused() -> None:
    rng = np.random.default_rng(7)
    category, truth, cloud = scene("scissors", rng)
    with pytest.raises(NoPointsError, match="segmented"):
        Tracker(OracleNetworks(category, truth, truth), truth).step(cloud[:5])


def test_pose_with_another_number_of_parts_is_refused() -> None:
    category, truth, _ = scene("glasses", np.random.default_rng(8))
    with pytest.raises(ValueError, match="right_temple"):
        Tracker(OracleNetworks(category, truth, truth), truth.part(0))


def test_step_follows_a_moved_cloud() -> None:
    """Equivariance: moving cloud and last pose by one rigid motion moves the answer by it."""
    rng = np.random.default_rng(9)
    category, truth, cloud = scene("camera", rng)
    start = perturbed(truth, rng)
    turn, shift = axis_angle(rng.standard_normal(3), 1.0), rng.standard_normal(3)

    def moved(pose: Pose) -> Pose:
        return Pose(turn @ pose.rotation, pose.translation @ turn.T + shift, pose.scale, pose.size)

    here = Tracker(OracleNetworks(category, truth, start), start).step(cloud).pose
    there_cloud = (cloud @ turn.T + shift).astype(np.float32)
    there = Tracker(OracleNetworks(category, moved(truth), moved(start)), moved(start)).step(there_cloud).pose
    np.testing.assert_allclose(there.rotation, turn @ here.rotation, atol=1e-3)
    np.testing.assert_allclose(there.translation, here.translation @ turn.T + shift, atol=1e-3)


def test_an_object_that_seems_to_explode_stays_where_it_was() -> None:
    rng = np.random.default_rng(10)
    category, truth, cloud = scene("camera", rng)
    start = perturbed(truth, rng)
    exploded = Pose(truth.rotation, truth.translation, 2 * truth.scale, 2 * truth.size)
    result = Tracker(OracleNetworks(category, exploded, start), start).step(cloud)
    np.testing.assert_allclose(result.pose.scale, start.scale)
    np.testing.assert_allclose(result.pose.translation, start.translation)
    np.testing.assert_allclose(result.pose.size, start.size)


def test_networks_that_answer_nonsense_change_nothing_and_are_not_trusted() -> None:
    rng = np.random.default_rng(11)
    category, truth, cloud = scene("mug", rng)

    class Broken(OracleNetworks):
        def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
            segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
            return segmentation, coordinates * np.nan

        def rotations(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
            return super().rotations(points_canonical, neighborhoods) * np.nan

    result = Tracker(Broken(category, truth, truth), truth).step(cloud)
    np.testing.assert_allclose(result.pose.translation, truth.translation)
    np.testing.assert_allclose(result.pose.size, truth.size)
    np.testing.assert_allclose(result.pose.rotation, truth.rotation)
    assert result.confidence < 0.2


def test_a_given_pose_may_be_rough_but_the_next_leap_counts() -> None:
    category, truth, cloud = scene("camera", np.random.default_rng(21))
    start = replace(truth, translation=truth.translation + [0.02, 0.0, 0.0])
    networks = OracleNetworks(category, truth, start)
    tracker = Tracker(networks, start)
    assert tracker.step(cloud).evidence.parts[0].translation_jump == 0
    networks.truth = replace(truth, translation=truth.translation + [0.03, 0.0, 0.0])
    assert tracker.step((cloud + [0.03, 0.0, 0.0]).astype(np.float32)).evidence.parts[0].translation_jump > 0.05
    tracker.reset(tracker.pose)
    assert tracker.step(cloud).evidence.parts[0].translation_jump == 0


class Inside(OracleNetworks):
    """Takes every point for the one that lies opposite."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
        return segmentation, np.flip(coordinates, axis=1).copy()


def lost(name: str, looks: int) -> tuple[Tracker, Pose]:
    """A tracker that saw nonsense for a while, carried 1 cm off its last trusted pose, and what it published then."""
    category, truth, cloud = scene(name, np.random.default_rng(22))
    tracker = Tracker(Inside(category, truth, truth), truth, options=TrackerOptions(search=LookBudget(looks)))
    for _ in range(8):
        tracker.step(cloud)
    tracker.displace(replace(tracker.pose, translation=tracker.pose.translation + [0.01, 0.0, 0.0]))
    published = tracker.step(cloud).pose
    assert tracker.health.state is State.LOST
    return tracker, published


@pytest.mark.parametrize("name", ["camera", "scissors"])
def test_looks_that_do_not_convince_lead_nowhere(name: str) -> None:
    (alone, _), (searching, _) = lost(name, looks=1), lost(name, looks=4)
    np.testing.assert_array_equal(searching.pose.translation, alone.pose.translation)
    np.testing.assert_array_equal(searching.pose.rotation, alone.pose.rotation)


def test_only_an_object_among_others_is_held_where_it_was_trusted_last() -> None:
    tracker, published = lost("scissors", looks=4)
    np.testing.assert_array_equal(published.translation, tracker.pose.translation)
    tracker, held = lost("camera", looks=4)
    assert not np.array_equal(held.translation, tracker.pose.translation)

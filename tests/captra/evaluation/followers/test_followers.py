from dataclasses import replace

import numpy as np
import pytest

from captra.evaluation.followers.icp import OracleIcp
from captra.evaluation.followers.ransac import CoordinatesWithRansac
from captra.evaluation.followers.served import FIXED_SCALE, ONE_LOOK, ROBUSTNESS, Served
from captra.evaluation.model_points import from_shape
from captra.evaluation.scoring import score
from captra.evaluation.sequences import Sequence
from captra.health import State
from captra.tracker import LOOKS_AT_START
from tests.captra.evaluation.test_evaluation import moved, still_recording
from tests.oracle import OracleNetworks


def still(category: str, frames: int = 4) -> tuple[Sequence, OracleNetworks]:
    recording = still_recording(category, frames)
    truth = recording.truth(0)
    return Sequence(recording, ()), OracleNetworks(recording.category, truth, truth)


def test_noise_is_added_to_the_start_or_to_every_last_pose() -> None:
    sequence, networks = still("camera")
    plain = Served()(networks, sequence).poses
    seen: list[np.ndarray] = []

    class Watching(OracleNetworks):
        def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
            seen.append(points_canonical)
            return super().coordinates(points_canonical, neighborhoods)

    for follower in ROBUSTNESS:
        seen.clear()
        track = follower(Watching(networks.category, networks.truth, networks.last), sequence)
        again = follower(networks, sequence)
        np.testing.assert_array_equal(track.poses[-1].translation, again.poses[-1].translation)
        assert not np.allclose(track.poses[0].translation, plain[0].translation, atol=1e-5)
        assert len(track.states) == len(track.poses) == 3
        assert set(track.states) <= set(State)
        assert not np.allclose(seen[0], seen[2], atol=1e-3) or follower.start_noise


def test_twice_the_noise_starts_twice_as_far_away() -> None:
    recording = still_recording("can")
    recording = replace(recording, clouds=tuple(cloud + np.float32(9) for cloud in recording.clouds))
    networks = OracleNetworks(recording.category, recording.truth(0), recording.truth(0))
    once, twice = (
        follower(networks, Sequence(recording, ())).poses[0].translation - recording.init.translation
        for follower in ROBUSTNESS[:2]
    )
    np.testing.assert_allclose(twice, 2 * once)


def test_a_track_that_does_not_hold_is_searched_for_as_the_service_does() -> None:
    sequence, networks = still("camera", frames=12)
    looks: list[int] = []

    class Nonsense(OracleNetworks):
        def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
            looks.append(1)
            segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
            return segmentation, np.flip(coordinates, axis=1).copy()

    counts = []
    for follower in (ONE_LOOK, Served()):
        looks.clear()
        follower(Nonsense(networks.category, networks.truth, networks.last), sequence)
        counts.append(len(looks))
    assert counts[0] == 10 + LOOKS_AT_START
    assert counts[1] > counts[0]


def test_a_fixed_scale_stays_what_it_was() -> None:
    sequence, networks = still("can")
    start = networks.truth
    wrong = replace(start, scale=1.1 * start.scale, size=1.1 * start.size)
    sequence = replace(sequence, recording=replace(sequence.recording, init=wrong))
    networks = replace(networks, last=wrong)
    np.testing.assert_allclose(FIXED_SCALE(networks, sequence).poses[-1].scale, wrong.scale, rtol=1e-6)
    assert Served()(networks, sequence).poses[-1].scale < wrong.scale


@pytest.mark.parametrize("category", ["camera", "can", "scissors"])
def test_exact_coordinates_give_the_exact_pose_by_ransac(category: str) -> None:
    sequence, networks = still(category)
    found = score(sequence.recording, CoordinatesWithRansac()(networks, sequence).poses)
    assert found.rotation_deg[0].max() < 0.5
    assert found.translation_cm[0].max() < 0.3
    assert found.scale_percent[0].max() < 2


@pytest.mark.parametrize("category", ["mug", "scissors"])
def test_icp_follows_a_slow_object_that_it_knows(category: str) -> None:
    from captra.data.sequences import make_sequence
    from captra.data.shapes import make_shape

    shape = make_shape(category, np.random.default_rng(3))
    recording = make_sequence(shape, 0, 4, "hand")
    sequence = Sequence(recording, from_shape(shape))
    networks = OracleNetworks(recording.category, recording.truth(0), recording.truth(0))
    track = OracleIcp(told_points=True)(networks, sequence)
    found = score(recording, track.poses, sequence.model)
    lazy = score(recording, (recording.truth(0),) * 3, sequence.model)
    assert found.translation_cm[-1].max() < 1.0
    assert found.within_ad10.all()
    assert found.translation_cm.mean() < max(lazy.translation_cm.mean(), 0.6)
    np.testing.assert_allclose(track.poses[-1].size, recording.size[None][0], rtol=1e-6)


def test_parts_without_points_stay_where_they_were() -> None:
    sequence, networks = still("scissors")
    truth = networks.truth
    recording = replace(sequence.recording, labels=tuple(labels + np.uint8(9) for labels in sequence.recording.labels))
    model = (np.zeros((10, 3), np.float32),) * 2
    (first, *_) = OracleIcp()(networks, Sequence(recording, model)).poses
    np.testing.assert_allclose(first.translation, truth.translation, atol=1e-6)
    assert moved(truth, 1, 1).num_parts == 2

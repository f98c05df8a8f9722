import numpy as np
import pytest

from captra.confidence import UNCALIBRATED, ConfidenceModel
from captra.geometry import Pose, rotation_angle
from captra.health import HealthMonitor, State
from captra.output_filter import OneEuro
from captra.recovery import FEWEST_LOOKS, MOST_LOOKS, LookBudget, Search, TimeBudget, most_agreed
from captra.sampling import NoPointsError
from captra.tracker import Tracker, TrackerOptions
from tests.oracle import OracleNetworks, scene

HERE = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.full((1, 3), 0.1))
THERE = Pose.from_size(np.eye(3)[None], np.array([[0.3, 0.0, 0.5]]), np.full((1, 3), 0.1))


def test_a_track_that_holds_looks_once_where_it_expects_the_object() -> None:
    assert Search(HERE).hypotheses(THERE, State.TRACKING, 8) == (THERE,)


@pytest.mark.parametrize("state", [State.UNCERTAIN, State.LOST, State.RECOVERING])
@pytest.mark.parametrize("looks", [1, 2, 5])
def test_the_budget_is_kept_and_the_last_trusted_pose_is_among_the_first(state: State, looks: int) -> None:
    around = Search(HERE).hypotheses(THERE, state, looks)
    assert len(around) <= looks
    assert around[0] is THERE
    if looks > 1:
        assert around[1] is HERE


@pytest.mark.parametrize("looks", [1, 2, 8])
def test_a_given_pose_comes_first_and_if_there_is_a_search_all_around_it(looks: int) -> None:
    starts = list(Search(HERE).starts(0.03, looks))
    assert starts[0] is HERE
    assert len(starts) == {1: 1, 2: 9, 8: 15}[looks]
    shifts = np.array([start.translation[0] - HERE.translation[0] for start in starts[1:]]).reshape(-1, 3)
    np.testing.assert_allclose(np.linalg.norm(shifts, axis=1), 0.04)


def test_what_most_starts_lead_to_counts_more_than_what_looks_best_from_one() -> None:
    told = np.array([0.2, 0.66, 0.6, 0.62, 0.5])
    centres_m = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.05, 0], [0, 0.06, 0], [0, 0.05, 0.01]])
    assert most_agreed(told, centres_m, 0.2) == 3
    assert most_agreed(told, centres_m, 0.01) == 1, "none of them agree"
    assert most_agreed(told[:1], centres_m[:1], 0.2) == 0


def test_a_search_goes_round_and_outwards() -> None:
    search, centres = Search(HERE), []
    for _ in range(14):
        centres += [pose.translation[0] for pose in search.hypotheses(HERE, State.LOST, 5)[2:]]
        search = search.updated(THERE, State.LOST, 5)
    assert search.trusted is HERE
    offsets = np.array(centres) - HERE.translation[0]
    assert len(np.unique(offsets.round(6), axis=0)) == 42
    assert 0.05 < np.linalg.norm(offsets, axis=1).min() < np.linalg.norm(offsets, axis=1).max() < 0.15
    assert (np.abs(offsets.mean(axis=0)) < 0.01).all()


def test_a_trusted_pose_ends_the_search() -> None:
    assert Search(HERE, turn=9).updated(THERE, State.TRACKING, 4) == Search(THERE)


def test_a_time_budget_allows_as_many_looks_as_fit() -> None:
    budget = TimeBudget(100.0)
    assert budget.looks() == 2
    budget.spent(24.0)
    assert budget.looks() == 4
    for _ in range(50):
        budget.spent(400.0)
    assert budget.looks() == FEWEST_LOOKS
    for _ in range(100):
        budget.spent(0.1)
    assert budget.looks() == MOST_LOOKS


class Following(OracleNetworks):
    """Sees the object only from nearby: else its answers are noise."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
        if np.linalg.norm(self.last.translation[0] - self.truth.translation[0]) < 0.05:
            return segmentation, coordinates
        noise = np.random.default_rng(0).uniform(-0.5, 0.5, coordinates.shape).astype(np.float32)
        return np.full_like(segmentation, 1 / len(segmentation)), noise


def tracker_of(moved_m: float, looks: int) -> tuple[Tracker, np.ndarray, Pose, Pose]:
    """A track that is lost, of an object that is `moved_m` from where it was."""
    category, start, cloud = scene("camera", np.random.default_rng(12))
    shift = np.array([moved_m, 0.0, 0.0])
    truth = Pose(start.rotation, start.translation + shift, start.scale, start.size)
    networks = Following(category, truth, start)

    monitor = HealthMonitor(state=State.LOST)
    tracker = Tracker(networks, start, monitor, TrackerOptions(search=LookBudget(looks)))
    tracker._health = monitor
    return tracker, (cloud + shift).astype(np.float32), truth, start


def test_an_object_elsewhere_is_found_again_by_searching_and_not_without() -> None:
    tracker, cloud, truth, _ = tracker_of(0.08, looks=5)
    states = [tracker.step(cloud).state for _ in range(14)]
    assert states[-1] is State.TRACKING
    np.testing.assert_allclose(tracker.pose.translation, truth.translation, atol=5e-3)
    assert rotation_angle(tracker.pose.rotation[0].T @ truth.rotation[0]) < 0.02
    patient, cloud, _, _ = tracker_of(0.08, looks=1)
    assert {patient.step(cloud).state for _ in range(14)} == {State.LOST}


class Approaching(OracleNetworks):
    """From nearby it sees the object; from a little farther away only that it is there, and not quite where."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
        away = np.linalg.norm(self.last.translation[0] - self.truth.translation[0])
        vague = 0.0 if away < 0.02 else 0.12 if away < 0.08 else 0.5
        noise = np.random.default_rng(0).uniform(-vague, vague, coordinates.shape)
        return segmentation, np.clip(coordinates + noise, -0.5, 0.5).astype(np.float32)


def approached(
    given_off_m: float, looks: int, doubt_below: float = 0.3, trust_above: float = 0.8
) -> tuple[Tracker, np.ndarray, Pose]:
    """A tracker before its first step, of an object that is `given_off_m` from where it was given."""
    category, truth, cloud = scene("camera", np.random.default_rng(12))
    start = Pose(truth.rotation, truth.translation + [given_off_m, 0, 0], truth.scale, truth.size)
    monitor = HealthMonitor(ConfidenceModel(7.3, UNCALIBRATED), doubt_below, trust_above)
    options = TrackerOptions(search=LookBudget(looks))
    return Tracker(Approaching(category, truth, start), start, monitor, options), cloud, truth


def test_where_a_rough_pose_leads_another_look_is_taken_in_the_same_frame() -> None:
    tracker, cloud, truth = approached(0.07, looks=1)
    assert tracker.step(cloud).state is State.TRACKING
    np.testing.assert_allclose(tracker.pose.translation, truth.translation, atol=5e-3)


def test_a_given_pose_that_leads_nowhere_is_searched_around_at_once() -> None:
    tracker, cloud, truth = approached(0.1, looks=4)
    assert tracker.step(cloud).state is State.TRACKING
    np.testing.assert_allclose(tracker.pose.translation, truth.translation, atol=5e-3)
    alone, cloud, _ = approached(0.1, looks=1)
    assert State.TRACKING not in [alone.step(cloud).state for _ in range(6)]


def test_a_track_that_is_easily_trusted_is_searched_around_all_the_same() -> None:
    tracker, cloud, truth = approached(0.1, looks=4, doubt_below=1e-9, trust_above=1e-8)
    tracker.step(cloud)
    np.testing.assert_allclose(tracker.pose.translation, truth.translation, atol=5e-3)


def test_the_last_trusted_pose_is_published_while_nothing_is_found() -> None:
    tracker, cloud, _, start = tracker_of(0.5, looks=3)
    nothing = cloud - np.array([0.5, 0, 0], np.float32)
    for _ in range(4):
        np.testing.assert_array_equal(tracker.step(nothing).pose.translation, start.translation)


def test_a_given_pose_ends_the_search() -> None:
    tracker, cloud, truth, _ = tracker_of(0.08, looks=3)
    tracker.step(cloud)
    tracker.reset(truth)
    result = tracker.step(cloud)
    assert result.state is State.TRACKING
    np.testing.assert_allclose(result.pose.translation, truth.translation, atol=1e-3)


def test_frames_without_points_are_refused_and_after_a_few_the_track_says_that_it_is_lost() -> None:
    category, truth, cloud = scene("mug", np.random.default_rng(6))
    tracker, states = Tracker(OracleNetworks(category, truth, truth), truth), []
    for _ in range(5):
        with pytest.raises(NoPointsError):
            tracker.step(cloud + np.float32(5))
        states.append(tracker.health.state)
    assert states[0] is State.TRACKING
    assert states[-1] is State.LOST
    assert tracker.pose is truth


def test_the_output_filter_is_never_fed_back() -> None:
    category, truth, cloud = scene("camera", np.random.default_rng(13))
    start = Pose(truth.rotation, truth.translation + 0.01, truth.scale, truth.size)
    plain, smooth = (
        Tracker(OracleNetworks(category, truth, start), start, options=TrackerOptions(output_filter=one))
        for one in (TrackerOptions().output_filter, OneEuro())
    )
    for frame in range(3):
        moved = (cloud + np.float32(0.002 * frame)).astype(np.float32)
        plain.step(moved, time_s=frame / 30)
        published = smooth.step(moved, time_s=frame / 30).pose
        np.testing.assert_array_equal(smooth.pose.translation, plain.pose.translation)
    assert not np.array_equal(published.translation, smooth.pose.translation)

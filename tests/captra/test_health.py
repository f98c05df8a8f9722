import pytest

from captra.belief import Persistence
from captra.confidence import ConfidenceModel
from captra.health import HealthMonitor, State

GOOD, MIDDLING, BAD = 0.95, 0.15, 0.01


def run(monitor: HealthMonitor, *confidences: float) -> list[State]:
    states = []
    for confidence in confidences:
        monitor = monitor.updated(confidence)
        states.append(monitor.state)
    return states


def test_good_frames_are_tracking() -> None:
    assert set(run(HealthMonitor(), *[GOOD] * 10)) == {State.TRACKING}


def test_one_bad_frame_is_doubt_and_a_good_one_ends_it() -> None:
    assert run(HealthMonitor(), BAD, GOOD) == [State.UNCERTAIN, State.TRACKING]


def test_between_the_thresholds_the_state_stays() -> None:
    assert run(HealthMonitor(), MIDDLING, BAD, MIDDLING) == [State.TRACKING, State.UNCERTAIN, State.UNCERTAIN]
    assert run(HealthMonitor(), *[BAD] * 4, MIDDLING)[-1] is State.LOST


def test_lost_within_five_frames_and_back_only_after_patience() -> None:
    states = run(HealthMonitor(), *[BAD] * 6, *[GOOD] * 3)
    assert states[:2] == [State.UNCERTAIN] * 2
    assert states[2:6] == [State.LOST] * 4
    assert states[6:] == [State.RECOVERING] * 2 + [State.TRACKING]


def test_relapse_while_recovering_is_lost_again() -> None:
    assert run(HealthMonitor(), *[BAD] * 4, GOOD, BAD)[-1] is State.LOST


def test_three_frames_without_points_are_lost_but_one_alone_changes_nothing() -> None:
    monitor, states = HealthMonitor(), []
    for _ in range(4):
        monitor = monitor.missed()
        states.append(monitor.state)
    assert states == [State.TRACKING, State.UNCERTAIN, *[State.LOST] * 2]
    assert monitor.confidence == 0
    assert HealthMonitor().missed().updated(GOOD).missed().state is State.TRACKING


def test_frames_without_points_count_with_the_doubt_before_them() -> None:
    monitor = HealthMonitor(belief=Persistence(news=0.25)).updated(1e-6).updated(1e-6)
    assert monitor.state is State.UNCERTAIN
    assert monitor.missed().missed().state is State.LOST


def test_a_given_pose_starts_a_new_track() -> None:
    monitor = HealthMonitor()
    for _ in range(5):
        monitor = monitor.updated(BAD)
    assert monitor.state is State.LOST
    fresh = monitor.restarted()
    assert (fresh.state, fresh.confidence, fresh.streak) == (State.TRACKING, 1.0, 0)


def test_a_manifest_gives_back_the_calibrated_monitor() -> None:
    monitor = HealthMonitor(ConfidenceModel(bias=1.5), doubt_below=0.12, trust_above=0.4, belief=Persistence(0.9))
    assert HealthMonitor.calibrated(monitor.calibration) == monitor


def test_a_manifest_from_before_there_was_a_belief_gives_a_monitor_without_one() -> None:
    older = {name: value for name, value in HealthMonitor().calibration.items() if name != "belief"}
    assert run(HealthMonitor.calibrated(older), BAD, GOOD) == [State.UNCERTAIN, State.TRACKING]


def test_with_a_belief_one_middling_frame_is_no_doubt_and_one_good_one_no_trust() -> None:
    monitor = HealthMonitor(doubt_below=0.2, belief=Persistence())
    assert run(monitor, *[GOOD] * 3, MIDDLING) == [State.TRACKING] * 4
    states = run(monitor, *[BAD] * 6, *[GOOD] * 8)
    assert State.LOST in states[:5]
    assert states[-1] is State.TRACKING


@pytest.mark.parametrize("health", [{}, {"bias": 1.0, "residual": -4.0}])
def test_a_manifest_without_this_calibration_gives_the_defaults(health: dict[str, float]) -> None:
    assert HealthMonitor.calibrated(health) == HealthMonitor()

from dataclasses import replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from captra.health import ConfidenceModel, Evidence, HealthMonitor, PartEvidence, State

GOOD = PartEvidence(
    points=500,
    centroid=np.zeros(3),
    residual=0.02,
    inliers=0.95,
    disagreement_rad=0.03,
    rotation_jump_rad=0.02,
    translation_jump=0.02,
    scale_jump=0.005,
)
BAD = replace(GOOD, residual=0.2, inliers=0.1, disagreement_rad=0.6)


def run(monitor: HealthMonitor, *parts: PartEvidence) -> list[State]:
    states = []
    for part in parts:
        monitor = monitor.updated(Evidence((part,), 0.5))
        states.append(monitor.state)
    return states


def test_good_frames_are_tracking() -> None:
    assert set(run(HealthMonitor(), *[GOOD] * 10)) == {State.TRACKING}


def test_one_bad_frame_is_doubt_and_a_good_one_ends_it() -> None:
    assert run(HealthMonitor(), BAD, GOOD) == [State.UNCERTAIN, State.TRACKING]


def test_lost_within_five_frames_and_back_only_after_patience() -> None:
    states = run(HealthMonitor(), *[BAD] * 6, *[GOOD] * 4)
    assert states[:3] == [State.UNCERTAIN] * 3
    assert states[3:6] == [State.LOST] * 3
    assert states[6:] == [State.RECOVERING] * 3 + [State.TRACKING]


def test_relapse_while_recovering_is_lost_again() -> None:
    assert run(HealthMonitor(), *[BAD] * 4, GOOD, BAD)[-1] is State.LOST


def test_a_given_pose_starts_a_new_track() -> None:
    monitor = HealthMonitor()
    for _ in range(5):
        monitor = monitor.updated(Evidence((BAD,), 0.5))
    assert monitor.state is State.LOST
    fresh = monitor.restarted()
    assert (fresh.state, fresh.confidence, fresh.streak) == (State.TRACKING, 1.0, 0)


def test_the_worst_part_decides() -> None:
    model = ConfidenceModel()
    assert model(Evidence((GOOD, BAD), 0.5)) == model(Evidence((BAD,), 0.5))


def test_a_missing_part_is_never_trusted() -> None:
    assert ConfidenceModel()(Evidence((GOOD, PartEvidence.missing(0, np.zeros(3))), 0.5)) < 0.01


@given(st.floats(0, 1), st.floats(0, 3), st.floats(0, 1))
def test_confidence_falls_with_residual_and_disagreement(residual: float, disagreement: float, more: float) -> None:
    part = replace(GOOD, residual=residual, disagreement_rad=disagreement)
    worse = replace(part, residual=residual + more, disagreement_rad=disagreement + more)
    model = ConfidenceModel()
    assert 0 <= model(Evidence((worse,), 0.5)) <= model(Evidence((part,), 0.5)) <= 1

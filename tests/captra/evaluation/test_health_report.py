from collections.abc import Sequence

import numpy as np
import pytest

from captra.confidence import FEATURES
from captra.evaluation.health_report import Loss, false_alarms, losses, recoveries, summary
from captra.evaluation.incidents import INCIDENTS, LEAD, Incident, make_incident
from captra.evaluation.watching import Watched, watch
from captra.health import State
from captra.tracker import Tracker
from tests.captra.evaluation.test_evaluation import still_recording
from tests.oracle import OracleNetworks

T, U, L, R = State.TRACKING, State.UNCERTAIN, State.LOST, State.RECOVERING


def told(
    states: Sequence[State], error_deg: Sequence[float], start: int, stop: int, kind: str = "occlusion"
) -> Watched:
    """A track with these states and errors; the object is unseen where the error is not a number."""
    rotation = np.array(error_deg, float)
    seen = np.r_[True, np.isfinite(rotation)]
    return Watched(
        incident=Incident("occlusion", still_recording("camera", len(seen)), seen, start, stop),
        states=tuple(states),
        confidence=np.where(np.array(states) == T, 0.9, 0.1),
        rotation_deg=np.nan_to_num(rotation)[:, None],
        translation_cm=np.zeros((len(states), 1)),
        features=np.zeros((len(states), 1, len(FEATURES))),
        looks_ms=np.ones(len(states)),
    )


HIDDEN = float("nan")


def test_a_loss_counts_from_its_first_frame() -> None:
    quick = told([T, T, U, U, U, L, L, L, R, T], [1, 1, *[HIDDEN] * 6, 1, 1], 3, 9)
    never = told([T] * 10, [1, 1, *[90] * 8], 3, 3)
    brief = told([T] * 10, [1, 1, *[HIDDEN] * 4, 1, 1, 1, 1], 3, 7)
    assert losses([quick, never, brief]) == [Loss(4), Loss(None)]


def test_good_frames_called_lost_are_counted_outside_the_search() -> None:
    one = told([T, L, T, *[L] * 6, T, T, L], [1, 1, 1, *[HIDDEN] * 6, 1, 1, 1], 4, 10)
    assert false_alarms([one]) == (2, 5)


def test_recovery_needs_a_right_pose_in_a_track_that_held_before() -> None:
    during = [*[L] * 6], [*[HIDDEN] * 6]
    back = told([T, T, *during[0], *[T] * 8], [1, 1, *during[1], *[1] * 8], 3, 9)
    rough = told([T, T, *during[0], *[T] * 8], [1, 1, *during[1], *[8] * 8], 3, 9)
    wrong = told([T, T, *during[0], *[T] * 8], [1, 1, *during[1], *[40] * 8], 3, 9)
    still_lost = told([T, T, *during[0], *[L] * 8], [1, 1, *during[1], *[1] * 8], 3, 9)
    never_held = told([T, T, *during[0], *[T] * 8], [50, 50, *during[1], *[1] * 8], 3, 9)
    found = recoveries([back, rough, wrong, still_lost, never_held])
    assert [(one.found, one.found_well) for one in found] == [
        (True, True),
        (True, False),
        (False, False),
        (False, False),
    ]


def test_the_summary_holds_every_figure() -> None:
    table = summary("camera", [told([T, T, *[L] * 6, *[T] * 8], [1, 1, *[HIDDEN] * 6, *[1] * 8], 3, 9)])
    assert table.row_count == 8


@pytest.mark.parametrize("kind", INCIDENTS)
def test_an_incident_is_the_same_every_time_and_ends_as_it_should(kind: str) -> None:
    recording = still_recording("mug", 30)
    one, again = (make_incident(kind, recording, 3) for _ in range(2))
    assert [len(cloud) for cloud in one.recording.clouds] == [len(cloud) for cloud in again.recording.clouds]
    assert len(one.seen) == len(one.recording) == len(one.recording.rotation)
    assert one.seen[:LEAD].all()
    assert one.seen[one.stop :].all()
    hides = kind in {"occlusion", "occlusion, moved", "removed", "left view"}
    assert (not one.seen.all()) == hides
    if kind == "drop-out":
        assert max(len(cloud) for cloud in one.recording.clouds[LEAD : one.stop]) < 0.05 * len(recording.clouds[0])
    assert np.diff(one.recording.stamps_ns).min() > 0


def test_a_moved_object_is_where_its_truth_says() -> None:
    recording = still_recording("camera", 30)
    incident = make_incident("teleport", recording, 1)
    truth, cloud = incident.recording.truth(LEAD), incident.recording.clouds[LEAD]
    own = (cloud - truth.translation[0]) @ truth.rotation[0]
    before = (recording.clouds[LEAD] - recording.translation[LEAD, 0]) @ recording.rotation[LEAD, 0]
    np.testing.assert_allclose(own, before, atol=1e-4)
    assert 0.1 <= np.linalg.norm(truth.translation[0] - recording.translation[LEAD, 0]) <= 0.25


def test_short_recordings_are_refused() -> None:
    with pytest.raises(ValueError, match="more than 20"):
        make_incident("gap", still_recording("mug", 12), 0)


def test_perfect_networks_are_watched_to_be_right_until_the_object_is_gone() -> None:
    recording = still_recording("camera", 24)
    truth = recording.truth(0)
    oracle = OracleNetworks(recording.category, truth, truth)
    (one,) = watch(lambda pose: Tracker(oracle, pose), [make_incident("removed", recording, 0)])
    assert one.correct[: LEAD - 1].all()
    assert not one.correct[~one.seen].any()
    assert one.confidence[: LEAD - 1].min() > one.confidence[~one.seen].max()

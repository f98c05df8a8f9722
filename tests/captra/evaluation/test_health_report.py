import collections.abc
import json
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread
from rich.console import Console

from captra.confidence import FEATURES
from captra.evaluation.health_figures import (
    Loss,
    Share,
    by_kind,
    false_alarms,
    figures,
    losses,
    recoveries,
    reliability,
)
from captra.evaluation.health_report import HealthReport, as_json, draw_reliability, markdown, tables
from captra.evaluation.incident_runner import Rehearsal, watch_all
from captra.evaluation.incidents import INCIDENTS, LEAD, make_incident
from captra.evaluation.prediction_rates import EveryNth, Rate, pooled, rates
from captra.evaluation.sequences import Sequence
from captra.evaluation.watching import Watched, watch
from captra.evaluation.workers import Here
from captra.geometry import Pose, rotation_angle
from captra.health import State
from captra.tracker import Tracker
from tests.captra.evaluation.test_evaluation import Held, Ready, still_recording
from tests.oracle import OracleNetworks

T, U, L, R = State.TRACKING, State.UNCERTAIN, State.LOST, State.RECOVERING


def told(
    states: collections.abc.Sequence[State],
    error_deg: collections.abc.Sequence[float],
    start: int,
    stop: int,
    kind: str = "occlusion",
) -> Watched:
    """A track with these states and errors; the object is unseen where the error is not a number."""
    rotation = np.array(error_deg, float)
    seen = np.r_[True, np.isfinite(rotation)]
    return Watched(
        name="camera",
        kind=kind,
        start=start,
        stop=stop,
        seen=seen[1:],
        states=tuple(states),
        confidence=np.where(np.array(states) == T, 0.9, 0.1),
        found=(np.nan_to_num(rotation, nan=90.0) <= 5)[:, None],
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
    wrong = told([*[T] * 9, L], [90] * 10, 3, 3)
    assert losses([quick, never, brief, wrong]) == [Loss(4), Loss(None), Loss(10)]


def test_good_frames_called_lost_are_counted_outside_the_search() -> None:
    one = told([T, L, T, *[L] * 6, T, T, L, R], [1, 1, 1, *[HIDDEN] * 6, 1, 1, 1, 1], 4, 10)
    assert false_alarms([one]) == Share(3, 6)


def test_a_search_that_starts_from_a_wrong_pose_is_no_recovery() -> None:
    assert recoveries([told([*[L] * 6, *[T] * 8], [*[40] * 6, *[1] * 8], 0, 0, "wrong start")]) == []


def test_figures_by_kind_are_those_of_its_incidents() -> None:
    hidden = told([T, T, *[L] * 6, *[T] * 8], [1, 1, *[HIDDEN] * 6, *[1] * 8], 3, 9)
    calm = told([T] * 5, [1] * 5, 6, 6, "nothing")
    found = {one.name: one for one in by_kind([hidden, calm, calm])}
    assert {name: one.incidents for name, one in found.items()} == {"occlusion": 1, "nothing": 2}
    assert found["occlusion"].told_in_time == Share(1, 1)
    assert found["nothing"].right == Share(10, 10)


def test_an_object_out_of_sight_counts_in_one_auroc_and_not_in_the_other() -> None:
    blind = told([T] * 8, [1, 1, 60, 60, *[HIDDEN] * 4], 3, 3)
    blind = replace(blind, confidence=np.array([0.9, 0.9, 0.1, 0.1, *[0.95] * 4]))
    one = figures("camera", [blind])
    assert one.auroc_in_sight == 1
    assert one.auroc == pytest.approx(1 / 3)


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


def test_reliability_holds_every_frame_in_the_bin_of_its_confidence() -> None:
    confidence, correct = np.array([0.02, 0.04, 0.55, 0.95, 1.0]), np.array([False, True, True, True, True])
    low, middle, high = reliability(confidence, correct)
    assert (low.right, middle.right, high.right) == (Share(1, 2), Share(1, 1), Share(2, 2))
    assert [low.confidence, high.confidence] == pytest.approx([0.03, 0.975])


def test_every_form_of_the_report_holds_every_figure(tmp_path: Path) -> None:
    one = told([T, T, *[L] * 6, *[T] * 8], [1, 1, *[HIDDEN] * 6, *[1] * 8], 3, 9)
    found = [figures("camera", [one]), figures("all", [one])]
    assert found[0].auroc == 1
    assert (found[0].told_in_time, found[0].recovered["occlusion"]) == (Share(1, 1), Share(1, 1))
    assert found[0].calibration_error == pytest.approx(0.1)
    report = HealthReport(found, by_kind([one]), [Rate("camera", 10.0, "none", 16, 87.5, 2.25, 0.5)])
    console = Console(record=True, width=200)
    for table in tables(report):
        console.print(table)
    for text in (console.export_text(), markdown(report)):
        for cell in ("AUROC", "≥ 0.95", "1.000", "recovered: occlusion", "≥ 80 %", "100.0 % of 1", "87.5"):
            assert cell in text
    plain = json.loads(json.dumps(as_json(report), allow_nan=False))
    assert plain["health"][0]["recovered"]["occlusion"] == {"part": 1, "whole": 1}
    assert plain["rates"][0]["within_5deg_5cm_percent"] == 87.5
    draw_reliability(found, tmp_path / "reliability.png")
    assert imread(tmp_path / "reliability.png").std() > 0


def test_figures_that_cannot_be_measured_are_null(tmp_path: Path) -> None:
    calm = told([T] * 5, [1] * 5, 6, 6, "nothing")
    (plain,) = as_json(HealthReport([figures("camera", [calm])], []))["health"]
    assert (plain["auroc"], plain["delay_p50_frames"], plain["recovered"]) == (None, None, {})


def test_incidents_can_be_watched_by_other_processes_without_their_clouds() -> None:
    recording = still_recording("camera", 24)
    source, truth = Held(Sequence(recording, ())), recording.truth(0)
    rehearsals = [Rehearsal(source, ("nothing", "removed"), 0)]
    oracle = Ready(OracleNetworks(recording.category, truth, truth))
    ((calm, removed),) = watch_all(oracle, rehearsals, Here(), {}, looks=2)
    assert (calm.kind, removed.kind) == ("nothing", "removed")
    assert calm.correct.all()
    assert len(pickle.dumps(removed)) < recording.clouds[0].nbytes / 3


def test_every_third_frame_is_a_camera_at_a_third_of_the_rate() -> None:
    recording = still_recording("camera", 10)
    thin = EveryNth(Held(Sequence(recording, ())), 3).load().recording
    assert len(thin) == len(thin.labels) == len(thin.rotation) == 4
    assert np.diff(thin.stamps_ns).tolist() == [3 * 33_000_000] * 3


def test_rates_of_several_categories_are_pooled_by_frames() -> None:
    mug, can = Rate("mug", 10.0, "none", 30, 80.0, 2.0, 1.0), Rate("can", 10.0, "none", 10, 40.0, 6.0, 3.0)
    assert list(pooled([mug, can, replace(mug, hertz=30.0), replace(can, prediction="some")])) == [
        Rate("all", 10.0, "none", 40, 70.0, 3.0, 1.5),
        Rate("all", 30.0, "none", 30, 80.0, 2.0, 1.0),
        Rate("all", 10.0, "some", 10, 40.0, 6.0, 3.0),
    ]


def test_rates_are_measured_with_and_without_prediction() -> None:
    recording = still_recording("camera", 7)
    model = (np.random.default_rng(0).uniform(-0.5, 0.5, (200, 3)).astype(np.float32) * recording.size[0],)
    truth = recording.truth(0)
    networks = Ready(OracleNetworks(recording.category, truth, truth))
    found = list(rates("camera", networks, [Held(Sequence(recording, model))], Here()))
    assert [(one.hertz, one.prediction, one.frames) for one in found] == [
        (30, "none", 6),
        (30, "constant velocity", 6),
        (10, "none", 2),
        (10, "constant velocity", 2),
    ]
    assert all(one.within_5deg_5cm_percent == 100 for one in found)


@pytest.mark.parametrize("kind", INCIDENTS)
def test_an_incident_is_the_same_every_time_and_ends_as_it_should(kind: str) -> None:
    recording = still_recording("mug", 30)
    one, again = (make_incident(kind, recording, 3) for _ in range(2))
    assert [len(cloud) for cloud in one.recording.clouds] == [len(cloud) for cloud in again.recording.clouds]
    assert len(one.seen) == len(one.recording) == len(one.recording.rotation)
    assert one.seen[:LEAD].all()
    assert one.seen[one.stop :].all()
    hides = kind in {"occlusion", "occlusion, moved", "removed", "left view", "drop-out"}
    assert (not one.seen.all()) == hides
    if kind == "drop-out":
        assert max(len(cloud) for cloud in one.recording.clouds[LEAD : one.stop]) < 0.05 * len(recording.clouds[0])
    assert np.diff(one.recording.stamps_ns).min() > 0


def test_a_wrong_start_is_off_and_what_is_seen_is_as_it_was() -> None:
    recording = still_recording("camera", 30)
    incident = make_incident("wrong start", recording, 1)
    given, truth = incident.recording.init, recording.truth(0)
    assert 0.02 <= np.linalg.norm(given.translation[0] - truth.translation[0]) <= 0.12
    assert 15 <= np.degrees(rotation_angle(given.rotation[0].T @ truth.rotation[0])) <= 65
    np.testing.assert_array_equal(incident.recording.clouds[3], recording.clouds[3])
    np.testing.assert_array_equal(given.size, recording.init.size)


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


class Elsewhere(Tracker):
    """Publishes a pose 6 cm from where it found the object."""

    def _published(self) -> Pose:
        pose = super()._published()
        return replace(pose, translation=pose.translation + [0.06, 0.0, 0.0])


def test_what_a_look_found_is_told_apart_from_what_is_published() -> None:
    recording = still_recording("camera", 24)
    truth = recording.truth(0)
    oracle = OracleNetworks(recording.category, truth, truth)
    (one,) = watch(lambda pose: Elsewhere(oracle, pose), [make_incident("nothing", recording, 0)])
    assert one.found.all()
    assert not one.correct.any()

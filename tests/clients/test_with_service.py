"""The client against the service itself, with networks that follow the middle of the cloud."""

import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import clients
from captra.geometry import Pose
from clients import Event, Frame, Result, open_session
from clients.cli import track
from tests.clients.sequences import DRIFT_M, FRAMES, drifting_mug, saved, without_a_cloud
from tests.service.support import Running, running


@pytest.fixture
def service() -> Iterator[Running]:
    with running() as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


@pytest.fixture
def url(service: Running) -> str:
    return str(service.http.base_url)


def xs(results: list[Result]) -> list[float]:
    return [result.parts[0].translation[0] for result in results]


@pytest.mark.parametrize("encoding", ["i16", "f32"])
def test_an_object_is_followed_from_cloud_to_cloud(url: str, encoding: str) -> None:
    recording = drifting_mug()
    with open_session("mug", recording.init, url=url, encoding=encoding, frame_id="camera") as session:
        results = list(session.track(recording.clouds))
    assert np.allclose(xs(results), 0.02 + DRIFT_M * np.arange(FRAMES), atol=2e-3)
    assert {result.frame_id for result in results} == {"camera"}
    assert [part.name for part in results[0].parts] == list(recording.category.parts)


def test_stamps_come_back_as_they_were_sent(url: str) -> None:
    recording = drifting_mug()
    stamped = [Frame(cloud, int(stamp)) for cloud, stamp in zip(recording.clouds, recording.stamps_ns, strict=True)]
    with open_session("mug", recording.init, url=url) as session:
        assert [result.stamp_ns for result in session.track(stamped)] == recording.stamps_ns.tolist()


def test_two_sessions_side_by_side_do_not_disturb_each_other(url: str) -> None:
    recording = drifting_mug(40)
    found: dict[float, list[Result]] = {}

    def follow(offset: float) -> None:
        start = recording.init
        init = Pose.from_size(start.rotation, start.translation + [[offset, 0, 0]], start.size)
        clouds = [cloud + np.array([offset, 0, 0], np.float32) for cloud in recording.clouds]
        with open_session("mug", init, url=url) as session:
            found[offset] = list(session.track(clouds))

    threads = [threading.Thread(target=follow, args=(offset,)) for offset in (-0.5, 0.5)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(60)
    for offset, results in found.items():
        assert np.allclose(xs(results), offset + 0.02 + DRIFT_M * np.arange(40), atol=2e-3)
    assert len(found) == 2


def test_a_cloud_without_the_object_is_rejected_and_the_track_goes_on(url: str) -> None:
    recording, events = without_a_cloud(drifting_mug(), 3), list[Event]()
    with open_session("mug", recording.init, url=url) as session:
        results = list(session.track(recording.clouds, on_event=events.append))
    assert [(event.seq, event.reason) for event in events if event.kind == "rejected"] == [(3, "no-points-near-object")]
    assert [result.seq for result in results] == [0, 1, 2, 4, 5, 6, 7]


def test_reset_moves_the_track_to_a_new_place(url: str) -> None:
    recording = drifting_mug()
    start = recording.init
    elsewhere = Pose.from_size(start.rotation, start.translation + [[0, 0.8, 0]], start.size)
    with open_session("mug", start, url=url) as session:
        list(session.track(recording.clouds[:2]))
        session.reset(elsewhere)
        (result,) = session.track([recording.clouds[0] + np.array([0, 0.8, 0], np.float32)])
    assert result.parts[0].translation[1] == pytest.approx(0.8, abs=2e-3)


def test_a_cloud_by_http_gets_the_same_answer(url: str) -> None:
    recording = drifting_mug()
    with open_session("mug", recording.init, url=url) as session:
        result = session.post(recording.clouds[1], stamp_ns=5)
    assert result.stamp_ns == 5
    assert result.parts[0].translation[0] == pytest.approx(0.03, abs=2e-3)


def test_leaving_frees_the_session(service: Running, url: str) -> None:
    with open_session("mug", drifting_mug().init, url=url) as session:
        assert service.session(session.session_id)["session_id"] == session.session_id
    assert service.http.get(f"/v1/sessions/{session.session_id}").status_code == 404


@pytest.mark.parametrize(
    ("category", "pose", "reason"),
    [
        ("unicorn", drifting_mug().init, "unknown-category"),
        ("bottle", drifting_mug().init, "category-without-model"),
        ("laptop_articulated", drifting_mug().init, "wrong-number-of-parts"),
        ("mug", Pose.from_size(2 * np.eye(3)[None], np.zeros((1, 3)), np.ones((1, 3))), "not-a-rotation"),
        ("mug", Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.zeros((1, 3))), "size-not-positive"),
    ],
)
def test_refusals_name_their_reason(url: str, category: str, pose: Pose, reason: str) -> None:
    with pytest.raises(clients.RequestRefusedError) as caught:
        open_session(category, pose, url=url)
    assert caught.value.reason == reason


def test_closing_by_the_service_is_noticed(service: Running, url: str) -> None:
    recording = drifting_mug()

    def camera() -> Iterator[np.ndarray]:
        yield recording.clouds[0]
        service.http.delete(f"/v1/sessions/{session.session_id}")
        yield recording.clouds[1]

    with (
        open_session("mug", recording.init, url=url) as session,
        pytest.raises(clients.SessionClosedError, match="a client closed the session"),
    ):
        list(session.track(camera()))


@pytest.mark.parametrize("as_fast_as_possible", [True, False])
def test_captra_track_plays_a_recording_and_ends_with_the_table(
    url: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], as_fast_as_possible: bool
) -> None:
    track([saved(drifting_mug(), tmp_path)], url=url, as_fast_as_possible=as_fast_as_possible)
    printed = capsys.readouterr().out
    assert "frame    0  tracking" in printed
    for measure in ("frames sent / answered", "rotation error", "translation error", "5°5cm", "IoU", "p50 / p95 / p99"):
        assert measure in printed
    assert "100.0 %" in printed

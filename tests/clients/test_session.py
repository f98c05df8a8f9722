import subprocess
import sys
import threading
import time
from collections.abc import Iterator

import numpy as np
import pytest

import clients
from captra.geometry import Pose
from captra.health import State
from clients import Event, Frame, Result, open_session
from tests.clients.fake_service import FakeService, at_centroid


def cloud(x: float, count: int = 20) -> np.ndarray:
    return np.tile(np.array([[x, 0.2, 0.9]], np.float32), (count, 1))


def test_opening_posts_the_pose_and_what_was_chosen(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url, profile="paper", frame_id="camera") as session:
        assert session.session_id == "s1"
        assert session.category == "mug"
    method, path, body = fake.requests[0]
    assert (method, path) == ("POST", "/v1/sessions")
    assert body == {
        "category": "mug",
        "parts": [
            {
                "rotation": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                "translation": [0.1, 0.2, 0.9],
                "size": [0.12, 0.09, 0.08],
            }
        ],
        "profile": "paper",
        "frame_id": "camera",
    }


def test_leaving_closes_the_session_and_withdraws_the_token(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url):
        assert fake.token_seen.wait(5)
        assert not fake.token_gone.is_set()
    assert fake.closed.is_set()
    assert fake.token_gone.wait(5)


@pytest.mark.parametrize("encoding", ["i16", "f32"])
def test_every_cloud_gets_its_result_in_turn(fake: FakeService, first_pose: Pose, encoding: str) -> None:
    frames = [Frame(cloud(0.01 * i), 1000 + i) for i in range(20)]
    with open_session("mug", first_pose, url=fake.url, encoding=encoding) as session:
        results = list(session.track(frames))
        assert session.latest == results[-1]
    assert [result.seq for result in results] == list(range(20))
    assert [result.stamp_ns for result in results] == list(range(1000, 1020))
    assert np.allclose([r.parts[0].translation[0] for r in results], 0.01 * np.arange(20), atol=1e-4)
    assert all(r.round_trip_ms is not None and r.round_trip_ms > 0 for r in results)
    assert results[0].state is State.TRACKING
    assert results[0].timing_ms.total == 6.6
    assert np.allclose(results[3].pose.translation, [[0.03, 0.2, 0.9]], atol=1e-4)
    assert np.allclose(results[3].parts[0].T_camera_part[:3, 3], [0.03, 0.2, 0.9], atol=1e-4)


def test_numbers_go_on_from_one_track_to_the_next(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        first, second = list(session.track([cloud(0)])), list(session.track([cloud(0)]))
    assert (first[0].seq, second[0].seq) == (0, 1)


def test_a_cloud_without_stamp_carries_the_present_time(fake: FakeService, first_pose: Pose) -> None:
    before = time.time_ns()
    with open_session("mug", first_pose, url=fake.url) as session:
        (result,) = session.track([cloud(0)])
    assert before <= result.stamp_ns <= time.time_ns()


def test_at_a_rate_clouds_keep_their_beat_and_the_last_one_is_answered(fake: FakeService, first_pose: Pose) -> None:
    started = time.perf_counter()
    with open_session("mug", first_pose, url=fake.url) as session:
        results = list(session.track([cloud(0) for _ in range(20)], rate_hz=50))
    assert time.perf_counter() - started >= 19 / 50
    assert results[-1].seq == 19


def test_at_a_rate_the_freshest_cloud_wins(first_pose: Pose) -> None:
    go_on = threading.Event()

    def busy(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        assert go_on.wait(30)
        return at_centroid(service, seq, points)

    def camera() -> Iterator[np.ndarray]:
        for i in range(10):
            yield cloud(0.01 * i)
            fake.wait_for_cloud(i)  # none is dropped on the way, and the last one is there before the first is answered
            fake.wait_until_taken(0)
        go_on.set()

    with FakeService(busy) as fake, open_session("mug", first_pose, url=fake.url) as session:
        results = list(session.track(camera(), rate_hz=1000, timeout_s=30))
    assert [result.seq for result in results] == [0, 9]


def test_results_are_there_before_a_slow_camera_delivers_again(fake: FakeService, first_pose: Pose) -> None:
    answered = threading.Event()

    def camera() -> Iterator[np.ndarray]:
        yield cloud(0)
        assert answered.wait(5), "the first result waited for the second cloud"
        yield cloud(0)

    with open_session("mug", first_pose, url=fake.url) as session:
        for _ in session.track(camera(), rate_hz=1000):
            answered.set()


def test_what_the_source_raises_reaches_the_reader(fake: FakeService, first_pose: Pose) -> None:
    def broken() -> Iterator[np.ndarray]:
        yield cloud(0)
        raise OSError("the camera was unplugged")

    with open_session("mug", first_pose, url=fake.url) as session, pytest.raises(OSError, match="unplugged"):
        list(session.track(broken(), rate_hz=100))


@pytest.mark.parametrize("rate_hz", [None, 100.0])
def test_no_clouds_no_results(fake: FakeService, first_pose: Pose, rate_hz: float | None) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        assert list(session.track([], rate_hz=rate_hz)) == []


def test_breaking_off_stops_the_feeding(fake: FakeService, first_pose: Pose) -> None:
    def endless() -> Iterator[np.ndarray]:
        while True:
            yield cloud(0)

    with open_session("mug", first_pose, url=fake.url) as session:
        for _ in session.track(endless(), rate_hz=200):
            break
        assert all(thread.name != "captra-feeder" for thread in threading.enumerate())


def reject_odd(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
    if seq % 2:
        return {"kind": "rejected", "reason": "no-points-near-object", "detail": "nothing is near the object"}
    return at_centroid(service, seq, points)


@pytest.mark.parametrize(("reason", "first"), [("not-finite", cloud(0)), ("no-points-near-object", None)])
def test_a_rejected_cloud_raises_with_its_reason(first_pose: Pose, reason: str, first: np.ndarray | None) -> None:
    """One that shows nothing, if it is the first: cloud and pose are in different frames, most likely."""

    def reject_small(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        if len(points) < 5:
            return {"kind": "rejected", "reason": reason, "detail": "nothing is near the object"}
        return at_centroid(service, seq, points)

    sent = [cloud(0)[:3]] if first is None else [first, cloud(0)[:3]]
    with FakeService(reject_small) as fake, open_session("mug", first_pose, url=fake.url) as session:
        with pytest.raises(clients.FrameRejectedError, match="nothing is near") as caught:
            list(session.track(sent))
        assert (caught.value.seq, caught.value.reason) == (len(sent) - 1, reason)


@pytest.mark.parametrize("rate_hz", [None, 50.0])
def test_an_object_out_of_sight_for_a_frame_does_not_end_the_track(first_pose: Pose, rate_hz: float | None) -> None:
    with FakeService(reject_odd) as fake, open_session("mug", first_pose, url=fake.url) as session:
        assert [result.seq for result in session.track([cloud(0)] * 5, rate_hz=rate_hz)] == [0, 2, 4]


@pytest.mark.parametrize("rate_hz", [None, 50.0])
def test_what_is_told_late_of_clouds_before_is_no_concern_of_this_track(
    first_pose: Pose, rate_hz: float | None
) -> None:
    def late(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        if seq == 1:
            service.tell({"kind": "rejected", "reason": "no-points-near-object", "detail": "late"}, seq=0, stamp_ns=0)
            service.tell(at_centroid(service, 0, points), seq=0, stamp_ns=0)
        return at_centroid(service, seq, points)

    with FakeService(late) as fake, open_session("mug", first_pose, url=fake.url) as session:
        list(session.track([cloud(0)]))
        assert [result.seq for result in session.track([cloud(0)], rate_hz=rate_hz)] == [1]


@pytest.mark.parametrize("rate_hz", [None, 50.0])
def test_rejections_can_be_taken_note_of_instead(first_pose: Pose, rate_hz: float | None) -> None:
    events: list[Event] = []

    def camera() -> Iterator[np.ndarray]:
        yield cloud(0)
        for seq in range(3):
            if rate_hz is not None:
                fake.wait_until_taken(seq)  # or the next one would replace it on a slow machine
            yield cloud(0)

    with FakeService(reject_odd) as fake, open_session("mug", first_pose, url=fake.url) as session:
        results = list(session.track(camera(), rate_hz=rate_hz, on_event=events.append))
    assert [result.seq for result in results] == [0, 2]
    assert [event.seq for event in events] == [1, 3]


def test_a_cloud_refused_unread_has_no_number_and_is_an_answer_all_the_same(first_pose: Pose) -> None:
    def refuse(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        return {"kind": "rejected", "seq": None, "reason": "payload-too-large", "detail": "too large"}

    events: list[Event] = []
    with FakeService(refuse) as fake, open_session("mug", first_pose, url=fake.url) as session:
        assert list(session.track([cloud(0)] * 2, on_event=events.append)) == []
    assert [event.reason for event in events] == ["payload-too-large"] * 2


def test_changes_of_state_do_not_end_the_wait_for_a_result(first_pose: Pose) -> None:
    def doubtful(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        service.tell({"kind": "state", "state": "uncertain"}, seq=seq, stamp_ns=0)
        return at_centroid(service, seq, points) | {"state": "uncertain"}

    with FakeService(doubtful) as fake, open_session("mug", first_pose, url=fake.url) as session:
        (result,) = session.track([cloud(0)])
    assert result.state is State.UNCERTAIN


def test_closing_by_the_service_ends_the_track(first_pose: Pose) -> None:
    def close(service: FakeService, seq: int, points: np.ndarray) -> dict[str, object]:
        return {"kind": "closing", "reason": "shutdown", "detail": "the service stops"}

    with (
        FakeService(close) as fake,
        open_session("mug", first_pose, url=fake.url) as session,
        pytest.raises(clients.SessionClosedError, match="the service stops"),
    ):
        list(session.track([cloud(0)]))


@pytest.mark.parametrize("rate_hz", [None, 100.0])
def test_silence_is_an_error(first_pose: Pose, rate_hz: float | None) -> None:
    with (
        FakeService(lambda service, seq, points: None) as fake,
        open_session("mug", first_pose, url=fake.url) as session,
        pytest.raises(clients.NoResultError, match=r"frame 0.* within 0.2 s"),
    ):
        list(session.track([cloud(0)], rate_hz=rate_hz, timeout_s=0.2))


def test_put_and_receive_are_the_parts_of_track(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        seq = session.put(cloud(0.3), stamp_ns=5)
        message = session.receive()
        assert isinstance(message, Result)
        assert (message.seq, message.stamp_ns) == (seq, 5)
        with pytest.raises(clients.NoResultError, match="s1"):
            session.receive(timeout_s=0.05)


def test_post_goes_by_http(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        result = session.post(cloud(0.3), stamp_ns=7)
    assert result.parts[0].translation[0] == pytest.approx(0.3)
    assert any(path == "/v1/sessions/s1/frames?seq=0&stamp_ns=7" for _, path, _ in fake.requests)


def test_reset_puts_the_new_pose(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        session.reset(first_pose)
    _, path, body = next(request for request in fake.requests if request[0] == "PUT")
    assert path == "/v1/sessions/s1/pose"
    assert body["parts"][0]["translation"] == [0.1, 0.2, 0.9]


def test_a_refusal_carries_its_reason(fake: FakeService, first_pose: Pose) -> None:
    with pytest.raises(clients.RequestRefusedError, match="use one of mug, bottle") as caught:
        open_session("unicorn", first_pose, url=fake.url)
    assert (caught.value.status, caught.value.reason) == (422, "unknown-category")


def test_no_service_says_how_to_start_one(first_pose: Pose) -> None:
    with pytest.raises(clients.ServiceUnreachableError, match="captra serve"):
        open_session("mug", first_pose, url="http://127.0.0.1:9")


def test_the_address_can_come_from_the_environment(
    fake: FakeService, first_pose: Pose, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAPTRA_URL", fake.url)
    with open_session("mug", first_pose) as session:
        assert session.session_id == "s1"


def test_a_service_that_died_does_not_keep_its_client_from_leaving(first_pose: Pose) -> None:
    with FakeService() as fake:
        session = open_session("mug", first_pose, url=fake.url)
    session.close()


def test_closing_twice_does_no_harm(fake: FakeService, first_pose: Pose) -> None:
    with open_session("mug", first_pose, url=fake.url) as session:
        session.close()
    assert sum(method == "DELETE" for method, _, _ in fake.requests) == 1


FORGETFUL = """
import sys
import numpy as np
from captra.geometry import Pose
from clients import open_session
session = open_session("mug", Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.ones((1, 3))), url=sys.argv[1])
next(session.track([np.ones((5, 3))]))
raise SystemExit(3)
"""


def test_a_program_that_forgets_to_close_ends_all_the_same_and_frees_its_session(fake: FakeService) -> None:
    ended = subprocess.run([sys.executable, "-c", FORGETFUL, fake.url], timeout=30, check=False)
    assert ended.returncode == 3
    assert fake.closed.is_set()


def test_a_session_whose_stream_cannot_be_opened_is_closed_again(fake: FakeService, first_pose: Pose) -> None:
    fake.endpoint = "tcp/127.0.0.1:9"
    with pytest.raises(clients.ServiceUnreachableError, match="CAPTRA_ZENOH_LISTEN"):
        open_session("mug", first_pose, url=fake.url, timeout_s=0.3)
    assert fake.closed.is_set()

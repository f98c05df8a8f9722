"""kill -9 in mid-stream: the next process goes on with every session, and clients notice nothing but a gap."""

import itertools
import json
import logging
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import httpx
import numpy as np
import pytest

from captra.geometry import Pose
from clients import Camera, Frame, Session, Smoothing, open_session
from clients.results import Result
from clients.service_process import free_ports
from tests.service.support import Running, blob, f32, running, session_body
from tests.service.test_process import entry, process, stream

GRACE_S = 2.0
OPTIONS = ("camera", "masks", "prediction", "smoothing", "joint_axes")
STARTS = [(0.3 * index, 0.0, 0.5) for index in range(3)]


@pytest.fixture
def service() -> Iterator[Running]:
    with running("mug", client_grace_s=GRACE_S) as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


def pose_at(start: tuple[float, float, float]) -> Pose:
    return Pose.from_size(np.eye(3)[None], np.array([start]), np.full((1, 3), 0.1))


def variables_of(state_dir: Path, **more: str) -> dict[str, str]:
    http_port, zenoh_port = free_ports(2)
    return {
        "CAPTRA_HTTP_PORT": str(http_port),
        "CAPTRA_ZENOH_LISTEN": json.dumps([f"tcp/127.0.0.1:{zenoh_port}"]),
        "CAPTRA_STATE_DIR": str(state_dir),
    } | more


def next_result(session: Session, after_seq: int) -> Result:
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        if session.latest is not None and session.latest.seq > after_seq:
            return session.latest
        time.sleep(0.01)
    raise AssertionError(f"session {session.session_id} did not go on")


def test_killed_service_goes_on_with_every_session_and_its_clients(tmp_path: Path) -> None:
    variables = variables_of(tmp_path)
    url = f"http://127.0.0.1:{variables['CAPTRA_HTTP_PORT']}"
    stop, reached = threading.Event(), [0.0]
    with ExitStack() as resources:
        service = resources.enter_context(process("-m", "tests.service.quick_service", **variables))
        entry(stream(service.stderr), "ready")
        sessions = [resources.enter_context(open_session("mug", pose_at(start), url=url)) for start in STARTS]

        def feed() -> None:
            while not stop.wait(0.02):
                reached[0] = min(reached[0] + 0.001, 0.2)
                for session, start in zip(sessions, STARTS, strict=True):
                    session.put(blob((start[0], reached[0], start[2])))

        feeder = threading.Thread(target=feed)
        feeder.start()
        resources.callback(feeder.join)
        resources.callback(stop.set)
        while reached[0] < 0.05:
            time.sleep(0.01)
        before = [next_result(session, 5) for session in sessions]
        listed = httpx.get(f"{url}/v1/sessions").json()["sessions"]
        service.kill()  # SIGKILL
        service.wait()
        again = resources.enter_context(process("-m", "tests.service.quick_service", **variables))
        entry(stream(again.stderr), "ready")
        shown = {each["session_id"]: each for each in httpx.get(f"{url}/v1/sessions").json()["sessions"]}
        assert set(shown) == {each["session_id"] for each in listed}
        for each in listed:
            assert shown[each["session_id"]]["zenoh"] == each["zenoh"]
        last_put = before[0].seq + 20
        for session, start in zip(sessions, STARTS, strict=True):
            result = next_result(session, last_put)
            assert result.session_id == session.session_id
            assert result.parts[0].translation[0] == pytest.approx(start[0], abs=0.01)
            assert result.parts[0].translation[1] > 0.05


def test_options_that_the_client_asked_for_outlive_a_killed_service(tmp_path: Path) -> None:
    variables = variables_of(tmp_path)
    url = f"http://127.0.0.1:{variables['CAPTRA_HTTP_PORT']}"
    kept = ("profile", "frame_id", "idle_timeout_s", "record", *OPTIONS)
    with ExitStack() as resources:
        service = resources.enter_context(process("-m", "tests.service.quick_service", **variables))
        entry(stream(service.stderr), "ready")
        session = resources.enter_context(
            open_session(
                "mug",
                pose_at(STARTS[0]),
                url=url,
                profile="realtime",
                frame_id="wrist",
                idle_timeout_s=77,
                camera=Camera(60, 61, 31.5, 23.5, 64, 48, metres_per_unit=0.0005),
                masks="object",
                prediction="none",
                smoothing=Smoothing(cutoff_hz=0.25, rotation_gain=3),
                joint_axes={},
                record_in_service=True,
            )
        )
        list(session.track([blob()]))
        before = httpx.get(f"{url}/v1/sessions/{session.session_id}").json()
        assert {name: before[name] for name in ("frame_id", "idle_timeout_s", "record", *OPTIONS)} == {
            "frame_id": "wrist", "idle_timeout_s": 77, "record": True,
            "camera": {
                "fx": 60, "fy": 61, "cx": 31.5, "cy": 23.5, "width": 64, "height": 48, "metres_per_unit": 0.0005,
                "distortion": [],
            },
            "masks": "object", "prediction": "none", "joint_axes": {},
            "smoothing": {"cutoff_hz": 0.25, "translation_gain": 10, "rotation_gain": 3},
        }  # fmt: skip
        service.kill()  # SIGKILL
        service.wait()
        again = resources.enter_context(process("-m", "tests.service.quick_service", **variables))
        entry(stream(again.stderr), "ready")
        after = httpx.get(f"{url}/v1/sessions/{session.session_id}").json()
        assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
        jitter = [session_result.parts[0].translation[0] for session_result in fed(session)]
        assert np.ptp(jitter[8:]) < 0.004, "the next process smooths as the first one was asked to"


def goes_on(session: Session) -> Result:
    """The first result of a camera that keeps delivering; any one cloud may be lost, the more so around a restart."""
    for result in session.track(itertools.repeat(blob()), rate_hz=20, timeout_s=20):
        return result
    raise AssertionError("a camera that keeps delivering ends with a result or an error")


def fed(session: Session) -> list[Result]:
    """Results of an object that trembles by 8 mm, once the client is connected again."""
    goes_on(session)
    trembling = [blob((0.004 * (-1) ** i, 0, 0.5)) for i in range(20)]
    return list(session.track([Frame(cloud, 33_000_000 * (i + 1)) for i, cloud in enumerate(trembling)]))


CLIENT = """
import sys, numpy as np
from captra.geometry import Pose
from clients import open_session
pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
session = open_session("mug", pose, url=sys.argv[1])
print(session.session_id, flush=True)
input()
"""


def test_session_of_a_killed_client_is_freed_after_the_grace_time_and_not_before(
    service: Running, caplog: pytest.LogCaptureFixture
) -> None:
    def said(message: str) -> logging.LogRecord:
        deadline = time.monotonic() + 20
        while not (found := [record for record in caplog.records if record.message == message]):
            assert time.monotonic() < deadline, f"the log never said {message!r}"
            time.sleep(0.01)
        return found[0]

    caplog.set_level("INFO")
    with process("-c", CLIENT, str(service.http.base_url)) as client:
        session_id = stream(client.stdout).readline().strip()
        client.kill()
    gone = said("client token gone")
    assert service.http.get(f"/v1/sessions/{session_id}").status_code == 200
    closed = said("session closed")
    assert closed.__dict__["session_id"] == session_id
    assert closed.__dict__["reason"] == "client-gone"
    assert closed.created - gone.created >= GRACE_S - 0.1
    assert service.http.get(f"/v1/sessions/{session_id}").status_code == 404


def test_session_whose_client_died_with_the_service_is_freed_after_the_grace_time(tmp_path: Path) -> None:
    variables = variables_of(tmp_path, CAPTRA_CLIENT_GRACE_S="0.5")
    url = f"http://127.0.0.1:{variables['CAPTRA_HTTP_PORT']}"
    with process("-m", "tests.service.quick_service", **variables) as service:
        entry(stream(service.stderr), "ready")
        kept = httpx.post(f"{url}/v1/sessions", json=session_body()).json()["session_id"]  # it never had a client
        with process("-c", CLIENT, url) as dying:
            orphan = stream(dying.stdout).readline().strip()
            assert entry(stream(service.stderr), "client remembered")["session_id"] == orphan
            service.kill()
            service.wait()
    with process("-m", "tests.service.quick_service", **variables) as again:
        closed = entry(stream(again.stderr), "session closed")
        assert (closed["session_id"], closed["reason"]) == (orphan, "client-gone")
        frame = f"{url}/v1/sessions/{kept}/frames?seq=0&stamp_ns=0"
        headers = {"Content-Type": "application/vnd.captra.cloud.f32"}
        assert httpx.post(frame, content=f32(blob()), headers=headers).status_code == 200

"""SIGTERM in mid-frame: probes hear of it at once, the frame is finished, its pose is stored, and nothing hangs."""

import json
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from subprocess import Popen
from typing import Any

import httpx
import pytest
import zenoh

from captra.tracker import LOOKS_AT_START
from service.settings import Settings
from service.shutdown import FORCE_AFTER_S, STORE_WITHIN_S
from service.sqlite_store import SqliteSessionStore
from service.store import TrustedPose
from tests.service.support import F32, Camera, blob, f32, free_endpoint, inbox, session_body, zenoh_client
from tests.service.test_process import entry, process, stream


@dataclass
class Slow:
    process: Popen[str]
    http: httpx.Client
    network: zenoh.Session
    state_dir: Path

    def open_session(self, category: str = "mug") -> dict[str, Any]:
        opened: dict[str, Any] = self.http.post("/v1/sessions", json=session_body(category)).json()
        return opened

    def wait_until_asked(self) -> None:
        assert stream(self.process.stdout).readline() == "asked\n"

    def wait_until_not_ready(self) -> httpx.Response:
        """The readiness probe's first answer after the signal has reached the process."""
        deadline = time.monotonic() + 20
        while (answer := self.http.get("/v1/health/ready")).status_code == 200:
            assert time.monotonic() < deadline, "the probe never heard of the end"
            time.sleep(0.02)
        return answer

    def finish_frames(self) -> None:
        """Let the frame in hand come to its end."""
        (self.state_dir / "gate").touch()

    def trusted(self, session_id: str) -> TrustedPose:
        """What the store holds of a session after the process is gone."""
        store = SqliteSessionStore(self.state_dir / "default.sqlite")
        (found,) = (record.trusted for record in store.load() if record.session_id == session_id)
        store.close()
        return found


@contextmanager
def slow_service(state_dir: Path, **variables: str) -> Iterator[Slow]:
    endpoint = free_endpoint()
    variables |= {
        "CAPTRA_HTTP_PORT": "0",
        "CAPTRA_ZENOH_LISTEN": json.dumps([endpoint]),
        "CAPTRA_STATE_DIR": str(state_dir),
    }
    with process("-m", "tests.service.slow_service", **variables) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        entry(stream(service.stderr), "ready")
        with httpx.Client(base_url=url, timeout=60) as http, zenoh_client(endpoint) as network:
            yield Slow(service, http, network, state_dir)


@pytest.fixture
def service(tmp_path: Path) -> Iterator[Slow]:
    with slow_service(tmp_path, FRAME_S="0", GATE=str(tmp_path / "gate"), CAPTRA_SHUTDOWN_TIMEOUT_S="60") as started:
        yield started


def test_probes_hear_of_the_end_while_the_frame_in_hand_is_finished_and_stored(service: Slow) -> None:
    opened = service.open_session()
    poses = inbox(service.network, opened["zenoh"]["pose"])
    Camera(service.network, opened["zenoh"]["cloud"]).put(f32(blob((0.02, 0, 0.5))), 7)
    service.wait_until_asked()
    service.process.send_signal(signal.SIGTERM)
    answer = service.wait_until_not_ready()
    assert (answer.status_code, answer.json()["reason"]) == (503, "not-ready")
    assert service.http.get("/v1/health/live").status_code == 200
    refused = service.http.post("/v1/sessions", json=session_body())
    assert (refused.status_code, refused.json()["reason"]) == (503, "not-ready")
    assert len(poses) == 0  # the frame is in hand
    service.finish_frames()
    assert poses.message(0)["seq"] == 7
    assert service.process.wait(20) == 0
    trusted = service.trusted(opened["session_id"])
    assert trusted.seq == 7
    assert trusted.pose.translation[0] == pytest.approx([0.02, 0, 0.5], abs=2e-3)


def test_probes_hear_of_the_end_while_a_frame_by_http_is_finished(service: Slow) -> None:
    session_id = service.open_session()["session_id"]
    with ThreadPoolExecutor(1) as pool:
        answer = pool.submit(post_frame, service, session_id, 3)
        service.wait_until_asked()
        service.process.send_signal(signal.SIGTERM)
        assert service.wait_until_not_ready().status_code == 503
        assert not answer.done()
        service.finish_frames()
        assert answer.result().json()["seq"] == 3
    assert service.process.wait(20) == 0
    assert service.trusted(session_id).seq == 3


@pytest.mark.parametrize("by_http", [False, True])
def test_a_frame_that_hangs_holds_nobody_up(tmp_path: Path, by_http: bool) -> None:
    with slow_service(tmp_path, FRAME_S="0", CAPTRA_SHUTDOWN_TIMEOUT_S="0.5") as service:
        hangs, neighbour = service.open_session("laptop"), service.open_session()
        post_frame(service, neighbour["session_id"], 5).raise_for_status()
        for _ in range(LOOKS_AT_START):
            service.wait_until_asked()
        events = inbox(service.network, neighbour["zenoh"]["event"])
        if by_http:
            threading.Thread(target=post_frame, args=(service, hangs["session_id"], 1), daemon=True).start()
        else:
            Camera(service.network, hangs["zenoh"]["cloud"]).put(f32(blob()), 1)
        service.wait_until_asked()
        service.process.send_signal(signal.SIGTERM)
        left = entry(stream(service.process.stderr), "session left behind in mid-frame")
        assert left["session_id"] == hangs["session_id"]
        if not by_http:  # an answer that is owed by HTTP keeps the server from getting to that
            assert events.wait_for("closing")["reason"] == "shutdown"
        assert service.process.wait(20) == 0
        assert service.trusted(neighbour["session_id"]).seq == 5
        assert service.trusted(hangs["session_id"]).seq is None


def test_nobody_has_to_wait_longer_than_five_seconds_by_default() -> None:
    assert Settings().shutdown_timeout_s + FORCE_AFTER_S + STORE_WITHIN_S < 5


def post_frame(service: Slow, session_id: str, seq: int) -> httpx.Response:
    url, frame = f"/v1/sessions/{session_id}/frames", f32(blob())
    with suppress(httpx.TransportError):  # a service that ends by force owes no answer
        return service.http.post(url, params={"seq": seq, "stamp_ns": 0}, content=frame, headers={"Content-Type": F32})
    return httpx.Response(503, request=httpx.Request("POST", url))

"""The websocket of the live page, without a browser."""

import itertools
import json
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
import zenoh
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

from service.envelopes import pack_attachment
from service.observer import Observer
from service.viewer.clouds import MOST_POINTS
from service.viewer.socket import Viewer
from tests.service.support import F32, STAMP_NS, Running, f32, wait_until
from tests.service.viewer.looking import scene


def stream_of(service: Running) -> str:
    return str(service.http.base_url).replace("http", "ws") + "/viewer/stream"


@pytest.fixture
def viewer(service: Running) -> Iterator[ClientConnection]:
    with connect(stream_of(service), max_size=None) as connected:
        yield connected


def message(viewer: ClientConnection, kind: str) -> dict[str, Any]:
    """The next message of a kind, with the points of a cloud."""
    while True:
        received = viewer.recv(10)
        if isinstance(received, str):
            body: dict[str, Any] = json.loads(received)
        else:
            (length,) = struct.unpack_from("<I", received)
            body = json.loads(received[4 : 4 + length])
            quantized = np.frombuffer(received, "<u2", offset=4 + length).reshape(-1, 3)
            body["points"] = np.array(body["origin"]) + quantized * body["step"]
        if body["type"] == kind:
            return body


def test_the_overview_tells_of_every_session(viewer: ClientConnection, service: Running) -> None:
    assert message(viewer, "overview")["sessions"] == []
    session_id = service.open_session()["session_id"]
    service.post_frame(session_id, f32(scene()), seq=7)
    while not (sessions := message(viewer, "overview")["sessions"]):
        pass
    while sessions[0]["seq"] != 7:
        sessions = message(viewer, "overview")["sessions"]
    assert sessions[0]["session_id"] == session_id
    assert sessions[0]["state"] == "tracking"
    assert sessions[0]["processed"] == 1


def test_a_watched_session_shows_clouds_with_the_result_they_led_to(viewer: ClientConnection, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    viewer.send(json.dumps({"type": "watch", "session": session_id}))
    assert message(viewer, "result")["result"]["seq"] is None
    points = scene()
    answer = service.post_frame(session_id, f32(points), seq=3).json()
    shown = message(viewer, "cloud")
    assert shown["scene"] == f"session/{session_id}"
    assert shown["result"] == answer
    np.testing.assert_allclose(shown["points"], points, atol=1e-5)


def test_large_clouds_are_thinned(viewer: ClientConnection, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    viewer.send(json.dumps({"type": "watch", "session": session_id}))
    message(viewer, "result")
    service.post_frame(session_id, f32(scene(3 * MOST_POINTS)), seq=1)
    shown = message(viewer, "cloud")
    assert shown["of"] == 3 * MOST_POINTS + 300
    assert len(shown["points"]) == shown["count"] == MOST_POINTS


def test_who_looks_elsewhere_hears_no_more(viewer: ClientConnection, service: Running) -> None:
    first, second = (service.open_session()["session_id"] for _ in range(2))
    for session_id in (first, second):
        viewer.send(json.dumps({"type": "watch", "session": session_id}))
        assert message(viewer, "result")["result"]["session_id"] == session_id
    service.post_frame(first, f32(scene()), seq=1)
    service.post_frame(second, f32(scene()), seq=2)
    assert message(viewer, "cloud")["scene"] == f"session/{second}"
    assert message(viewer, "overview")


@pytest.mark.parametrize(
    ("wish", "detail"),
    [
        ('{"type": "watch", "session": "0000"}', "0000"),
        ('{"type": "feed", "session": "0000", "preview": "wrist"}', "0000"),
        ('{"type": "feed", "session": "0000", "preview": "wrist", "secret": "xyz"}', "secret"),
        ('{"type": "dance"}', "dance"),
        ("not JSON", "JSON"),
        (b"not text", "JSON"),
    ],
)
def test_wishes_that_cannot_be_heeded_are_refused_with_the_reason(
    viewer: ClientConnection, wish: str | bytes, detail: str
) -> None:
    viewer.send(wish)
    assert detail in message(viewer, "refused")["detail"]
    assert message(viewer, "overview")


def test_pages_of_other_hosts_are_sent_away(service: Running) -> None:
    with connect(stream_of(service), origin=Origin("http://elsewhere.example")) as viewer:
        with pytest.raises(ConnectionClosed) as closed:
            viewer.recv(10)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 4403


def test_a_viewer_that_left_leaves_nothing_behind(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    session = service.service.registry.get(session_id)
    before = observers_of(session)
    with connect(stream_of(service)) as viewer:
        viewer.send(json.dumps({"type": "watch", "session": session_id}))
        message(viewer, "result")
        wait_until(lambda: observers_of(session) == before + 1)
    wait_until(lambda: observers_of(session) == before)


def test_a_viewer_that_left_while_its_wish_waited_for_a_frame_leaves_nothing_behind(
    service: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    session_id, networks = service.open_session()["session_id"], service.provider.networks["mug"]
    session = service.service.registry.get(session_id)
    before, show, observe = observers_of(session), Viewer.show, session.observe
    noticed, observed = threading.Event(), threading.Event()

    async def show_until_it_leaves(viewer: Viewer) -> None:
        try:
            await show(viewer)
        finally:
            noticed.set()

    def observe_and_tell(observer: Observer) -> None:
        observe(observer)
        observed.set()

    monkeypatch.setattr(Viewer, "show", show_until_it_leaves)
    monkeypatch.setattr(session, "observe", observe_and_tell)
    networks.asked.clear()
    networks.gate.clear()
    with ThreadPoolExecutor(1) as pool:
        frame = pool.submit(service.post_frame, session_id, f32(scene()), seq=1)
        try:
            assert networks.asked.wait(10)
            with connect(stream_of(service)) as viewer:
                viewer.send(json.dumps({"type": "watch", "session": session_id}))
                message(viewer, "result")  # what comes next waits for the frame in hand
            assert noticed.wait(10)
            for _ in range(5):
                service.http.get("/v1/health/live")  # meanwhile the service does all it does when a viewer leaves
        finally:
            networks.gate.set()
        assert frame.result(10).status_code == 200
    assert observed.wait(10)
    wait_until(lambda: observers_of(session) == before)


def test_clouds_of_a_preview_are_taken_until_the_session_that_they_feed_is_closed(
    service: Running, network: zenoh.Session
) -> None:
    session_id = service.open_session()["session_id"]
    publisher = network.declare_publisher("captra/default/previews/wrist", encoding=F32)
    matched, unmatched = threading.Event(), threading.Event()
    publisher.declare_matching_listener(lambda status: (matched if status.matching else unmatched).set())
    seqs = itertools.count()

    def put_until(done: Callable[[], bool]) -> None:
        deadline_s = time.monotonic() + 10
        while not done() and time.monotonic() < deadline_s:
            publisher.put(f32(scene()), attachment=pack_attachment(next(seqs), STAMP_NS))
            time.sleep(0.02)
        assert done()

    def processed() -> int:
        counters: dict[str, int] = service.session(session_id)["counters"]
        return counters["processed"]

    with connect(stream_of(service)) as viewer:
        assert matched.wait(10)
        viewer.send(json.dumps({"type": "feed", "preview": "wrist", "session": session_id}))
        put_until(lambda: processed() > 0)
    seen = processed()
    put_until(lambda: processed() > seen)
    assert not unmatched.is_set()
    service.http.delete(f"/v1/sessions/{session_id}")
    assert unmatched.wait(10)


def test_a_session_is_fed_one_preview_once(service: Running, viewer: ClientConnection, network: zenoh.Session) -> None:
    session_id = service.open_session()["session_id"]
    keys = ["captra/default/previews/left", "captra/default/previews/right"]
    previews = [network.declare_publisher(key, encoding=F32) for key in keys]
    session, wishes = service.service.registry.get(session_id), ("left", "right", "right")
    before = observers_of(session)
    for wished in wishes:
        viewer.send(json.dumps({"type": "feed", "preview": wished, "session": session_id}))
    wait_until(lambda: observers_of(session) == before + len(wishes), "not all wishes were heard")

    def counters() -> dict[str, int]:
        told: dict[str, int] = service.session(session_id)["counters"]
        return told

    for seq in range(100):
        for publisher in previews:
            publisher.put(f32(scene()), attachment=pack_attachment(seq, STAMP_NS))
        time.sleep(0.02)
        if counters()["processed"] >= 5:
            break
    assert counters()["processed"] >= 5
    assert counters()["rejected"] == 0


def test_a_viewer_that_reads_slowly_holds_nothing_up_and_sees_the_newest(service: Running) -> None:
    session_id, frames = service.open_session()["session_id"], 30
    address = service.http.base_url
    with socket.socket() as narrow:
        narrow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        narrow.connect((address.host, address.port))
        with connect(stream_of(service), sock=narrow, max_size=None, max_queue=1) as viewer:
            viewer.send(json.dumps({"type": "watch", "session": session_id}))
            message(viewer, "result")
            large = f32(scene(MOST_POINTS))
            for seq in range(frames):  # nothing is read meanwhile
                assert service.post_frame(session_id, large, seq=seq).status_code == 200
                time.sleep(0.05)
            seen = [message(viewer, "cloud")["result"]["seq"]]
            while seen[-1] < frames - 1:
                seen.append(message(viewer, "cloud")["result"]["seq"])
    assert seen == sorted(seen)
    assert len(seen) < frames, "every cloud waited for the viewer"
    assert service.session(session_id)["counters"]["processed"] == frames


def observers_of(session: Any) -> int:
    return len(session._observers._all)

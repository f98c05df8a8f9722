"""No session starves another, however much its own client sends."""

import itertools
import json
import logging
import socket
import threading
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import ExitStack

import httpx
import pytest
import zenoh

from service.rest import dependencies
from service.rest.dependencies import MOST_FRAMES, Workers
from tests.service.support import F32, TIMEOUT_S, Camera, Running, blob, f32, inbox, running, wait_until, zenoh_client

AT_ONCE = 40
"""Requests of one client, more than the service has threads for requests."""


def test_frames_that_wait_for_one_session_take_no_thread_from_another(service: Running) -> None:
    slow, other = service.open_session("laptop_articulated"), service.open_session("mug")
    networks = service.provider.networks["laptop_articulated"]
    networks.gate.clear()
    with ThreadPoolExecutor(AT_ONCE) as pool:
        try:
            waiting = [pool.submit(service.post_frame, slow["session_id"], f32(blob()), seq) for seq in range(AT_ONCE)]
            assert networks.asked.wait(10)
            for seq in range(3):
                assert service.post_frame(other["session_id"], f32(blob()), seq).json()["seq"] == seq
            assert service.open_session("mug")["session_id"]
        finally:
            networks.gate.set()
        statuses = {answer.result().status_code for answer in waiting}
    assert statuses <= {httpx.codes.OK, httpx.codes.CONFLICT}  # they overtook each other on their way here
    assert httpx.codes.OK in statuses


def test_more_frames_than_may_wait_for_one_session_are_refused(service: Running) -> None:
    session_id, more = service.open_session()["session_id"], 8
    networks = service.provider.networks["mug"]
    networks.gate.clear()
    with ThreadPoolExecutor(MOST_FRAMES + more) as pool:
        sent = [pool.submit(service.post_frame, session_id, f32(blob()), seq) for seq in range(MOST_FRAMES + more)]
        try:
            refused = [answer.result() for answer in itertools.islice(as_completed(sent, timeout=TIMEOUT_S), more)]
        finally:
            networks.gate.set()
        answers = [answer.result() for answer in sent]
    assert {(answer.status_code, answer.json()["reason"]) for answer in refused} == {(429, "too-many-frames")}
    assert [answer.status_code for answer in answers].count(429) == more
    assert service.metric('captra_requests_rejected_total{reason="too-many-frames"}') == more
    assert service.session(session_id)["counters"]["received"] == MOST_FRAMES
    assert service.post_frame(session_id, f32(blob()), MOST_FRAMES + more).status_code == 200


def test_frames_that_wait_take_so_much_memory_and_no_more(service: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    cloud = f32(blob())
    monkeypatch.setattr(dependencies, "MOST_BYTES", 3 * len(cloud))
    sessions = [service.open_session()["session_id"] for _ in range(2)]
    networks = service.provider.networks["mug"]
    networks.gate.clear()
    with ThreadPoolExecutor(8) as pool:
        sent = [pool.submit(service.post_frame, sessions[seq % 2], cloud, seq) for seq in range(5)]
        try:
            refused = [answer.result() for answer in itertools.islice(as_completed(sent, timeout=TIMEOUT_S), 2)]
        finally:
            networks.gate.set()
        answers = [answer.result() for answer in sent]
    assert {(answer.status_code, answer.json()["reason"]) for answer in refused} == {(429, "too-many-frames")}
    assert [answer.status_code for answer in answers].count(429) == 2
    for _ in range(3):
        assert service.post_frame(sessions[0], cloud[:-1], 9).status_code == 422
    assert service.post_frame(sessions[0], cloud, 10).status_code == 200, "what is done takes no memory any more"


def test_frames_of_clients_that_left_are_not_tracked(service: Running) -> None:
    session_id, left = service.open_session()["session_id"], 3
    networks, at_work = service.provider.networks["mug"], service.server.server_state
    turn = workers_of(service).turn(service.service.registry.get(session_id)).statistics
    networks.gate.clear()
    with ThreadPoolExecutor(2) as pool:
        try:
            first = pool.submit(service.post_frame, session_id, f32(blob()), 0)
            assert networks.asked.wait(TIMEOUT_S)
            connections = len(at_work.connections)
            sockets = [posting(service, session_id, f32(blob()), seq) for seq in range(1, 1 + left)]
            wait_until(lambda: turn().tasks_waiting == left)
            for each in sockets:
                each.close()
            wait_until(lambda: len(at_work.connections) == connections)
            last = pool.submit(service.post_frame, session_id, f32(blob()), 1 + left)
            wait_until(lambda: turn().tasks_waiting == left + 1)
        finally:
            networks.gate.set()
        assert first.result().json()["seq"] == 0
        assert last.result().json()["seq"] == 1 + left
    assert service.session(session_id)["counters"]["processed"] == 2


def test_a_client_that_leaves_in_the_middle_of_a_frame_is_no_defect(
    service: Running, caplog: pytest.LogCaptureFixture
) -> None:
    session_id, at_work = service.open_session()["session_id"], service.server.server_state
    assert service.post_frame(session_id, f32(blob()), 0).status_code == 200
    connections = len(at_work.connections)
    client = posting(service, session_id, f32(blob()), 1, more=1)
    wait_until(lambda: len(at_work.tasks) == 1)
    client.close()
    wait_until(lambda: len(at_work.connections) == connections and not at_work.tasks)
    assert service.post_frame(session_id, f32(blob()), 1).json()["seq"] == 1
    assert not [record for record in caplog.records if record.levelno >= logging.ERROR]


def workers_of(service: Running) -> Workers:
    workers: Workers = service.server.config.app.state.workers  # type: ignore[union-attr]
    return workers


def posting(service: Running, session_id: str, payload: bytes, seq: int, more: int = 0) -> socket.socket:
    """A client that has sent a frame, but for `more` bytes, and does not wait for its result."""
    url = service.http.base_url
    client = socket.create_connection((url.host, url.port or 80))
    client.sendall(
        f"POST /v1/sessions/{session_id}/frames?seq={seq}&stamp_ns=0 HTTP/1.1\r\nHost: {url.host}\r\n"
        f"Content-Type: {F32}\r\nContent-Length: {len(payload) + more}\r\n\r\n".encode()
        + payload
    )
    return client


def test_every_frame_of_one_session_is_answered_while_another_is_flooded(service: Running) -> None:
    flooded, other = service.open_session(), service.open_session()
    stop = threading.Event()
    with ExitStack() as resources:
        network, foe = (resources.enter_context(zenoh_client(service.endpoint)) for _ in range(2))
        poses = inbox(network, other["zenoh"]["pose"])
        camera, flooding = Camera(network, other["zenoh"]["cloud"]), Camera(foe, flooded["zenoh"]["cloud"])

        def flood() -> None:
            seq = 0
            while not stop.is_set():
                flooding.put(f32(blob(points=3000)), seq := seq + 1)

        thread = threading.Thread(target=flood)
        thread.start()
        resources.callback(thread.join)
        resources.callback(stop.set)
        for seq in range(50):
            camera.put(f32(blob()), seq)
            assert poses.message(seq)["seq"] == seq
    counters = service.session(flooded["session_id"])["counters"]
    assert counters["processed"] > 0
    assert counters["dropped"] > 0


def test_message_far_over_the_limit_reaches_neither_its_session_nor_another() -> None:
    with (
        running("mug", max_payload_bytes=20_000) as service,
        far_client(service.endpoint) as foe,
        zenoh_client(service.endpoint) as network,
    ):
        assert service.service.readiness.wait_prepared(60)
        attacked, other = service.open_session(), service.open_session()
        poses = inbox(network, other["zenoh"]["pose"])
        camera, huge = (Camera(one, key["zenoh"]["cloud"]) for one, key in ((network, other), (foe, attacked)))
        for seq in range(20):
            huge.put(bytes(2_000_000), seq)
            camera.put(f32(blob()), seq)
            assert poses.message(seq)["seq"] == seq
        assert service.session(attacked["session_id"])["counters"]["received"] == 0


def far_client(endpoint: str) -> zenoh.Session:
    """As on another machine: without the shared memory by which large messages pass for small ones."""
    config = zenoh.Config()
    for key, value in {
        "mode": "client",
        "connect/endpoints": [endpoint],
        "scouting/multicast/enabled": False,
        "transport/shared_memory/enabled": False,
    }.items():
        config.insert_json5(key, json.dumps(value))
    return zenoh.open(config)

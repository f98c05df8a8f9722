"""No session starves another, however much its own client sends."""

import json
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import httpx
import zenoh

from tests.service.support import Camera, Running, blob, f32, inbox, running, zenoh_client

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

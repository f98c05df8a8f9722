"""The Zenoh hop alone: payloads to an echo behind a router on loopback and back."""

import json
import threading
import time
from collections.abc import Sequence

import zenoh

from captra.bench.runs import Hop, Percentiles
from clients.service_process import free_ports

PAYLOAD_BYTES = (64_000, 1_228_800, 3_686_400)
"""A cropped cloud, and 640 × 480 pixels as 32-bit depth and as points in float32."""

WARM_UP = 5
PATIENCE_S = 10.0
PING, PONG = "captra/bench/ping", "captra/bench/pong"


def hops(round_trips: int, payload_bytes: Sequence[int] = PAYLOAD_BYTES) -> list[Hop]:
    """Round trips of each size, one at a time; the echo and its router are in this process.

    Raises:
        TimeoutError: an answer does not come.
    """
    (port,) = free_ports(1)
    endpoint = f"tcp/127.0.0.1:{port}"
    with zenoh.open(_config("router", listen=endpoint)) as router, zenoh.open(_config("client", endpoint)) as client:
        answered = threading.Event()
        pong = router.declare_publisher(PONG, congestion_control=zenoh.CongestionControl.BLOCK, express=True)
        ping = client.declare_publisher(PING, congestion_control=zenoh.CongestionControl.BLOCK, express=True)
        router.declare_subscriber(PING, lambda sample: pong.put(sample.payload.to_bytes()))
        client.declare_subscriber(PONG, lambda _: answered.set())
        _until_connected(ping, answered)
        return [Hop(size, _round_trips(ping, answered, bytes(size), round_trips)) for size in payload_bytes]


def _round_trips(ping: zenoh.Publisher, answered: threading.Event, payload: bytes, count: int) -> Percentiles:
    durations_ms = []
    for _ in range(count + WARM_UP):
        answered.clear()
        started_s = time.perf_counter()
        ping.put(payload)
        if not answered.wait(PATIENCE_S):
            raise TimeoutError(f"no echo of {len(payload)} bytes within {PATIENCE_S:g} s")
        durations_ms.append(1e3 * (time.perf_counter() - started_s))
    return Percentiles.of(durations_ms[WARM_UP:])


def _until_connected(ping: zenoh.Publisher, answered: threading.Event) -> None:
    deadline_s = time.monotonic() + PATIENCE_S
    while time.monotonic() < deadline_s:
        ping.put(b"?")
        if answered.wait(0.1):
            time.sleep(0.1)  # for the echoes of what was put before
            return
    raise TimeoutError("the router on loopback does not answer")


def _config(mode: str, connect: str | None = None, listen: str | None = None) -> zenoh.Config:
    config = zenoh.Config()
    config.insert_json5("mode", json.dumps(mode))
    config.insert_json5("scouting/multicast/enabled", "false")
    if mode == "router":  # as the service has it
        config.insert_json5("transport/shared_memory/enabled", "false")
    config.insert_json5("connect/endpoints", json.dumps([connect] if connect else []))
    config.insert_json5("listen/endpoints", json.dumps([listen] if listen else []))
    return config

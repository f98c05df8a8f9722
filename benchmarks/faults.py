"""What goes wrong around a service: routers that die or freeze, clients that die or stop reading, malformed clouds."""

import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx

from benchmarks.malformed import malformed_clouds
from clients.service_process import free_ports
from service.envelopes import ATTACHMENT

FLOODED = {
    "category": "mug",
    "parts": [{"rotation": {"quat_xyzw": [0, 0, 0, 1]}, "translation": [0, 0, 0.5], "size": [0.1, 0.1, 0.1]}],
    "idle_timeout_s": 3600,
}
"""The session to which malformed clouds go."""
CONFIG = Path(__file__).resolve().parents[1] / "deploy" / "zenoh" / "router.json5"
ROUTER = """
import json, sys, zenoh
config = zenoh.Config.from_file(sys.argv[1])
entries = {"listen/endpoints": [sys.argv[2]], "connect/endpoints": [sys.argv[3]],
           "connect/retry": {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}}
for key, value in entries.items():
    config.insert_json5(key, json.dumps(value))
with zenoh.open(config):
    print("open", flush=True)
    sys.stdin.read()
"""
CLIENT = """
import sys, numpy as np
from captra.geometry import Pose
from clients import open_session
pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
session = open_session("mug", pose, url=sys.argv[1], idle_timeout_s=3600)
print(session.session_id, flush=True)
sys.stdin.read()
"""
WATCHER = """
import json, sys, zenoh
config = zenoh.Config()
for key, value in {"mode": "client", "connect/endpoints": [sys.argv[1]], "scouting/multicast/enabled": False}.items():
    config.insert_json5(key, json.dumps(value))
with zenoh.open(config) as session:
    subscriber = session.declare_subscriber("captra/**", lambda sample: None)
    print("watching", flush=True)
    sys.stdin.read()
"""


@contextmanager
def script(source: str, *arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A Python process and the first line that it says; killed at the end."""
    command = [sys.executable, "-c", source, *arguments]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process, process.stdout.readline().strip()
        finally:
            process.kill()


class Router:
    """The router of deploy/ between clients and a service, in a process of its own."""

    def __init__(self, service_endpoint: str) -> None:
        self.endpoint = f"tcp/127.0.0.1:{free_ports(1)[0]}"
        """Where clients connect to."""
        self._service_endpoint = service_endpoint

    def __enter__(self) -> "Router":
        self._script = script(ROUTER, str(CONFIG), self.endpoint, self._service_endpoint)
        self._process, _ = self._script.__enter__()
        return self

    def __exit__(self, *exception: object) -> None:
        self._script.__exit__(None, None, None)

    def restart(self) -> None:
        """Kill it and start another one in its place."""
        self.__exit__()
        self.__enter__()

    def freeze(self, duration_s: float) -> None:
        """Let nothing through for some time, as when a cable is out: no connection is closed."""
        self._process.send_signal(signal.SIGSTOP)
        time.sleep(duration_s)
        self._process.send_signal(signal.SIGCONT)


def kill_client(url: str) -> str:
    """Open a session in another process and kill that; the session's id."""
    with script(CLIENT, url) as (_, session_id):
        return session_id


@contextmanager
def stalled_watcher(endpoint: str) -> Iterator[None]:
    """Somebody who subscribes to everything and reads nothing."""
    with script(WATCHER, endpoint) as (process, _):
        process.send_signal(signal.SIGSTOP)
        yield


class Flood:
    """Malformed clouds by HTTP, to a session of their own."""

    def __init__(self, url: str, session_id: str, rate_hz: float) -> None:
        self.sent = 0
        """How many were answered."""
        self.crashes = 0
        """How many met a defect."""
        self._url = url
        self._path = f"/v1/sessions/{session_id}/frames"
        self._rate_hz = rate_hz
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._run)

    def __enter__(self) -> "Flood":
        self._thread.start()
        return self

    def __exit__(self, *exception: object) -> None:
        self._stopped.set()
        self._thread.join()

    def _run(self) -> None:
        with httpx.Client(base_url=self._url, timeout=60) as http:
            for envelope in malformed_clouds(seed=1):
                if self._stopped.wait(1 / self._rate_hz):
                    return
                seq, stamp_ns = ATTACHMENT.unpack((envelope.attachment or b"").ljust(16, b"\0")[:16])
                try:
                    answer = http.post(
                        self._path,
                        params={"seq": seq, "stamp_ns": stamp_ns},
                        content=envelope.payload,
                        headers={"Content-Type": envelope.encoding.encode("ascii", "replace").decode()},
                    )
                except httpx.TransportError:  # it is being killed
                    continue
                self.sent += 1
                self.crashes += answer.status_code == httpx.codes.INTERNAL_SERVER_ERROR


def is_open(url: str, session_id: str) -> bool:
    """Whether a service still has a session."""
    return httpx.get(f"{url}/v1/sessions/{session_id}", timeout=60).status_code == httpx.codes.OK


def metrics(url: str) -> dict[str, float]:
    """Every line of /metrics."""
    lines = httpx.get(f"{url}/metrics", timeout=60).text.splitlines()
    return {name: float(value) for name, _, value in (line.rpartition(" ") for line in lines if line[0] != "#")}

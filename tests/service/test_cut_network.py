"""The cable between a robot and the service is pulled out and put back: with a real cable between two namespaces."""

import json
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field
from datetime import datetime
from subprocess import Popen
from typing import Any

import httpx
import numpy as np
import pytest

from captra.geometry import Pose
from clients import Session, open_session
from clients.credentials import Credentials
from clients.service_process import free_ports
from tests.service.cables import Cable, cable
from tests.service.support import blob, wait_until
from tests.service.test_process import process, stream

LEASE_MS = 2000
"""After so long without a sign of life Zenoh gives the other side up; ten seconds where nobody chooses."""
GRACE_S = 6
WAIT_S = 40


@dataclass
class Log:
    """Entries of a service's log, read by a thread of their own so that the service never waits for a reader."""

    entries: list[dict[str, Any]] = field(default_factory=list)

    def read(self, service: Popen[str]) -> None:
        for line in stream(service.stderr):
            self.entries.append(json.loads(line))

    def find(self, message: str) -> dict[str, Any]:
        """The last entry with a message, once it is there."""
        said = f"the log never said {message!r}"
        wait_until(lambda: any(each["message"] == message for each in self.entries), said, WAIT_S)
        return [each for each in self.entries if each["message"] == message][-1]

    def count(self, message: str) -> int:
        return sum(each["message"] == message for each in self.entries)


@dataclass
class Robot:
    """Streams over the cable and looks at what comes back."""

    cable: Cable
    url: str
    log: Log
    session: Session

    def stream(self, stop: threading.Event) -> None:
        while not stop.wait(0.05):
            self.session.put(blob())

    def wait_for_news(self) -> None:
        """Wait for the result of a cloud that is put from now on."""
        seq = self.session.put(blob())

        def came() -> bool:
            return self.session.latest is not None and self.session.latest.seq > seq

        wait_until(came, "no result came through the cable", WAIT_S)

    def is_open(self) -> bool:
        return httpx.get(f"{self.url}/v1/sessions/{self.session.session_id}", timeout=20).status_code == 200


@pytest.fixture
def robot(monkeypatch: pytest.MonkeyPatch) -> Iterator[Robot]:
    monkeypatch.setattr(Credentials, "zenoh_entries", {"transport/link/tx/lease": LEASE_MS})
    with ExitStack() as resources:
        between = resources.enter_context(cable())
        http_port, zenoh_port = free_ports(2)
        variables = {
            "CAPTRA_HTTP_HOST": between.far,
            "CAPTRA_HTTP_PORT": str(http_port),
            "CAPTRA_ZENOH_LISTEN": json.dumps([f"tcp/{between.far}:{zenoh_port}"]),
            "CAPTRA_ALLOW_OPEN": "true",
            "CAPTRA_CLIENT_GRACE_S": str(GRACE_S),
            "LEASE_MS": str(LEASE_MS),
        }
        inside = between.inside(sys.executable, "-m", "tests.service.quick_service")
        launcher = f"import os; os.execvp('ip', {inside})"
        service, log = resources.enter_context(process("-c", launcher, **variables)), Log()
        reader = threading.Thread(target=log.read, args=(service,))
        reader.start()
        resources.callback(reader.join)
        resources.callback(service.kill)
        log.find("ready")
        url = f"http://{between.far}:{http_port}"
        pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
        session = resources.enter_context(open_session("mug", pose, url=url))
        robot, stop = Robot(between, url, log, session), threading.Event()
        streaming = threading.Thread(target=robot.stream, args=(stop,))
        streaming.start()
        resources.callback(streaming.join)
        resources.callback(stop.set)
        robot.wait_for_news()
        yield robot


def test_session_outlives_a_cut_network_for_the_grace_time_and_not_longer(robot: Robot) -> None:
    robot.cable.cut()  # shorter than anybody notices
    time.sleep(0.5)
    robot.cable.mend()
    robot.wait_for_news()
    assert robot.log.count("client token gone") == 0

    robot.cable.cut()  # until Zenoh gives up the connection, but not for the grace time
    robot.log.find("client token gone")
    robot.cable.mend()
    robot.wait_for_news()
    assert robot.log.count("session opened") == 1  # it goes on without a new POST
    time.sleep(GRACE_S + 1)
    assert robot.is_open()  # its token is back

    robot.cable.cut()
    closed = robot.log.find("session closed")
    gone = robot.log.find("client token gone")
    assert (closed["session_id"], closed["reason"]) == (robot.session.session_id, "client-gone")
    waited = datetime.fromisoformat(closed["time"]) - datetime.fromisoformat(gone["time"])
    assert waited.total_seconds() >= GRACE_S - 0.1
    robot.cable.mend()

"""Sessions are reached through the routers of deploy/, which connect to the one inside the service."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

import numpy as np
import pytest
import zenoh

from captra.geometry import Pose
from clients import open_session
from tests.service.support import blob, free_endpoint, running

FOLDER = Path(__file__).parents[2] / "deploy" / "zenoh"


@pytest.mark.parametrize("name", ["router.json5", "robot.json5"])
def test_poses_come_through_the_router(name: str) -> None:
    inner, outer = free_endpoint(), free_endpoint()
    config = zenoh.Config.from_file(str(FOLDER / name))
    config.insert_json5("listen/endpoints", json.dumps([outer]))
    config.insert_json5("connect/endpoints", json.dumps([inner]))
    pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
    with zenoh.open(config), running("mug", endpoint=inner, zenoh_advertise=(outer,)) as service:
        assert service.service.readiness.wait_prepared(30)
        with open_session("mug", pose, url=str(service.http.base_url)) as session:
            results = list(session.track([blob()] * 3))  # each waits for the result of the one before
    assert [result.seq for result in results] == [0, 1, 2]


ROUTER = """
import resource, sys, zenoh
resource.setrlimit(resource.RLIMIT_MEMLOCK, (2**16, resource.getrlimit(resource.RLIMIT_MEMLOCK)[1]))
config = zenoh.Config.from_file(sys.argv[1])
for key, value in zip(("listen/endpoints", "connect/endpoints"), sys.argv[2:]):
    config.insert_json5(key, value)
with zenoh.open(config):
    print("open", flush=True)
    sys.stdin.read()
"""


WITHOUT_RIGHTS = ("setpriv", "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs")
"""As root without capabilities: limits hold, as for any user."""


@contextmanager
def router_process(listen: str, connect: str, name: str = "router.json5") -> Iterator[None]:
    """A router of deploy/ in a process of its own, which may lock little memory and is killed at the end."""
    arguments = (str(FOLDER / name), json.dumps([listen]), json.dumps([connect]))
    rights = WITHOUT_RIGHTS if os.geteuid() == 0 else ()
    command = [*rights, sys.executable, "-c", ROUTER, *arguments]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as router:
        assert router.stdout is not None
        assert router.stdout.readline() == "open\n"
        yield
        router.kill()


def test_a_session_goes_on_when_a_router_between_is_killed_and_started_again() -> None:
    inner, outer = free_endpoint(), free_endpoint()
    pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
    with running("mug", endpoint=inner, zenoh_advertise=(outer,), client_grace_s=20) as service, ExitStack() as last:
        assert service.service.readiness.wait_prepared(30)
        with router_process(outer, inner):
            session = last.enter_context(open_session("mug", pose, url=str(service.http.base_url)))
            assert [result.seq for result in session.track([blob(), blob()])] == [0, 1]
        assert session.put(blob()) == 2  # nobody is there to pass it on
        last.enter_context(router_process(outer, inner))
        deadline = time.monotonic() + 20
        while session.latest is None or session.latest.seq < 10:
            assert time.monotonic() < deadline, "the session did not go on"
            session.put(blob((0.01, 0, 0.5)))
            time.sleep(0.05)
        assert session.latest.parts[0].translation[0] == pytest.approx(0.01, abs=3e-3)
        assert service.metric("captra_sessions_opened_total") == 1
        session.close()


@pytest.mark.parametrize("name", ["router.json5", "robot.json5"])
def test_clients_may_lock_more_memory_than_the_router(name: str) -> None:
    inner, outer = free_endpoint(), free_endpoint()
    pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
    with running("mug", endpoint=inner, zenoh_advertise=(outer,)) as service, router_process(outer, inner, name):
        assert service.service.readiness.wait_prepared(30)
        with open_session("mug", pose, url=str(service.http.base_url)) as session:
            results = list(session.track([np.tile(blob(), (9, 1))] * 10))
    assert [result.seq for result in results] == list(range(10))


def test_a_router_waits_for_a_service_that_is_not_there_yet() -> None:
    config = zenoh.Config.from_file(str(FOLDER / "router.json5"))
    config.insert_json5("listen/endpoints", json.dumps([free_endpoint()]))
    config.insert_json5("connect/endpoints", json.dumps([free_endpoint()]))
    with zenoh.open(config) as router:
        assert list(router.info.routers_zid()) == []

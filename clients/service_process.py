"""A service of one's own as a child process, on free loopback ports: for the demo, tests and benchmarks."""

import json
import os
import socket
import subprocess
import sys
from collections.abc import Mapping, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic
from typing import Self

from clients.errors import RequestRefusedError, ServiceUnreachableError
from clients.rest import RestApi

POLL_S = 0.05
STOP_S = 10.0
LOG_LINES = 20
HINDERED = "hindered"
"""The reason with which a service is not ready for good."""


class ServiceProcess:
    """`captra serve` with its embedded Zenoh router; used with `with`, which waits until it is ready and stops it."""

    def __init__(
        self,
        settings: Mapping[str, str] | None = None,
        ready_within_s: float = 180.0,
        module: Sequence[str] = ("captra", "serve"),
    ) -> None:
        """`settings` are further CAPTRA_* variables; compiling kernels for the first time takes most of the wait.

        `module` is what Python runs, with its arguments.
        """
        self._settings = dict(settings or {})
        self._module = module
        self._ready_within_s = ready_within_s
        self._http_port, self._zenoh_port = free_ports(2)

    @property
    def url(self) -> str:
        """Where its REST API is."""
        return f"http://127.0.0.1:{self._http_port}"

    @property
    def pid(self) -> int:
        """Process number."""
        return self._process.pid

    @property
    def is_running(self) -> bool:
        """Whether the process has not ended."""
        return self._process.poll() is None

    def __enter__(self) -> Self:
        self._folder = TemporaryDirectory(prefix="captra-")
        self._log = Path(self._folder.name, "service.log")
        with self._log.open("wb") as log:
            self._process = subprocess.Popen(
                [sys.executable, "-m", *self._module],
                env=os.environ | self._own_settings() | self._settings,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )
        try:
            self._wait_until_ready()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *exception: object) -> None:
        self.stop()

    def stop(self) -> int:
        """Ask it to stop (SIGTERM), insist after ten seconds; the exit status, 0 for a clean stop."""
        self._process.terminate()
        try:
            return self._process.wait(STOP_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            return self._process.wait()
        finally:
            self._folder.cleanup()

    def log_tail(self) -> str:
        """The last lines that the service wrote."""
        return "\n".join(self._log.read_text(errors="replace").splitlines()[-LOG_LINES:])

    def _own_settings(self) -> dict[str, str]:
        return {
            "CAPTRA_HTTP_HOST": "127.0.0.1",
            "CAPTRA_HTTP_PORT": str(self._http_port),
            "CAPTRA_ZENOH_LISTEN": json.dumps([f"tcp/127.0.0.1:{self._zenoh_port}"]),
            "CAPTRA_STATE_DIR": str(Path(self._folder.name, "state")),
        }

    def _wait_until_ready(self) -> None:
        deadline = monotonic() + self._ready_within_s
        with closing(RestApi(self.url)) as api:
            while (obstacle := obstacle_of(api)) is not None:
                if obstacle.is_final or monotonic() > deadline:
                    raise ServiceUnreachableError(f"the service is not ready: {obstacle.detail}\n{self.log_tail()}")
                with suppress(subprocess.TimeoutExpired):
                    status = self._process.wait(POLL_S)
                    raise ServiceUnreachableError(f"the service ended with status {status}:\n{self.log_tail()}")


@dataclass(frozen=True)
class Obstacle:
    """Why a service is not ready."""

    detail: str
    """In the service's words."""
    is_final: bool
    """Whether waiting does not help."""


def obstacle_of(api: RestApi) -> Obstacle | None:
    """What keeps a service from being ready, if anything does."""
    try:
        api.check_ready()
    except ServiceUnreachableError as error:
        return Obstacle(str(error), is_final=False)
    except RequestRefusedError as error:
        return Obstacle(error.detail, error.reason == HINDERED)
    return None


def free_ports(count: int) -> list[int]:
    """Loopback ports that nothing listens on at present."""
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    try:
        return [int(each.getsockname()[1]) for each in sockets]
    finally:
        for each in sockets:
            each.close()

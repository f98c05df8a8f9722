"""As a user without rights on a file system that cannot be written, with one small folder for state that fills up."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import httpx
import pytest

from tests.service.support import F32, blob, f32, free_endpoint, session_body
from tests.service.test_process import entry, process, stream

NOBODY = 65534
WITHOUT_RIGHTS = f"setpriv --reuid {NOBODY} --regid {NOBODY} --clear-groups --no-new-privs --inh-caps=-all"
CONFINED = f"""
mount --make-rprivate /
mount -t tmpfs -o size=256k,mode=0777 tmpfs "$STATE"
while read -r _ target kind _; do
    case $target in "$STATE"|/dev/shm) continue ;; esac
    case $kind in ext*|xfs|btrfs|overlay|tmpfs) mount -o remount,bind,ro "$target" ;; esac
done < /proc/self/mounts
exec {WITHOUT_RIGHTS} "$@"
"""
"""Shared memory can be written, as in any container: Zenoh needs it."""
FOLDERS = (Path.cwd(), Path(sys.prefix), Path("/tmp"), Path("/var/tmp"), Path("/"))
WRITES = f"""
import service, numba
for folder in {[str(folder) for folder in FOLDERS]}:
    try:
        open(folder + "/written", "w")
    except OSError:
        continue
    raise SystemExit(folder + " can be written")
"""


def confined(*arguments: str) -> list[str]:
    """A Python command in a mount namespace of its own, where only the folder $STATE can be written."""
    return ["unshare", "--mount", "sh", "-ec", CONFINED, "confined", sys.executable, *arguments]


@pytest.fixture
def state() -> Iterator[Path]:
    """Where state goes, in a folder that everybody may enter; skips where this cannot be tried."""
    with TemporaryDirectory(prefix="captra-state-") as folder:
        environment = os.environ | {"STATE": folder}
        command = confined("-c", WRITES)
        tried = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        assert "can be written" not in tried.stderr, tried.stderr
        if tried.returncode:
            pytest.skip(f"needs root, mount namespaces and a project that every user may read: {tried.stderr.strip()}")
        yield Path(folder)


class Confined:
    """A service that runs so, and its client."""

    def __init__(self, pid: int, state: Path, http: httpx.Client) -> None:
        self._pid = pid
        self._state = state
        self.http = http

    def post(self) -> httpx.Response:
        return self.http.post("/v1/sessions", json=session_body())

    def frame(self, session_id: str, seq: int) -> httpx.Response:
        query, headers = {"seq": seq, "stamp_ns": 0}, {"Content-Type": F32}
        return self.http.post(f"/v1/sessions/{session_id}/frames", params=query, content=f32(blob()), headers=headers)

    def failures(self) -> float:
        for line in self.http.get("/metrics").text.splitlines():
            if line.startswith("captra_store_failures_total "):
                return float(line.split()[1])
        raise AssertionError("the metric is missing")

    def wait_for_failures(self, count: int) -> None:
        deadline = time.monotonic() + 20
        while self.failures() < count:
            assert time.monotonic() < deadline, "too few writes failed"
            time.sleep(0.05)

    def fill(self) -> Path:
        """Take all the space of the state's folder, as only the service sees it."""
        filler = Path(f"/proc/{self._pid}/root{self._state}/filler")
        with filler.open("wb", buffering=0) as file, suppress(OSError):  # no space left on device
            while True:
                file.write(bytes(512))
        return filler


def test_tracks_as_nobody_on_a_read_only_system_and_when_the_disk_is_full(state: Path) -> None:
    variables = {
        "STATE": str(state),
        "HOME": "/nonexistent",
        "CAPTRA_STATE_DIR": str(state),
        "CAPTRA_HTTP_PORT": "0",
        "CAPTRA_ZENOH_LISTEN": json.dumps([free_endpoint()]),
    }
    command = confined("-m", "tests.service.quick_service")
    with ExitStack() as resources:
        launcher = f"import os; os.execvp('unshare', {command})"
        service = resources.enter_context(process("-c", launcher, **variables))
        log = stream(service.stderr)
        http = resources.enter_context(httpx.Client(base_url=entry(log, "serving")["http"], timeout=20))
        running = Confined(service.pid, state, http)
        entry(log, "ready")
        status = Path(f"/proc/{service.pid}/status").read_text()
        assert f"Uid:\t{NOBODY}\t{NOBODY}" in status
        assert "CapEff:\t0000000000000000" in status
        session_id = running.post().json()["session_id"]
        assert running.failures() == 0

        filler = running.fill()
        refused = running.post()
        assert (refused.status_code, refused.json()["reason"]) == (503, "not-stored")
        assert running.failures() == 1
        assert running.frame(session_id, 0).status_code == 200
        assert running.frame(session_id, 1).status_code == 200
        running.wait_for_failures(3)  # poses are tried again and again
        assert running.frame(session_id, 2).status_code == 200
        told: dict[str, Any] = entry(log, "trusted poses not stored: database or disk is full")
        assert told["session_ids"] == [session_id]

        filler.unlink()
        entry(log, "trusted poses stored again")
        assert running.post().status_code == 201
        assert running.frame(session_id, 3).status_code == 200
        service.send_signal(signal.SIGTERM)
        assert service.wait(20) == 0

"""A disk that fills up while a session is recorded: the session goes on, and what was recorded is kept."""

import json
import resource
import signal
import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from subprocess import Popen
from typing import IO, Any

import httpx
import numpy as np

from captra.recording.reader import messages
from tests.service.support import F32, blob, f32, free_endpoint, session_body
from tests.service.test_process import entry, process, stream

MOST_BYTES = 20 * 2**20
"""What one recording may take, and all of them: there is no room for another that is promised as much."""
UNLIMITED = resource.RLIM_INFINITY


class Recording:
    """A service process that records, and its client."""

    def __init__(self, folder: Path, resources: ExitStack) -> None:
        variables = {
            "CAPTRA_HTTP_PORT": "0",
            "CAPTRA_ZENOH_LISTEN": json.dumps([free_endpoint()]),
            "CAPTRA_RECORD_DIR": str(folder),
            "CAPTRA_RECORD_MAX_BYTES": str(MOST_BYTES),
            "CAPTRA_RECORD_MAX_TOTAL_BYTES": str(MOST_BYTES),
        }
        self.process: Popen[str] = resources.enter_context(process("-m", "tests.service.quick_service", **variables))
        self.log: IO[str] = stream(self.process.stderr)
        url = entry(self.log, "serving")["http"]
        self.http = resources.enter_context(httpx.Client(base_url=url, timeout=20))
        entry(self.log, "ready")

    def files_end_at(self, size_bytes: int) -> None:
        """No file can be written beyond this size any more, as if there were no room."""
        resource.prlimit(self.process.pid, resource.RLIMIT_FSIZE, (size_bytes, UNLIMITED))

    def open_session(self) -> str:
        answer = self.http.post("/v1/sessions", json=session_body(record=True))
        assert answer.status_code == 201, answer.text
        session_id: str = answer.json()["session_id"]
        return session_id

    def post_frame(self, session_id: str, seq: int) -> None:
        scattered = np.random.default_rng(seq).uniform(-1, 1, (6000, 3)).astype(np.float32)
        query, headers = {"seq": seq, "stamp_ns": 0}, {"Content-Type": F32}
        payload, path = f32(np.concatenate([blob(), scattered])), f"/v1/sessions/{session_id}/frames"
        assert self.http.post(path, params=query, content=payload, headers=headers).status_code == 200

    def frames_until(self, session_id: str, is_enough: Callable[[dict[str, Any]], bool]) -> int:
        """Post frames until what is told of the recording is enough; how many."""
        for seq in range(1000):
            self.post_frame(session_id, seq)
            if is_enough(self.told(session_id)):
                return seq + 1
        raise AssertionError("it never was")

    def told(self, session_id: str) -> dict[str, Any]:
        listed: list[dict[str, Any]] = self.http.get("/v1/recordings").json()["recordings"]
        (told,) = (each for each in listed if each["name"] == f"mug_{session_id}")
        return told


def seqs_in(path: Path) -> list[int]:
    return [body["seq"] for name, body in messages(path) if name == "captra.Frame"]


def test_what_was_recorded_is_saved_at_once_where_there_is_room_for_a_copy(tmp_path: Path) -> None:
    with ExitStack() as resources:
        service = Recording(tmp_path, resources)
        service.files_end_at(3 * 2**20 + 1000)
        session_id = service.open_session()
        count = service.frames_until(session_id, lambda told: bool(told["finished"]))
        service.post_frame(session_id, count)  # the session goes on
        seqs = seqs_in(tmp_path / f"mug_{session_id}.mcap")
        assert seqs == list(range(len(seqs)))
        assert 0 < len(seqs) < count


def test_what_was_recorded_is_saved_at_the_next_start_where_the_disk_was_full(tmp_path: Path) -> None:
    with ExitStack() as resources:
        service = Recording(tmp_path, resources)
        session_id = service.open_session()
        count = service.frames_until(session_id, lambda told: told["size_bytes"] > 2 * 2**20)
        service.files_end_at(2**20)  # not even a copy can be written
        for seq in range(count, count + 20):
            service.post_frame(session_id, seq)
        entry(service.log, "recording broken off")
        assert service.http.delete(f"/v1/sessions/{session_id}").status_code == 204
        assert service.told(session_id)["finished"] is False
        answer = service.http.get(f"/v1/recordings/mug_{session_id}")
        assert (answer.status_code, answer.json()["reason"]) == (409, "unfinished-recording")
        assert "broken off" in answer.json()["detail"]
        service.open_session()  # the room that was promised to the first is free again
        service.process.send_signal(signal.SIGTERM)
        assert service.process.wait(20) == 0
    with ExitStack() as resources:
        service = Recording(tmp_path, resources)
        deadline = time.monotonic() + 20
        while not service.told(session_id)["finished"]:
            assert time.monotonic() < deadline, "it was never saved"
            time.sleep(0.02)
    seqs = seqs_in(tmp_path / f"mug_{session_id}.mcap")
    assert seqs == list(range(len(seqs)))
    assert 0 < len(seqs) < count + 20

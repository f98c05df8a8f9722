"""Listens to sessions that others opened and writes each into an MCAP file of its own."""

import struct
import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import zenoh

from captra.recording.writer import SessionWriter, Shown
from clients.clouds import ENCODINGS, I16_METRES
from clients.inbox import Inbox
from clients.regions import PACKED_BOX
from clients.rest import RestApi, reachable
from clients.results import parse_result
from clients.stream import connect

NUMBER = struct.Struct("<Qq")
"""Number and stamp begin every attachment."""
SECRET_BYTES = 16
PNG_BEGIN, PNG_END = b"\x89PNG\r\n\x1a\n", b"IEND\xae\x42\x60\x82"
CDR = "application/cdr"
KINDS = ("cloud", "pose", "event")
LOOK_AGAIN_S = 0.5


@dataclass(frozen=True)
class Heard:
    """What was put on a key of a session."""

    session_id: str
    """Whose."""
    kind: str
    """Which key: `cloud`, `pose` or `event`."""
    encoding: str
    """Media type."""
    payload: bytes
    """What was put."""
    attachment: bytes
    """What came along."""


class SessionFiles:
    """One file for each session that is heard of."""

    def __init__(self, api: RestApi, folder: Path, tell: Callable[[str], None]) -> None:
        """`tell` is given a line for people whenever a file begins or ends."""
        self._api = api
        self._folder = folder
        self._tell = tell
        self._writers: dict[str, SessionWriter] = {}
        self._ended: set[str] = set()

    def take(self, heard: Heard) -> None:
        """Write it down; the last event of a session ends its file."""
        if heard.session_id in self._ended:
            return
        writer = self._writers.get(heard.session_id) or self.begin(heard.session_id)
        match heard.kind:
            case "cloud" if len(heard.attachment) >= NUMBER.size:
                seq, stamp_ns = NUMBER.unpack(heard.attachment[: NUMBER.size])
                mask = mask_in(heard.attachment[NUMBER.size :])
                writer.frame(seq, stamp_ns, heard.encoding, heard.payload, mask, shown(heard.encoding, heard.payload))
            case "pose":
                writer.result(heard.payload, parse_result(heard.payload))
            case "event":
                writer.event(heard.payload)
                if b'"kind":"closing"' in heard.payload:
                    self._end(heard.session_id)

    def begin(self, session_id: str) -> SessionWriter:
        """A file for a session, which begins at the pose that it has now."""
        state = self._api.session(session_id)
        path = self._folder / f"{state['category']}_{session_id}.mcap"
        writer = self._writers[session_id] = SessionWriter(path)
        writer.session(body_of(state))
        self._tell(f"{path}: recording")
        return writer

    @property
    def open(self) -> bool:
        """Whether any session still goes on."""
        return bool(self._writers)

    def close(self) -> None:
        """Complete every file."""
        for session_id in list(self._writers):
            self._end(session_id)

    def _end(self, session_id: str) -> None:
        self._ended.add(session_id)
        self._writers.pop(session_id).close()
        self._tell(f"session {session_id}: complete")


def listen_to(
    api: RestApi, sessions: Sequence[str], folder: Path, tell: Callable[[str], None], until_s: float | None = None
) -> None:
    """Record some sessions until they are closed, or all of them, also such as are opened meanwhile, until interrupted.

    Args:
        api: of the service.
        sessions: ids; none for all.
        folder: where files go.
        tell: given a line for people whenever a file begins or ends.
        until_s: how long to listen at most, seconds.

    Raises:
        RequestRefusedError: a session does not exist.
        ServiceUnreachableError: the service, or its Zenoh router, is not reached.
    """
    end_s = None if until_s is None else time.monotonic() + until_s
    files, inbox = SessionFiles(api, folder, tell), Inbox[Heard](4096)
    with ExitStack() as resources:
        resources.callback(files.close)
        states = [api.session(session_id) for session_id in sessions] or wait_for_one(api, end_s)
        if not states:
            return
        endpoints = tuple(reachable(endpoint, api.url) for endpoint in states[0]["zenoh"]["endpoints"])
        network = resources.enter_context(connect(endpoints, api.timeout_s))
        stems = [state["zenoh"]["cloud"].removesuffix("/cloud") for state in states]
        heard_stems = stems if sessions else [stems[0].rpartition("/")[0] + "/*"]
        for stem in heard_stems:
            for kind in KINDS:
                network.declare_subscriber(f"{stem}/{kind}", lambda sample: inbox.put(heard_of(sample)))
        for state in states:
            files.begin(state["session_id"])
        while (end_s is None or time.monotonic() < end_s) and (files.open or not sessions):
            heard = inbox.get(LOOK_AGAIN_S)
            if heard is not None:
                files.take(heard)


def wait_for_one(api: RestApi, end_s: float | None) -> Sequence[Any]:
    """The open sessions, as soon as there is one."""
    while not (states := api.sessions()) and (end_s is None or time.monotonic() < end_s):
        time.sleep(LOOK_AGAIN_S)
    return states


def heard_of(sample: zenoh.Sample) -> Heard:
    """A sample on a key of a session."""
    *_, session_id, kind = str(sample.key_expr).split("/")
    attachment = b"" if sample.attachment is None else sample.attachment.to_bytes()
    return Heard(session_id, kind, str(sample.encoding), sample.payload.to_bytes(), attachment)


def mask_in(tail: bytes) -> bytes:
    """The mask or box behind number and stamp, without the session's secret, which must not be recorded."""
    if tail.startswith(PNG_BEGIN):
        return tail[: tail.find(PNG_END) + len(PNG_END)]
    return tail[: PACKED_BOX.size] if len(tail) in {PACKED_BOX.size, PACKED_BOX.size + SECRET_BYTES} else b""


def shown(encoding: str, payload: bytes) -> Shown:
    """What viewers are shown of a cloud; nothing of a depth image, whose camera is not known here."""
    media_type = encoding.partition(";")[0]
    if media_type == CDR:
        return payload
    if media_type == ENCODINGS["f32"].media_type and len(payload) % 12 == 0:
        return np.frombuffer(payload, "<f4").reshape(-1, 3)
    if media_type == ENCODINGS["i16"].media_type and len(payload) % 6 == 0:
        return np.frombuffer(payload, "<i2").reshape(-1, 3) * I16_METRES
    return None


def body_of(state: Any) -> dict[str, Any]:
    """The body of a POST that opens a session where this one is now."""
    parts = [
        {"rotation": {"quat_xyzw": part["quat_xyzw"]}, "translation": part["translation"], "size": part["size"]}
        for part in state["last_result"]["parts"]
    ]
    return {name: state[name] for name in ("category", "profile", "frame_id")} | {"parts": parts}

"""Listens to sessions that others opened and writes each into an MCAP file of its own."""

import json
import struct
import time
from collections.abc import Callable, Collection, Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from threading import Event

import zenoh

from captra.recording.writer import SessionWriter
from clients.camera import Camera
from clients.errors import RequestRefusedError
from clients.inbox import Inbox
from clients.overheard import body_of, camera_in, mask_in, parts_now, shown
from clients.recorder import recording_into
from clients.rest import RestApi
from clients.results import parse_result
from clients.stream import connect

NUMBER = struct.Struct("<Qq")
"""Number and stamp begin every attachment."""
ALIVE = "alive"
"""Key of the service's token: there as long as the session is open."""
KINDS = ("cloud", "pose", "event")
LOOK_AGAIN_S = 0.5


@dataclass(frozen=True)
class Heard:
    """What was put on a key of a session."""

    session_id: str
    """Whose."""
    kind: str
    """Which key: `cloud`, `pose`, `event`, or `alive`."""
    encoding: str
    """Media type."""
    payload: bytes
    """What was put."""
    attachment: bytes
    """What came along."""


class SessionFiles:
    """One file for each session that is heard of."""

    def __init__(
        self, api: RestApi, folder: Path, tell: Callable[[str], None], under_way: Collection[str] = frozenset()
    ) -> None:
        """`tell` is given a line for people whenever a file begins or ends; `under_way` had frames before."""
        self._api = api
        self._folder = folder
        self._tell = tell
        self._under_way = under_way
        self._writers: dict[str, SessionWriter] = {}
        self._cameras: dict[str, Camera | None] = {}
        self._ended: set[str] = set()

    def take(self, heard: Heard) -> None:
        """Write it down; the last event of a session ends its file."""
        known = heard.session_id in self._writers
        if heard.session_id in self._ended or (heard.kind == "event" and not known):  # the end of one that was before
            return
        try:
            writer = self._writers.get(heard.session_id) or self.begin(heard.session_id)
        except RequestRefusedError:
            self._ended.add(heard.session_id)
            self._tell(f"session {heard.session_id}: not recorded, it was closed again at once")
        else:
            self._write(writer, heard)

    def begin(self, session_id: str) -> SessionWriter:
        """A file for a session: from where it was started, or from where it is now if frames went by before.

        Raises:
            RequestRefusedError: there is no such session.
            RecordingError: the file cannot be written.
        """
        state = self._api.session(session_id)
        heard_all = session_id not in self._under_way or state["last_result"]["seq"] is None
        path = self._folder / f"{state['category']}_{session_id}.mcap"
        with recording_into(path):
            writer = self._writers[session_id] = SessionWriter(path)
        self._cameras[session_id] = camera_in(state)
        writer.session(body_of(state, state["started_from"] if heard_all else parts_now(state)))
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

    def _write(self, writer: SessionWriter, heard: Heard) -> None:
        match heard.kind:
            case "cloud" if len(heard.attachment) >= NUMBER.size:
                seq, stamp_ns = NUMBER.unpack(heard.attachment[: NUMBER.size])
                mask = mask_in(heard.attachment[NUMBER.size :])
                seen = shown(heard.encoding, heard.payload, self._cameras[heard.session_id])
                writer.frame(seq, stamp_ns, heard.encoding, heard.payload, mask, seen)
            case "pose":
                writer.result(heard.payload, parse_result(heard.payload))
            case "event":
                writer.event(heard.payload)
                kind = json.loads(heard.payload)["kind"]
                if kind == "reset":
                    self._reset(writer, heard.session_id)
                elif kind == "closing":
                    self._end(heard.session_id)

    def _reset(self, writer: SessionWriter, session_id: str) -> None:
        with suppress(RequestRefusedError):  # it is closed already: no frame follows
            writer.reset({"parts": self._api.session(session_id)["started_from"]})

    def _end(self, session_id: str) -> None:
        self._ended.add(session_id)
        self._writers.pop(session_id).close()
        self._tell(f"session {session_id}: complete")


def listen_to(
    api: RestApi,
    sessions: Sequence[str],
    folder: Path,
    tell: Callable[[str], None],
    until_s: float | None = None,
    stopped: Event | None = None,
) -> None:
    """Record some sessions until they are closed, or all of them, also such as are opened meanwhile, until stopped.

    Args:
        api: of the service.
        sessions: ids; none for all.
        folder: where files go.
        tell: given a line for people whenever a file begins or ends, and where there is nothing to record yet.
        until_s: how long to listen at most, seconds.
        stopped: set to end it, with every file complete; a moment may pass.

    Raises:
        RequestRefusedError: a session does not exist.
        ServiceUnreachableError: the service, or its Zenoh router, is not reached.
        RecordingError: a file cannot be written.
    """
    stopped = stopped or Event()
    end_s = None if until_s is None else time.monotonic() + until_s
    inbox = Inbox[Heard](4096)
    network = api.network()
    with ExitStack() as resources:
        session = resources.enter_context(connect(network["endpoints"], api.timeout_s))
        for name in sessions or ["*"]:
            subscribe(session, f"{network['sessions']}/{name}", inbox)
        under_way = [state["session_id"] for state in api.sessions()]
        if not (sessions or under_way):
            tell("no session is open yet: waiting for one; Ctrl-C ends this")
        files = SessionFiles(api, folder, tell, under_way)
        resources.callback(files.close)
        for session_id in sessions or under_way:
            files.begin(session_id)
        while not stopped.is_set() and (end_s is None or time.monotonic() < end_s) and (files.open or not sessions):
            heard = inbox.get(LOOK_AGAIN_S)
            if heard is not None:
                files.take(heard)


def subscribe(session: zenoh.Session, stem: str, inbox: Inbox[Heard]) -> None:
    """Put into `inbox` whatever comes on the keys of sessions, and which sessions there are."""

    def receive(sample: zenoh.Sample) -> None:
        if sample.kind == zenoh.SampleKind.PUT:
            inbox.put(heard_of(sample))

    for kind in KINDS:
        session.declare_subscriber(f"{stem}/{kind}", receive)
    # With those that were there before: one may be opened before the router knows of the subscriber.
    session.liveliness().declare_subscriber(f"{stem}/{ALIVE}", receive, history=True)


def heard_of(sample: zenoh.Sample) -> Heard:
    """A sample on a key of a session."""
    *_, session_id, kind = str(sample.key_expr).split("/")
    attachment = b"" if sample.attachment is None else sample.attachment.to_bytes()
    return Heard(session_id, kind, str(sample.encoding), sample.payload.to_bytes(), attachment)

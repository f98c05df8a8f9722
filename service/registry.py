"""All open sessions of this process, and how they begin and end."""

import logging
import secrets
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field

from captra.geometry import Pose
from captra.health import State
from captra.tracker import TrackerOptions
from service.camera import Camera
from service.codecs import Codecs
from service.ledger import Ledger
from service.liveness import CloseReason, Liveness
from service.networks import NetworksProvider
from service.readiness import STOPPING
from service.recording.folder import Recordings
from service.recording.tape import Tape
from service.rejections import NotReadyError, NotStoredError, RejectedError, TooManySessionsError, UnknownSessionError
from service.reporter import Reporter
from service.results import Result
from service.ros2.options import Ros2Options
from service.session import Session
from service.store import SessionRecord, SessionStore, StoreError, TrustedPose
from service.telemetry import Telemetry
from service.track_options import TrackOptions
from service.transport import Stream, Transport
from service.turns import Turns

logger = logging.getLogger(__name__)


def no_ros2(session_id: str) -> Ros2Options | None:  # noqa: ARG001 - of one signature
    """ROS 2 sees nothing of the session."""
    return None


@dataclass(frozen=True)
class NewSession:
    """What a client asks for."""

    category: str
    """What is tracked."""
    profile: str
    """Sampling budget."""
    frame_id: str
    """Frame of clouds that name none."""
    idle_timeout_s: float
    """Closed after so long without a frame."""
    pose: Pose
    """Where the object is in the first cloud."""
    camera: Camera | None = None
    """Of depth images."""
    masks: str | None = None
    """What masks that travel with frames tell."""
    ros2: Callable[[str], Ros2Options | None] = no_ros2
    """Its names in ROS 2, given its id; none where the service is no node."""
    record: bool = False
    """Whether the service records it."""
    secret_sha256: str | None = None
    """Digest of the secret that has to accompany clouds by Zenoh, if one has to."""
    options: TrackOptions = field(default_factory=TrackOptions)
    """What the track does beyond the paper's method."""


class Registry:
    """Opens, finds and closes sessions; its methods may be called from any thread."""

    def __init__(
        self,
        provider: NetworksProvider,
        store: SessionStore,
        transport: Transport,
        telemetry: Telemetry,
        codecs: Callable[[SessionRecord], Codecs],
        options: Callable[[SessionRecord], TrackerOptions],
        recordings: Recordings,
        *,
        max_sessions: int,
        frames_at_once: int,
        client_grace_s: float,
    ) -> None:
        self._provider = provider
        self._store = store
        self._transport = transport
        self._telemetry = telemetry
        self._codecs = codecs
        self._options = options
        self._recordings = recordings
        self._max_sessions = max_sessions
        self._turns = Turns(frames_at_once)
        self._client_grace_s = client_grace_s
        self._lock = threading.Lock()
        self._open: dict[str, tuple[Session, Stream]] = {}
        self._beginning = 0
        self._stopped = False

    def open(self, new: NewSession) -> Session:
        """Open a session.

        Raises:
            TooManySessionsError: the limit is reached.
            NotReadyError: the service stops.
            CategoryWithoutModelError: nothing tracks this category here.
            ModelNotLoadableError: its networks cannot be loaded.
            NotStoredError: it would not survive a restart, or cannot be recorded.
            RecordingsFullError: it cannot be recorded since there is no room.
        """
        session_id = secrets.token_hex(8)
        record = SessionRecord(
            session_id=session_id,
            category=new.category,
            profile=new.profile,
            frame_id=new.frame_id,
            idle_timeout_s=new.idle_timeout_s,
            created_ns=time.time_ns(),
            trusted=TrustedPose(new.pose, None),
            camera=new.camera,
            masks=new.masks,
            ros2=new.ros2(session_id),
            record=new.record,
            secret_sha256=new.secret_sha256,
            options=new.options,
        )
        with self._place():
            session = self._begin(record, self._recordings.start, Reporter.given)
        try:
            self._store.save(record)
        except StoreError as error:
            self.close(record.session_id, CloseReason.NOT_STORED)
            raise NotStoredError(str(error)) from error
        self._telemetry.session_opened()
        logger.info("session opened", extra={"session_id": record.session_id, "category": record.category})
        return session

    def restore(self) -> None:
        """Go on with every stored session that is not open, under its id and keys, from its last trusted pose."""
        for record in self._store.load():
            if self._is_open(record.session_id):  # it is in this process that it was opened
                continue
            about = {"session_id": record.session_id, "category": record.category}
            try:
                with self._place():
                    self._begin(record, self._recordings.go_on, Reporter.gone_on_with)
            except RejectedError as rejection:  # it stays stored: the next process may have its model
                logger.error("session not restored: %s", rejection, extra=about)
            else:
                self._telemetry.session_restored()
                logger.info("session restored", extra=about)

    def get(self, session_id: str) -> Session:
        """A session by its id.

        Raises:
            UnknownSessionError: there is none.
        """
        return self._find(session_id)[0]

    def sessions(self) -> Sequence[Session]:
        """All sessions, oldest first."""
        with self._lock:
            return [session for session, _ in self._open.values()]

    def count(self, state: State) -> int:
        """How many sessions are in a state."""
        return sum(session.last_result.state is state for session in self.sessions())

    def close(self, session_id: str, reason: CloseReason) -> None:
        """End a session: nothing more comes in, the frame in hand is finished, the client is told.

        Raises:
            UnknownSessionError: there is none.
        """
        with self._lock:
            session, stream = self._find_locked(session_id)
            del self._open[session_id]
        self._end(session, stream, reason)
        self._store.remove(session_id)

    def sweep(self) -> None:
        """End the sessions whose time is up, each on a thread of its own: a frame that hangs holds up no other."""
        for session in self.sessions():
            reason = session.liveness.expired()
            if reason is not None:
                name = f"captra-expiry-{session.session_id}"
                threading.Thread(target=self._expire, args=(session.session_id, reason), name=name, daemon=True).start()

    def _expire(self, session_id: str, reason: CloseReason) -> None:
        with suppress(UnknownSessionError):  # someone else closed it first, or the sweep before this one
            self.close(session_id, reason)

    def drain(self, timeout_s: float) -> None:
        """Take no more sessions and no more clouds by Zenoh, and finish the frames in hand.

        A session whose frame takes longer is left behind: it stays stored, as it was before that frame.
        """
        with self._lock:
            self._stopped = True
            entries = list(self._open.values())
        for _, stream in entries:
            stream.stop_receiving()
        end_s = time.monotonic() + timeout_s
        for session, stream in entries:  # by now the frames in hand finish side by side
            left_s = max(0.0, end_s - time.monotonic())
            if not (stream.finish(left_s) and session.wait_idle(left_s)):
                logger.error("session left behind in mid-frame", extra={"session_id": session.session_id})
                with self._lock:
                    self._open.pop(session.session_id, None)

    def shut_down(self) -> None:
        """End every session in this process; they stay stored, so that another can go on with them."""
        with self._lock:
            entries = list(self._open.values())
            self._open.clear()
            self._stopped = True
        for session, stream in entries:
            self._end(session, stream, CloseReason.SHUTDOWN)

    def _begin(
        self,
        record: SessionRecord,
        tape_of: Callable[[SessionRecord], Tape],
        first_result: Callable[[Reporter, Pose], Result],
    ) -> Session:
        engine = self._provider.get(record.category, record.profile)
        tape = tape_of(record)
        session = Session(
            record,
            engine,
            self._codecs(record),
            self._options(record),
            liveness=Liveness(record.idle_timeout_s, self._client_grace_s, client_awaited=record.has_client),
            ledger=Ledger(self._telemetry),
            store=self._store,
            turns=self._turns,
            tape=tape,
            first_result=first_result,
        )
        stream = self._transport.attach(session)
        try:
            with self._lock:
                self._check_not_stopped()
                self._open[record.session_id] = (session, stream)
        except RejectedError:
            stream.stop_receiving()
            stream.finish()
            stream.close()
            tape.close()
            raise
        stream.announce()
        return session

    def _end(self, session: Session, stream: Stream, reason: CloseReason) -> None:
        stream.stop_receiving()
        stream.finish()
        session.close(reason)
        stream.close()
        self._telemetry.session_closed(reason)
        logger.info("session closed", extra={"session_id": session.session_id, "reason": reason})

    @contextmanager
    def _place(self) -> Iterator[None]:
        """A place among the sessions, held while one begins: nothing has to be undone for want of it."""
        with self._lock:
            self._check_not_stopped()
            if len(self._open) + self._beginning >= self._max_sessions:
                raise TooManySessionsError(
                    f"{self._max_sessions} sessions are open, which is the limit: "
                    "DELETE one, wait until an idle one expires, or raise CAPTRA_MAX_SESSIONS"
                )
            self._beginning += 1
        try:
            yield
        finally:
            with self._lock:
                self._beginning -= 1

    def _check_not_stopped(self) -> None:
        if self._stopped:
            raise NotReadyError(STOPPING)

    def _is_open(self, session_id: str) -> bool:
        with self._lock:
            return session_id in self._open

    def _find(self, session_id: str) -> tuple[Session, Stream]:
        with self._lock:
            return self._find_locked(session_id)

    def _find_locked(self, session_id: str) -> tuple[Session, Stream]:
        try:
            return self._open[session_id]
        except KeyError:
            raise UnknownSessionError(
                f"no session {session_id[:100]!r} is open: it was closed, it expired, or it never was; POST a new one"
            ) from None

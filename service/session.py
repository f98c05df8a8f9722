"""One tracked object: its tracker, its last result, and the rules by which frames reach it."""

import logging
import threading
import time
from collections.abc import Callable
from dataclasses import replace

from captra.categories import Category
from captra.geometry import Pose
from captra.health import State
from captra.observations import Observation
from captra.sampling import NoPointsError
from captra.segmentation import Segmentation
from captra.tracker import TrackerOptions
from service.codecs import Codecs
from service.envelopes import Envelope, FrameHeader, NumberedHeader
from service.ledger import Ledger
from service.liveness import CloseReason, Liveness
from service.networks import Engine
from service.observer import Observer, Observers
from service.recording.tape import NO_TAPE, Tape
from service.rejections import (
    EmptyCloudError,
    InternalError,
    NoPointsNearObjectError,
    RejectedError,
    UnknownSessionError,
    WrongSecretError,
)
from service.reporter import Reporter
from service.results import Event, EventKind, Result
from service.security.secrets import admission_of
from service.sequence import Sequence
from service.store import SessionRecord, SessionStore, StoreError, TrustedPose
from service.turns import Turns

logger = logging.getLogger(__name__)

CLOSE_DETAILS = {
    CloseReason.DELETED: "a client closed the session",
    CloseReason.IDLE: "no frame came for as long as the session may be idle: open a new one",
    CloseReason.CLIENT_GONE: "the client's liveliness token is gone: open a new session",
    CloseReason.SHUTDOWN: "the service stops",
    CloseReason.NOT_STORED: "the session could not be stored",
}


class Session:
    """Frames in, results out, from any thread; frames, new poses and closing take turns."""

    def __init__(
        self,
        record: SessionRecord,
        engine: Engine,
        codecs: Codecs,
        options: TrackerOptions,
        *,
        liveness: Liveness,
        ledger: Ledger,
        store: SessionStore,
        turns: Turns,
        tape: Tape = NO_TAPE,
        first_result: Callable[[Reporter, Pose], Result] = Reporter.given,
    ) -> None:
        """`first_result` tells of the pose that it starts from."""
        self.record = record
        """Settings of the session, and the pose it started from."""
        self.liveness = liveness
        """When it ends by itself."""
        self.ledger = ledger
        """What became of its frames."""
        self.codecs = codecs
        """Encodings of clouds that it reads."""
        self.admission = admission_of(record.secret_sha256)
        """Who may put clouds."""
        self._category = engine.networks.category
        self._reporter = Reporter(record, engine.networks.category)
        self._tape = tape
        self._store = store
        self._turns = turns
        self._trusted = record.trusted
        self._started_from = record.trusted.pose
        self._tracker = engine.start(record.trusted.pose, options)
        self._sequence = Sequence.resumed(record.trusted.seq)
        self._observers = Observers()
        self._observers.add(tape)
        self._closed = False
        self._lock = threading.Lock()
        self._last_result = first_result(self._reporter, record.trusted.pose)

    @property
    def session_id(self) -> str:
        """Names the session in paths and keys."""
        return self.record.session_id

    @property
    def category(self) -> Category:
        """What is tracked."""
        return self._category

    @property
    def started_from(self) -> Pose:
        """Where the track began, or began again."""
        return self._started_from

    @property
    def last_result(self) -> Result:
        """The newest result; before the first one, the pose that it started from."""
        return self._last_result

    @property
    def last_seq(self) -> int | None:
        """Number of the last frame processed, which no refused one moves; none at the start and after a restart."""
        return self._sequence.last

    def client_there(self) -> None:
        """The client's liveliness token is there; the store remembers, so that its absence after a restart tells."""
        self.liveness.client_back()
        with self._lock:
            if self._closed or self.record.has_client:
                return
            self.record = replace(self.record, has_client=True)
            try:
                self._store.save(replace(self.record, trusted=self._trusted))
            except StoreError:
                logger.exception("client not stored", extra={"session_id": self.session_id})
            else:
                logger.info("client remembered", extra={"session_id": self.session_id})

    def observe(self, observer: Observer) -> None:
        """Tell `observer` too, from now on."""
        with self._lock:
            self._observers.add(observer)

    def unobserve(self, observer: Observer) -> None:
        """Tell `observer` no more."""
        with self._lock:
            self._observers.remove(observer)

    def process(self, envelope: Envelope) -> Result:
        """Track the object in one more cloud.

        Raises:
            FrameRejectedError: the cloud cannot be used; the session stays as it was, and its observer knows why.
            UnknownSessionError: the session is closed.
        """
        self._arrived()
        started_s = time.perf_counter()
        header: FrameHeader | None = None
        try:
            frame, mask = self.codecs.open(envelope)
            header = frame.header
            observation = frame.observe()
            segmentation = self.codecs.segmentation(mask, observation)
            decoded_s = time.perf_counter()
            with self._lock, self._turns:
                waited_s = (started_s - envelope.arrived_s) + (time.perf_counter() - decoded_s)
                self.ledger.spent(decode=1e3 * (decoded_s - started_s))
                header = self._numbered(header)
                self._tape.frame(header, envelope, mask, observation)
                return self._step(header, observation, segmentation, envelope, waited_s)
        except UnknownSessionError:
            raise
        except RejectedError as rejection:
            self._reject(rejection, header)
            raise
        except Exception as error:
            logger.exception("a frame met a defect", extra={"session_id": self.session_id})
            defect = InternalError("the service failed on this frame and its log tells why; send the next one")
            self._reject(defect, header)
            raise defect from error

    def refuse(self, rejection: RejectedError) -> None:
        """Count and tell of a frame that is refused before it was read."""
        self._arrived()
        self._reject(rejection, None)

    def turn_away(self, rejection: WrongSecretError) -> None:
        """Count and tell of a cloud from a stranger, who does not keep the session alive."""
        self.ledger.received()
        self._reject(rejection, None)

    def reset(self, pose: Pose) -> Result:
        """Start again from a pose that a client gives; frames may be numbered anew.

        Raises:
            UnknownSessionError: the session is closed.
        """
        with self._lock:
            self._check_open()
            self.liveness.touch()
            self._tracker.reset(pose)
            self._started_from = pose
            self._tape.reset(pose)
            self._sequence.restart()
            self._trust(TrustedPose(pose, None))
            previous, self._last_result = self._last_result.state, self._reporter.given(pose)
            self._tell(EventKind.RESET, previous)
            return self._last_result

    def refuse_pose(self, rejection: RejectedError) -> None:
        """Tell of a pose that cannot be started from."""
        with self._lock:
            self._tell(
                EventKind.POSE_REJECTED, self._last_result.state, reason=rejection.reason, detail=rejection.detail
            )

    def wait_idle(self, timeout_s: float) -> bool:
        """Wait until no frame is in hand; whether that came about within `timeout_s`."""
        idle = self._lock.acquire(timeout=timeout_s)
        if idle:
            self._lock.release()
        return idle

    def close(self, reason: CloseReason) -> None:
        """Finish the frame in hand and take no more."""
        with self._lock:
            self._tell(EventKind.CLOSING, self._last_result.state, reason=reason, detail=CLOSE_DETAILS[reason])
            self._closed = True
        self._tape.close()

    def _arrived(self) -> None:
        self.liveness.touch()
        self.ledger.received()

    def _check_open(self) -> None:
        if self._closed:
            raise UnknownSessionError(f"session {self.session_id} is closed: open a new one")

    def _numbered(self, header: FrameHeader) -> NumberedHeader:
        seq = self._sequence.next() if header.seq is None else header.seq
        return NumberedHeader(seq, header.stamp_ns, header.frame_id)

    def _step(
        self,
        header: NumberedHeader,
        observation: Observation,
        segmentation: Segmentation,
        envelope: Envelope,
        waited_s: float,
    ) -> Result:
        self._check_open()
        self._sequence.check(header.seq)
        self._observers.cloud(header, observation)
        try:
            tracked = self._tracker.step(observation, segmentation, 1e-9 * header.stamp_ns, envelope.looks)
        except NoPointsError as error:
            self._saw_nothing(header)
            raise nothing_seen(observation, str(error), self._tracker.looks) from error
        dropped = self._sequence.accept(header.seq)
        total_s = time.perf_counter() - envelope.arrived_s
        result = self._reporter.tracked(tracked, header, self._tracker.looks, 1e3 * waited_s, 1e3 * total_s)
        if tracked.state is State.TRACKING:
            self._trust(TrustedPose(self._tracker.pose, header.seq))
        previous, self._last_result = self._last_result.state, result
        self.ledger.processed(result.confidence, dropped)
        self._publish(result, previous)
        return result

    def _saw_nothing(self, header: NumberedHeader) -> None:
        """Tell when so many frames held nothing near the object that the track is in doubt, or lost."""
        health, previous = self._tracker.health, self._last_result
        if health.state in (State.TRACKING, previous.state):  # a track that was gone on with is in doubt from the start
            return
        self._last_result = self._reporter.unseen(previous, header, health.state, self._tracker.looks)
        self._observers.result(self._last_result)
        self._tell_state(previous.state)

    def _trust(self, trusted: TrustedPose) -> None:
        self._trusted = trusted
        self._store.trust(self.session_id, trusted)

    def _publish(self, result: Result, previous: State) -> None:
        started_s = time.perf_counter()
        self._observers.result(result)
        timing = result.timing_ms
        self.ledger.spent(
            queue=timing.queue,
            sample=timing.sample,
            infer=timing.infer,
            solve=timing.solve,
            publish=1e3 * (time.perf_counter() - started_s),
            total=timing.total,
        )
        if result.state is not previous:
            self._tell_state(previous)

    def _tell_state(self, previous: State) -> None:
        result = self._last_result
        logger.info("state changed", extra={"session_id": self.session_id, "from": previous, "to": result.state})
        self._tell(EventKind.STATE, previous, seq=result.seq, stamp_ns=result.stamp_ns)

    def _reject(self, rejection: RejectedError, header: FrameHeader | None) -> None:
        with self._lock:
            if self._closed:
                return
            self.ledger.rejected(rejection.reason)
            seq, stamp_ns = (None, None) if header is None else (header.seq, header.stamp_ns)
            if not isinstance(rejection, WrongSecretError):  # a stranger's numbers are none of this session's
                self._sequence.reject(seq)
            logger.debug("frame rejected", extra={"session_id": self.session_id, "reason": rejection.reason})
            state = self._last_result.state
            self._tell(
                EventKind.REJECTED,
                state,
                seq=seq,
                stamp_ns=stamp_ns,
                reason=rejection.reason,
                detail=rejection.detail,
                looks=rejection.looks,
            )

    def _tell(
        self,
        kind: EventKind,
        previous: State,
        *,
        seq: int | None = None,
        stamp_ns: int | None = None,
        reason: str | None = None,
        detail: str | None = None,
        looks: int | None = None,
    ) -> None:
        state = self._last_result.state
        self._observers.event(Event(kind, self.session_id, state, previous, seq, stamp_ns, reason, detail, looks))


def nothing_seen(observation: Observation, detail: str, looks: int) -> RejectedError:
    """Why a frame shows no object, which the track has been told: there are no points at all, or none near it."""
    if 0 in observation.shape:
        return EmptyCloudError("the cloud has no points: send at least those around the object", looks)
    return NoPointsNearObjectError(detail, looks)

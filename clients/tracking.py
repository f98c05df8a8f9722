"""Two ways to send a sequence of clouds: each after the result of the one before, or at a camera's rate."""

import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from clients.errors import FrameRejectedError, NoResultError, SessionClosedError
from clients.inbox import Inbox
from clients.packing import Frame, Observation
from clients.regions import Region
from clients.results import Event, Result

STRANGERS = "wrong-secret"
"""Why clouds are rejected that somebody else put on this session's key."""


@dataclass(frozen=True)
class Fed:
    """Says to the reader that all clouds have been put."""

    last_seq: int
    """Number of the last one; -1 when there was none."""
    error: Exception | None = None
    """What the source of the clouds raised."""


Message = Result | Event | Fed


UNSEEN = frozenset({"no-points-near-object", "empty-cloud"})
"""Why clouds are rejected that show nothing of the object: the tracker has tried them, and results tell of a loss."""


def raise_rejections(event: Event) -> None:
    """Turn the rejection of a cloud into an exception; those of strangers' clouds are none of ours."""
    if event.kind == "rejected" and event.reason != STRANGERS:
        raise FrameRejectedError(event.seq, event.reason, event.detail)


@dataclass(frozen=True)
class Line:
    """The way to the service and back."""

    put: Callable[[Observation, int | None, Region | None], int]
    """Sends what was seen with its stamp and mask, returns its number."""
    inbox: Inbox[Message]
    """What comes back."""
    on_event: Callable[[Event], None]
    """Called with every event."""
    timeout_s: float
    """The longest wait for anything."""
    first_seq: int = 0
    """Number of the first cloud of this line; what still comes of earlier ones is nobody's any more."""

    def send(self, seen: Observation | Frame) -> int:
        """Put what was seen, with its stamp and mask where it has them."""
        return self.put(*(seen if isinstance(seen, Frame) else Frame(seen)))

    def next(self, waiting_for: str) -> Message:
        """The next message; events have been handled when it returns.

        Raises:
            NoResultError: nothing came in time.
            SessionClosedError: the service closed the session.
        """
        message = self.inbox.get(self.timeout_s)
        while message is not None and 0 <= answered_seq(message, unnumbered=-1) < self.first_seq:
            message = self.inbox.get(self.timeout_s)
        if message is None:
            raise NoResultError(f"no result of {waiting_for} within {self.timeout_s:g} s: is the service overloaded?")
        if isinstance(message, Event):
            if message.kind == "closing":
                raise SessionClosedError(f"the service closed the session: {message.detail} ({message.reason})")
            self.on_event(message)
        return message


def answered_seq(message: Message, unnumbered: int) -> int:
    """Number of the cloud that a message answers; `unnumbered` for a cloud refused unread; -1 when it answers none."""
    match message:
        case Event(reason=reason) if reason == STRANGERS:
            return -1
        case Result(seq=seq) | Event(kind="rejected", seq=int(seq)):
            return seq
        case Event(kind="rejected"):
            return unnumbered
    return -1


def in_turn(line: Line, clouds: Iterable[Observation | Frame]) -> Iterator[Result]:
    """Put each cloud when the one before has been answered."""
    for cloud in clouds:
        seq = line.send(cloud)
        answered = -1
        while answered < seq:
            message = line.next(f"frame {seq}")
            answered = answered_seq(message, unnumbered=seq)
            if isinstance(message, Result) and answered >= seq:
                yield message


def at_rate(line: Line, clouds: Iterable[Observation | Frame], rate_hz: float) -> Iterator[Result]:
    """Put clouds from a thread of their own at a steady rate, and yield what comes back meanwhile."""
    stopped = threading.Event()
    feeder = threading.Thread(target=feed, args=(line, clouds, 1 / rate_hz, stopped), name="captra-feeder", daemon=True)
    feeder.start()
    answered, awaited = -1, None
    try:
        while awaited is None or answered < awaited:
            message = line.next(f"frame {answered + 1} or later")
            if isinstance(message, Fed):
                if message.error is not None:
                    raise message.error
                awaited = message.last_seq
                continue
            answered = max(answered, answered_seq(message, unnumbered=-1))
            if isinstance(message, Result):
                yield message
    finally:
        stopped.set()
        feeder.join(line.timeout_s)


def feed(line: Line, clouds: Iterable[Observation | Frame], period_s: float, stopped: threading.Event) -> None:
    """Put clouds on their beat, counted from the first one so that delays do not add up; ends with a `Fed` message."""
    seq, started = -1, None
    try:
        for index, cloud in enumerate(clouds):
            started = time.perf_counter() if started is None else started
            if stopped.wait(max(0.0, started + index * period_s - time.perf_counter())):
                return
            seq = line.send(cloud)
    except Exception as error:  # noqa: BLE001  handed to the reader, who raises it
        line.inbox.put(Fed(seq, error))
    else:
        line.inbox.put(Fed(seq))

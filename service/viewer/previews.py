"""Clouds of no session yet: whatever clients put on preview keys while somebody looks, or while a session is fed."""

import threading
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial

from captra.observations import Observation
from service.envelopes import Envelope, NumberedHeader
from service.rejections import UnknownSessionError
from service.results import Event, EventKind, Result
from service.tracking_service import TrackingService

MOST_PREVIEWS = 16
"""Names that are remembered; further ones are not listed."""

Take = Callable[[Envelope], None]


@dataclass(frozen=True)
class Fed:
    """A session that tracks a preview."""

    session_id: str
    """Its name."""
    secret: bytes
    """What its clouds' attachments end with; nothing where anybody may put clouds."""

    def sealed(self, envelope: Envelope) -> Envelope:
        """A cloud as the session takes it."""
        return replace(envelope, attachment=(envelope.attachment or b"") + self.secret or None)


@dataclass(frozen=True)
class UntilClosed:
    """Observes a session for its end only."""

    end: Callable[[], None]
    """Called then."""

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """Nothing to do."""

    def result(self, result: Result) -> None:
        """Nothing to do."""

    def event(self, event: Event) -> None:
        """Whether that was it."""
        if event.kind is EventKind.CLOSING:
            self.end()


class Previews:
    """Subscribes while it is needed, keeps the newest cloud of each name, and feeds sessions that were opened on one.

    Its methods may be called from any thread.
    """

    def __init__(self, service: TrackingService) -> None:
        self._service = service
        self._lock = threading.RLock()
        self._subscription: ExitStack | None = None
        self._viewers = 0
        self._newest: dict[str, Envelope] = {}
        self._listeners: dict[str, tuple[Take, ...]] = {}
        self._fed: dict[str, tuple[Fed, ...]] = {}

    def names(self) -> list[str]:
        """Previews that clouds came from."""
        return sorted(self._newest)

    def open(self) -> None:
        """One more viewer is there."""
        with self._lock:
            self._viewers += 1
            self._adjust()

    def close(self) -> None:
        """One viewer less."""
        with self._lock:
            self._viewers -= 1
            self._adjust()

    def listen(self, name: str, take: Take) -> None:
        """Call `take` with the newest cloud, if there is one, and all further ones."""
        with self._lock:
            self._listeners[name] = (*self._listeners.get(name, ()), take)
            newest = self._newest.get(name)
        if newest is not None:
            take(newest)

    def unlisten(self, name: str, take: Take) -> None:
        """Call `take` no more."""
        with self._lock:
            self._listeners[name] = tuple(each for each in self._listeners.get(name, ()) if each != take)

    def feed(self, name: str, session_id: str, secret: bytes) -> None:
        """Put every further cloud of a preview on a session's key too, until it is fed another or closed.

        Raises:
            UnknownSessionError: no such session is open.
        """
        session = self._service.registry.get(session_id)
        session.observe(UntilClosed(partial(self._end_feeding, session_id)))
        with self._lock:
            self._starve(session_id)
            self._fed[name] = (*self._fed.get(name, ()), Fed(session_id, secret))
            self._adjust()
        try:
            self._service.registry.get(session_id)
        except UnknownSessionError:  # it was closed meanwhile, perhaps before there was anything to end
            self._end_feeding(session_id)
            raise

    def _end_feeding(self, session_id: str) -> None:
        with self._lock:
            self._starve(session_id)
            self._adjust()

    def _starve(self, session_id: str) -> None:
        """Feed a session nothing."""
        fed = {name: tuple(each for each in all_ if each.session_id != session_id) for name, all_ in self._fed.items()}
        self._fed = {name: left for name, left in fed.items() if left}

    def _adjust(self) -> None:
        needed = self._viewers > 0 or bool(self._fed)
        if needed and self._subscription is None:
            self._subscription = self._service.transport.subscribe_previews(self._take)
        elif not needed and self._subscription is not None:
            self._subscription.close()
            self._subscription = None
            self._newest.clear()

    def _take(self, name: str, envelope: Envelope) -> None:
        with self._lock:
            if self._subscription is None:
                return  # it came before the end of the subscription, and waited
            if name not in self._newest and len(self._newest) >= MOST_PREVIEWS:
                return
            self._newest[name] = envelope
            listeners, fed = self._listeners.get(name, ()), self._fed.get(name, ())
        for take in listeners:
            take(envelope)
        for each in fed:
            key = self._service.transport.keys(each.session_id).cloud
            self._service.transport.put(key, each.sealed(envelope))

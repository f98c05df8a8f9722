"""One session on Zenoh: the newest cloud in, results and events out."""

import logging
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import replace

import zenoh
from zenoh import ext

from captra.observations import Observation
from service.announcer import Announcer
from service.envelopes import Envelope, NumberedHeader
from service.feeds import Feed, arrival_s
from service.keys import SessionKeys
from service.rejections import RejectedError, UnknownSessionError, WrongSecretError
from service.results import Event, Result
from service.session import Session

logger = logging.getLogger(__name__)


def declare_poses(zenoh_session: zenoh.Session, key: str) -> ext.AdvancedPublisher:
    """Results: sent at once, never waited for, the last one kept for those who subscribe later."""
    return ext.declare_advanced_publisher(
        zenoh_session,
        key,
        encoding=zenoh.Encoding.APPLICATION_JSON,
        reliability=zenoh.Reliability.RELIABLE,
        congestion_control=zenoh.CongestionControl.DROP,
        priority=zenoh.Priority.INTERACTIVE_HIGH,
        express=True,
        cache=ext.CacheConfig(1),
        publisher_detection=True,
    )


def declare_events(zenoh_session: zenoh.Session, key: str) -> zenoh.Publisher:
    """Events: never dropped on the way; of a priority that poses overtake, so that none waits behind one of them."""
    return zenoh_session.declare_publisher(
        key,
        encoding=zenoh.Encoding.APPLICATION_JSON,
        reliability=zenoh.Reliability.RELIABLE,
        congestion_control=zenoh.CongestionControl.BLOCK,
        priority=zenoh.Priority.DATA,
    )


def withdraw(publisher: zenoh.Publisher) -> None:
    """Undeclare a publisher, unless its Zenoh session was closed before."""
    with suppress(zenoh.ZError):
        publisher.undeclare()


def envelope_of(sample: zenoh.Sample, arrived_s: float) -> Envelope:
    """A cloud as Zenoh brought it."""
    attachment = sample.attachment
    return Envelope(
        encoding=str(sample.encoding),
        payload=sample.payload.to_bytes(),
        attachment=None if attachment is None else attachment.to_bytes(),
        arrived_s=arrived_s,
    )


class SessionStream:
    """Observes a session and feeds it: a thread of its own takes the newest cloud whenever the last one is done."""

    def __init__(
        self, zenoh_session: zenoh.Session, keys: SessionKeys, session: Session, on_close: Callable[[], object]
    ) -> None:
        self._zenoh_session = zenoh_session
        self._keys = keys
        self._session = session
        self._router_id = str(zenoh_session.zid())
        with ExitStack() as resources:
            resources.callback(on_close)
            self._poses = resources.enter_context(declare_poses(zenoh_session, keys.pose))
            events = declare_events(zenoh_session, keys.event)
            self._announcer = Announcer(
                lambda event: self._put(events, event),
                on_drop=session.ledger.event_dropped,
                on_end=lambda: withdraw(events),
                name=session.session_id,
            )
            resources.callback(self._announcer.close)
            session.observe(self)
            self._clouds = Feed(zenoh_session, keys.cloud, self._take, f"captra-stream-{session.session_id}")
            self._resources = resources.pop_all()

    def announce(self) -> None:
        """Declare the token that is there as long as the session."""
        self._resources.enter_context(self._zenoh_session.liveliness().declare_token(self._keys.alive))

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """Clients know their clouds."""

    def result(self, result: Result) -> None:
        """Put a result."""
        self._put(self._poses, result)

    def event(self, event: Event) -> None:
        """Put an event, soon."""
        self._announcer.put(event)

    def stop_receiving(self) -> None:
        """Take no more clouds."""
        self._clouds.stop()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the one in hand; whether it was done within `timeout_s`, if that is given."""
        return self._clouds.finish(timeout_s)

    def close(self) -> None:
        """Withdraw the keys."""
        self._resources.close()

    def _put(self, publisher: zenoh.Publisher | ext.AdvancedPublisher, message: Result | Event) -> None:
        try:
            publisher.put(message.to_json())
        except zenoh.ZError:  # the frame itself is done; a network that is gone must not undo it
            logger.exception("could not publish", extra={"session_id": message.session_id})

    def _take(self, sample: zenoh.Sample) -> None:
        try:
            self._session.codecs.check_size(len(sample.payload))
        except RejectedError as rejection:
            self._session.refuse(rejection)
            return
        envelope = envelope_of(sample, arrival_s(sample, self._router_id))
        try:
            admitted = self._session.admission.admit(envelope.attachment)
        except WrongSecretError as rejection:
            self._session.turn_away(rejection)
            return
        try:
            self._session.process(replace(envelope, attachment=admitted))
        except UnknownSessionError:
            logger.debug("cloud for a closed session", extra={"session_id": self._session.session_id})
        except RejectedError:
            pass  # counted, and told as an event

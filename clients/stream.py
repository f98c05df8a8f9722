"""The Zenoh side of a session: clouds out, results and events in."""

import json
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from threading import Event, Thread
from typing import Any

import zenoh

from clients.clouds import attachment
from clients.credentials import Credentials
from clients.errors import ServiceUnreachableError
from clients.packing import Packed
from clients.rest import OpenedSession

LONGEST_BACKLOG = 256
"""Samples that may wait for this process; older ones go."""

RETRY = {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}
"""How soon a service that was restarted is found again."""

Receive = Callable[[bytes], None]


class CloudStream:
    """A Zenoh session for one tracking session; open it with `with`."""

    def __init__(self, opened: OpenedSession, on_result: Receive, on_event: Receive) -> None:
        self._opened = opened
        self._on_result = on_result
        self._on_event = on_event
        self._resources = ExitStack()

    def open(self, timeout_s: float) -> None:
        """Connect, listen, and wait until the service listens too, so that the first cloud is not lost.

        Raises:
            ServiceUnreachableError: nothing listens within `timeout_s`.
        """
        opened = self._opened
        with ExitStack() as resources:
            session = resources.enter_context(connect(opened.endpoints, timeout_s))
            resources.enter_context(listen(session, opened.pose_key, self._on_result))
            resources.enter_context(listen(session, opened.event_key, self._on_event))
            resources.enter_context(session.liveliness().declare_token(opened.token_key))
            self._publisher = resources.enter_context(
                session.declare_publisher(
                    opened.cloud_key,
                    congestion_control=zenoh.CongestionControl.DROP,
                    reliability=zenoh.Reliability.BEST_EFFORT,
                    express=True,
                )
            )
            wait_for_subscriber(self._publisher, timeout_s)
            self._resources = resources.pop_all()

    def put(self, packed: Packed, seq: int, stamp_ns: int) -> None:
        """Send one frame; it is dropped rather than kept waiting when the network is congested."""
        self._publisher.put(
            packed.payload,
            encoding=packed.media_type,
            attachment=attachment(seq, stamp_ns) + packed.region + self._opened.secret,
        )

    def close(self) -> None:
        """Withdraw the liveliness token, stop listening and disconnect."""
        self._resources.close()


def connect(endpoints: tuple[str, ...], timeout_s: float) -> zenoh.Session:
    """Connect to a router as a client, without looking for others on the network.

    Raises:
        ServiceUnreachableError: none of the endpoints answers within `timeout_s`.
    """
    config = zenoh.Config()
    config.insert_json5("mode", '"client"')
    config.insert_json5("connect/endpoints", json.dumps(endpoints))
    config.insert_json5("connect/timeout_ms", str(int(1e3 * timeout_s)))
    config.insert_json5("connect/retry", json.dumps(RETRY))
    config.insert_json5("scouting/multicast/enabled", "false")
    for key, value in Credentials.from_environment().zenoh_entries.items():
        config.insert_json5(key, json.dumps(value))
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        raise ServiceUnreachableError(
            f"no Zenoh router answers at {', '.join(endpoints)}: check that these addresses, which the service gave, "
            "can be reached from here, and set CAPTRA_ZENOH_LISTEN where the service runs"
        ) from error


@contextmanager
def listen(session: zenoh.Session, key: str, receive: Receive) -> Iterator[None]:
    """Hand every payload that comes on `key` to `receive`, from a thread that keeps no interpreter from ending."""
    with session.declare_subscriber(key, zenoh.handlers.RingChannel(LONGEST_BACKLOG)) as subscriber:

        def drain() -> None:
            for sample in subscriber:
                receive(sample.payload.to_bytes())

        Thread(target=drain, name=f"captra-listen-{key}", daemon=True).start()
        yield


def wait_for_subscriber(publisher: zenoh.Publisher, timeout_s: float) -> None:
    """Wait until someone subscribes to what `publisher` puts.

    Raises:
        ServiceUnreachableError: when nobody does within `timeout_s`.
    """
    matched = Event()

    def notice(status: zenoh.MatchingStatus) -> None:
        if status.matching:
            matched.set()

    with publisher.declare_matching_listener(notice):
        status: Any = publisher.matching_status  # its type says that it is a bool, which it is not
        if not (status.matching or matched.wait(timeout_s)):
            raise ServiceUnreachableError(
                f"nobody listens on {publisher.key_expr}: the service's Zenoh router is reached, "
                "but the session is not there; open it again"
            )

"""The embedded Zenoh router that sessions are reached by."""

import json
import logging
import re
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from types import MappingProxyType
from typing import Any

import zenoh

from service.envelopes import Envelope
from service.keys import ServiceKeys, SessionKeys
from service.ros2.node import NO_ROS2, Ros2
from service.session import Session
from service.streams import SessionStream, envelope_of
from service.transport import Stream, TransportError

logger = logging.getLogger(__name__)


def router_config(
    listen: tuple[str, ...], max_message_bytes: int, further: Mapping[str, Any] = MappingProxyType({})
) -> zenoh.Config:
    """A router that listens where it is told and looks for nobody."""
    config = zenoh.Config()
    entries = {
        "mode": "router",
        "listen/endpoints": listen,
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": False,
        "scouting/delay": 0,  # nobody to wait for
        # Each client on this machine would have 16 MiB mapped here, and left mapped when it goes.
        "transport/shared_memory/enabled": False,
        "transport/link/rx/max_message_size": max_message_bytes,
        "transport/link/tx/queue/size/interactive_high": 16,  # results of many sessions to one subscriber, the most
    }
    for key, value in (entries | dict(further)).items():
        config.insert_json5(key, json.dumps(value))
    return config


PLACE = re.compile(r" at /\S+?\.rs:\d+\.*")
"""Names files of the machine that Zenoh was built on."""


class ZenohTransport:
    """The service's Zenoh router; open it before sessions are attached, close it after they are gone."""

    def __init__(
        self,
        service: str,
        listen: tuple[str, ...],
        advertise: tuple[str, ...],
        max_payload_bytes: int,
        entries: Mapping[str, Any] = MappingProxyType({}),
        ros2: Ros2 = NO_ROS2,
    ) -> None:
        """`entries` are further ones of Zenoh's configuration: other routers, certificates and access rules."""
        self._keys = ServiceKeys(service)
        self._listen = listen
        self._endpoints = advertise or listen
        self._max_payload_bytes = max_payload_bytes
        self._max_message_bytes = (
            4 * max_payload_bytes
        )  # what is only somewhat too large gets a reason instead of silence
        self._entries = dict(ros2.router_entries) | dict(entries)
        self._ros2 = ros2
        self._resources = ExitStack()
        self._sessions: dict[str, Session] = {}  # by the keys of their clients' tokens
        self._tokens: set[str] = set()
        self._lock = threading.Lock()

    @property
    def endpoints(self) -> tuple[str, ...]:
        """Where clients connect to."""
        return self._endpoints

    def keys(self, session_id: str) -> SessionKeys:
        """Where a session is reached."""
        return self._keys.session(session_id)

    def open(self) -> None:
        """Listen.

        Raises:
            TransportError: when an endpoint is in use or makes no sense.
        """
        try:
            config = router_config(self._listen, self._max_message_bytes, self._entries)
            self._session = self._resources.enter_context(zenoh.open(config))
        except zenoh.ZError as error:
            raise TransportError(
                f"cannot listen for Zenoh on {', '.join(self._listen)}: {without_places(str(error))}. "
                "Stop what uses the endpoint, or choose another with CAPTRA_ZENOH_LISTEN"
            ) from error
        liveliness = self._session.liveliness()
        self._resources.enter_context(liveliness.declare_token(self._keys.alive))
        self._resources.enter_context(
            liveliness.declare_subscriber(self._keys.clients, self._client_changed, history=True)
        )
        self._ros2.open(self._session)
        self._resources.callback(self._ros2.close)

    def attach(self, session: Session) -> Stream:
        """Connect a session, without telling others of it yet."""
        keys = self.keys(session.session_id)
        with self._lock:
            self._sessions[keys.client] = session
            client_there = keys.client in self._tokens  # after a restart clients come back before their sessions
        if client_there:
            session.client_there()
        stream = SessionStream(self._session, keys, session, on_close=lambda: self._sessions.pop(keys.client, None))
        return self._ros2.beside(stream, session)

    def subscribe_previews(self, take: Callable[[str, Envelope], None]) -> ExitStack:
        """Call `take`, on a thread of its own, with the name and the cloud of whatever comes on preview keys.

        `take` may close the stack: Zenoh waits for no callback that runs on such a thread.
        """

        def receive(sample: zenoh.Sample) -> None:
            if sample.kind == zenoh.SampleKind.PUT and len(sample.payload) <= self._max_payload_bytes:
                take(str(sample.key_expr).rpartition("/")[2], envelope_of(sample, time.perf_counter()))

        subscription = ExitStack()
        subscription.enter_context(self._session.declare_subscriber(f"{self._keys.previews}/*", receive))
        return subscription

    def put(self, key: str, envelope: Envelope) -> None:
        """Put a cloud, as a client would."""
        self._session.put(
            key,
            envelope.payload,
            encoding=zenoh.Encoding(envelope.encoding),
            attachment=envelope.attachment,
            congestion_control=zenoh.CongestionControl.DROP,
        )

    def close(self) -> None:
        """Stop listening."""
        self._resources.close()

    def _client_changed(self, sample: zenoh.Sample) -> None:
        key, there = str(sample.key_expr), sample.kind == zenoh.SampleKind.PUT
        with self._lock:
            (self._tokens.add if there else self._tokens.discard)(key)
            session = self._sessions.get(key)
        if session is None:
            return
        if there:
            session.liveness.client_back()
            name = f"captra-client-{session.session_id}"  # a frame that hangs must not keep others' tokens waiting
            threading.Thread(target=session.client_there, name=name, daemon=True).start()
        else:
            logger.info("client token gone", extra={"session_id": session.session_id})
            session.liveness.client_gone()


def without_places(message: str) -> str:
    """An error of Zenoh without the lines of its source where it arose."""
    return PLACE.sub("", message).rstrip(".")

"""The service as a node of ROS 2, or not."""

import itertools
import threading
from collections.abc import Mapping
from contextlib import ExitStack
from types import MappingProxyType
from typing import Any, Protocol

import zenoh

from service.ros2.messages import TRANSFORMS
from service.ros2.names import Domain, Topic
from service.ros2.options import Ros2Options, default_name
from service.ros2.publisher import TopicPublisher
from service.ros2.stream import Ros2Stream
from service.session import Session
from service.transport import Stream, Streams

NODE = "captra"
"""Name of the node, in the root namespace."""
TF = Topic("/tf", TRANSFORMS, depth=100)
ROUTER_ENTRIES: Mapping[str, Any] = MappingProxyType(
    {
        # What rmw_zenoh's own router does: nodes on one machine find each other through it and then talk directly.
        "scouting/gossip/enabled": True,
        "scouting/gossip/multihop": False,
        "scouting/gossip/target": {"router": ["router", "peer"], "peer": ["router"]},
    }
)
"""What makes the service's router one that rmw_zenoh nodes can use in the place of rmw_zenohd."""


class Ros2(Protocol):
    """What the transport does for ROS 2 beside its own keys."""

    @property
    def router_entries(self) -> Mapping[str, Any]:
        """Further entries of the router's configuration."""

    def open(self, zenoh_session: zenoh.Session) -> None:
        """Appear, once the router listens."""

    def beside(self, stream: Stream, session: Session) -> Stream:
        """A session's stream, and whatever ROS 2 adds to it."""

    def close(self) -> None:
        """Disappear, after all streams are closed."""


class NoRos2:
    """The service has nothing to do with ROS 2."""

    router_entries: Mapping[str, Any] = MappingProxyType({})

    def open(self, zenoh_session: zenoh.Session) -> None:
        """Nothing to do."""

    def beside(self, stream: Stream, session: Session) -> Stream:  # noqa: ARG002 - the protocol names it
        """The stream as it is."""
        return stream

    def close(self) -> None:
        """Nothing to do."""


NO_ROS2: Ros2 = NoRos2()


class Ros2Node:
    """A node that publishes /tf, and boxes and joints of every session."""

    router_entries = ROUTER_ENTRIES

    def __init__(self, domain: Domain, points_topic: str | None) -> None:
        """`points_topic` feeds sessions that name none."""
        self._domain = domain
        self._points_topic = points_topic
        self._entities = itertools.count(1)  # the node itself is number zero
        self._lock = threading.Lock()
        self._resources = ExitStack()

    def open(self, zenoh_session: zenoh.Session) -> None:
        """Announce the node and /tf."""
        self._session = zenoh_session
        token = self._domain.node_token(str(zenoh_session.zid()), NODE)
        self._resources.enter_context(zenoh_session.liveliness().declare_token(token))
        self._tf = TopicPublisher(zenoh_session, self._domain, NODE, self._next_entity(), TF)
        self._resources.callback(self._tf.close)

    def beside(self, stream: Stream, session: Session) -> Stream:
        """The stream, and the session's topics."""
        record = session.record
        options = record.ros2 or Ros2Options(default_name(record.category, record.session_id), self._points_topic)
        topics = Ros2Stream(self._session, self._domain, NODE, self._next_entity, self._tf, session, options)
        return Streams((stream, topics))

    def close(self) -> None:
        """Withdraw the node."""
        self._resources.close()

    def _next_entity(self) -> int:
        with self._lock:
            return next(self._entities)

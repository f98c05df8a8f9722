"""One topic of ROS 2 on its way out: as rmw_zenoh and as zenoh-bridge-ros2dds put it."""

import hashlib
import threading
import time
from contextlib import ExitStack

import zenoh

from service.ros2.attachments import GID_BYTES, RmwAttachment
from service.ros2.names import Domain, Topic


class TopicPublisher:
    """Announces a topic and puts its messages in both forms; messages may come from any thread."""

    def __init__(self, zenoh_session: zenoh.Session, domain: Domain, node: str, entity: int, topic: Topic) -> None:
        """`entity` is the publisher's number in the Zenoh session."""
        token = domain.topic_token(str(zenoh_session.zid()), node, entity, "MP", topic)
        self._gid = hashlib.blake2b(token.encode(), digest_size=GID_BYTES).digest()
        self._seq = 0
        self._lock = threading.Lock()
        with ExitStack() as resources:
            self._rmw, self._bridge = (
                resources.enter_context(declare(zenoh_session, key))
                for key in (domain.publisher_key(topic), topic.bridge_key)
            )
            resources.enter_context(zenoh_session.liveliness().declare_token(token))
            self._resources = resources.pop_all()

    def put(self, message: bytes) -> None:
        """Publish one message in CDR; it is dropped rather than waited with where a subscriber is too slow."""
        with self._lock:
            self._seq += 1  # rmw_zenoh counts from one
            attachment = RmwAttachment(self._seq, time.time_ns(), self._gid).pack()
            self._rmw.put(message, attachment=attachment)
            self._bridge.put(message)

    def close(self) -> None:
        """Withdraw the topic."""
        self._resources.close()


def declare(zenoh_session: zenoh.Session, key: str) -> zenoh.Publisher:
    """A publisher with the quality of poses."""
    return zenoh_session.declare_publisher(
        key,
        reliability=zenoh.Reliability.RELIABLE,
        congestion_control=zenoh.CongestionControl.DROP,
        priority=zenoh.Priority.INTERACTIVE_HIGH,
        express=True,
    )

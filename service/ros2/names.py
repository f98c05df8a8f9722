"""Names of ROS 2 topics, and the keys and tokens that they become on Zenoh.

rmw_zenoh writes domain, type and hash into the key of a topic and announces every node, publisher and subscription by a
liveliness token (its docs/design.md); zenoh-bridge-ros2dds takes the topic's name for the key.
"""

import re
from dataclasses import dataclass

from service.ros2.messages import type_hash

ANY_HASH = "*"
NO_HASH = "TypeHashNotSupported"
"""What distributions without type hashes (Humble) write in their place."""
QOS_DEPTH = "::,{depth}:,:,:,,"
"""Reliable, volatile, the last so many: all but the depth is what rmw_zenoh takes for granted."""
TOPIC = re.compile(r"(/[A-Za-z_][A-Za-z0-9_]*)+")


class TopicNameError(ValueError):
    """No name of a topic; says what one looks like."""


@dataclass(frozen=True)
class Topic:
    """A topic of one type."""

    name: str
    """Absolute, e.g. `/camera/depth/points`."""
    type_name: str
    """As ROS writes it, e.g. `sensor_msgs/msg/PointCloud2`."""
    depth: int = 10
    """How many messages a subscriber may queue; only told to others."""

    @property
    def bridge_key(self) -> str:
        """Key under which zenoh-bridge-ros2dds puts and takes the topic."""
        return self.name[1:]

    @property
    def dds_type(self) -> str:
        """The type as DDS writes it."""
        package, folder, message = self.type_name.split("/")
        return f"{package}::{folder}::dds_::{message}_"


@dataclass(frozen=True)
class Domain:
    """A ROS domain of one distribution, as rmw_zenoh shows it."""

    number: int
    """ROS_DOMAIN_ID."""
    hashes: bool
    """Whether its distribution has type hashes; Humble has none."""

    def hash_of(self, topic: Topic) -> str:
        """What stands for the definition of its type."""
        return type_hash(topic.type_name) if self.hashes else NO_HASH

    def publisher_key(self, topic: Topic) -> str:
        """The key to put a topic on."""
        return f"{self.number}/{topic.name[1:]}/{topic.dds_type}/{self.hash_of(topic)}"

    def subscriber_key(self, topic: Topic) -> str:
        """The key to subscribe to: publishers of other distributions are heard too."""
        return f"{self.number}/{topic.name[1:]}/{topic.dds_type}/{ANY_HASH}"

    def node_token(self, zid: str, node: str) -> str:
        """Announces a node; it has the first number of its Zenoh session."""
        return f"@ros2_lv/{self.number}/{zid}/0/0/NN/%/%/{node}"

    def topic_token(self, zid: str, node: str, entity: int, kind: str, topic: Topic) -> str:
        """Announces a publisher (kind MP) or a subscription (MS) of that node; `entity` is its number there."""
        name = topic.name.replace("/", "%")
        qos = QOS_DEPTH.format(depth=topic.depth)
        head = f"@ros2_lv/{self.number}/{zid}/0/{entity}/{kind}/%/%/{node}"
        return f"{head}/{name}/{topic.dds_type}/{self.hash_of(topic)}/{qos}"


def check_topic(name: str) -> str:
    """The name, when it is the absolute name of a topic.

    Raises:
        TopicNameError: it is none.
    """
    if TOPIC.fullmatch(name) is None or "__" in name or name.endswith("_"):
        raise TopicNameError(
            f"{name[:100]!r} is no topic: begin with a slash, then words of letters, digits and single _ between "
            "slashes, none beginning with a digit, such as /camera/depth/points"
        )
    return name

"""What stands in for ROS 2 in tests: its keys and attachments, written by hand rather than by the service's code."""

import json
import struct
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import zenoh

from service.ros2.messages import type_store
from tests.service.support import Inbox, inbox

HASHES = {
    "sensor_msgs/msg/PointCloud2": "RIHS01_9198cabf7da3796ae6fe19c4cb3bdd3525492988c70522628af5daa124bae2b5",
    "tf2_msgs/msg/TFMessage": "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087",
    "sensor_msgs/msg/JointState": "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e",
    "vision_msgs/msg/Detection3DArray": "RIHS01_793f5eab9595ac1c0da07873cc859db42eae51f0ee76056db8562515d830e018",
}
"""As ROS 2 distributions since Iron publish them."""
POINTS_KEY = f"0/camera/depth/points/sensor_msgs::msg::dds_::PointCloud2_/{HASHES['sensor_msgs/msg/PointCloud2']}"
DRIVER_GID = bytes(range(16))


def rmw_key(topic: str, type_name: str, domain: int = 0) -> str:
    """The key of a topic as rmw_zenoh has it."""
    package, _, message = type_name.split("/")
    return f"{domain}{topic}/{package}::msg::dds_::{message}_/{HASHES[type_name]}"


def rmw_attachment(seq: int, gid: bytes = DRIVER_GID, source_ns: int = 1) -> bytes:
    """The 33 bytes."""
    return struct.pack("<qq", seq, source_ns) + b"\x10" + gid


def read_attachment(sample: zenoh.Sample) -> tuple[int, int, bytes]:
    """Number, time and publisher of a message."""
    assert sample.attachment is not None
    attachment = sample.attachment.to_bytes()
    assert len(attachment) == 33
    assert attachment[16] == 16
    seq, source_ns = struct.unpack("<qq", attachment[:16])
    return seq, source_ns, attachment[17:]


def read(sample: zenoh.Sample, type_name: str) -> Any:
    """A message in CDR."""
    return type_store().deserialize_cdr(sample.payload.to_bytes(), type_name)


def both_inboxes(network: zenoh.Session, topic: str, type_name: str) -> tuple[Inbox, Inbox]:
    """What comes on a topic, as rmw_zenoh and as the bridge see it."""
    return inbox(network, rmw_key(topic, type_name)), inbox(network, topic[1:])


@contextmanager
def rmw_peer(endpoint: str) -> Iterator[zenoh.Session]:
    """A Zenoh session as a node on rmw_zenoh opens it: a peer that knows one router and listens on loopback."""
    config = zenoh.Config()
    entries = {
        "mode": "peer",
        "connect/endpoints": [endpoint],
        "listen/endpoints": ["tcp/127.0.0.1:0"],
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": True,
        "scouting/gossip/target": {"router": ["router", "peer"], "peer": ["router"]},
        "timestamping/enabled": {"router": True, "peer": True, "client": True},
    }
    for key, value in entries.items():
        config.insert_json5(key, json.dumps(value))
    with zenoh.open(config) as session:
        yield session

"""Messages of ROS 2 in CDR, by rosbags' type store and the definitions of vision_msgs."""

from functools import cache
from typing import Any

from rosbags.serde import SerdeError
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from rosbags.typesys.store import Typestore

POINT_CLOUD2 = "sensor_msgs/msg/PointCloud2"
DETECTIONS = "vision_msgs/msg/Detection3DArray"
TRANSFORMS = "tf2_msgs/msg/TFMessage"
JOINT_STATE = "sensor_msgs/msg/JointState"

VISION_MSGS = {
    "vision_msgs/msg/ObjectHypothesis": "string class_id\nfloat64 score\n",
    "vision_msgs/msg/ObjectHypothesisWithPose": (
        "vision_msgs/ObjectHypothesis hypothesis\ngeometry_msgs/PoseWithCovariance pose\n"
    ),
    "vision_msgs/msg/BoundingBox3D": "geometry_msgs/Pose center\ngeometry_msgs/Vector3 size\n",
    "vision_msgs/msg/Detection3D": (
        "std_msgs/Header header\nvision_msgs/ObjectHypothesisWithPose[] results\n"
        "vision_msgs/BoundingBox3D bbox\nstring id\n"
    ),
    DETECTIONS: "std_msgs/Header header\nvision_msgs/Detection3D[] detections\n",
}
"""Field by field as vision_msgs 4 has them; rosbags brings only the packages of ROS 2 itself."""


class MessageError(ValueError):
    """The bytes are no such message."""


@cache
def type_store() -> Typestore:
    """The types of ROS 2 Jazzy and of vision_msgs."""
    store = get_typestore(Stores.ROS2_JAZZY)
    for name, definition in VISION_MSGS.items():
        store.register(get_types_from_msg(definition, name))
    return store


def deserialize(payload: bytes, name: str) -> Any:
    """A message from CDR of either byte order.

    Raises:
        MessageError: the bytes are no such message.
    """
    try:
        return type_store().deserialize_cdr(payload, name)
    except (SerdeError, ValueError, IndexError, MemoryError) as error:
        raise MessageError(str(error)) from error


def serialize(message: Any, name: str) -> bytes:
    """A message in little-endian CDR."""
    return bytes(type_store().serialize_cdr(message, name))


def type_hash(name: str) -> str:
    """The RIHS01 hash of a type (REP 2016), which rmw_zenoh writes into keys."""
    return type_store().hash_rihs01(name)

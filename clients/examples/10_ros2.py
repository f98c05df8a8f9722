"""A camera's node on rmw_zenoh publishes PointCloud2; the object's transforms come back on /tf. No ROS is needed here.

Start a service as a node of ROS 2 first (`captra serve --ros2`), then run

    python clients/examples/10_ros2.py recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz
"""

import os
import queue
import struct
import sys
import time
from typing import Any

import numpy as np
import zenoh
from rosbags.typesys import Stores, get_typestore

from captra.data.recordings import load_recording
from clients.rest import RestApi, session_body
from clients.stream import connect, wait_for_subscriber

POINTS, TRANSFORMS = "sensor_msgs/msg/PointCloud2", "tf2_msgs/msg/TFMessage"
FLOAT32 = 7
ros = get_typestore(Stores.ROS2_JAZZY)
types = ros.types


def key_of(topic: str, type_name: str) -> str:
    """The key of a topic on rmw_zenoh, in domain 0."""
    package, folder, message = type_name.split("/")
    return f"0{topic}/{package}::{folder}::dds_::{message}_/{ros.hash_rihs01(type_name)}"


def message_of(cloud: np.ndarray, stamp_ns: int) -> memoryview:
    """A PointCloud2 in CDR, as a camera's driver writes it."""
    stamp = types["builtin_interfaces/msg/Time"](sec=stamp_ns // 10**9, nanosec=stamp_ns % 10**9)
    field = types["sensor_msgs/msg/PointField"]
    message = types[POINTS](
        header=types["std_msgs/msg/Header"](stamp=stamp, frame_id="camera_depth_optical_frame"),
        height=1,
        width=len(cloud),
        fields=[field(name=name, offset=4 * i, datatype=FLOAT32, count=1) for i, name in enumerate("xyz")],
        is_bigendian=False,
        point_step=12,
        row_step=12 * len(cloud),
        data=np.frombuffer(cloud.astype("<f4").tobytes(), np.uint8),
        is_dense=True,
    )
    return ros.serialize_cdr(message, POINTS)


recording = load_recording(sys.argv[1])
api = RestApi()
options = {"ros2": {"points_topic": "/camera/depth/points", "name": "cup"}}
opened = api.post_session(session_body(recording.category.name, recording.init, options))
received: queue.Queue[zenoh.Sample] = queue.Queue()
publisher_id = os.urandom(16)
with connect(tuple(opened["zenoh"]["endpoints"]), timeout_s=10) as network:
    network.declare_subscriber(key_of("/tf", TRANSFORMS), received.put)
    camera = network.declare_publisher(
        key_of("/camera/depth/points", POINTS), congestion_control=zenoh.CongestionControl.BLOCK
    )
    wait_for_subscriber(camera, timeout_s=10)
    clouds = zip(recording.clouds, recording.stamps_ns.tolist(), strict=True)
    for number, (cloud, stamp_ns) in enumerate(clouds, start=1):
        attachment = struct.pack("<qqB", number, time.time_ns(), len(publisher_id)) + publisher_id
        camera.put(bytes(message_of(cloud, stamp_ns)), attachment=attachment)
        answer: Any = ros.deserialize_cdr(received.get(timeout=10).payload.to_bytes(), TRANSFORMS)
        (found,) = answer.transforms
        at = found.transform.translation
        print(f"{found.header.frame_id} -> {found.child_frame_id}: {at.x:.3f} {at.y:.3f} {at.z:.3f} m")
api.delete(opened["session_id"])
api.close()

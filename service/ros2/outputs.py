"""Results in the messages of ROS 2: boxes, transforms and joint states, with the stamp and frame of the cloud."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from captra.health import State
from service.results import PartPose, Result
from service.ros2.body_frame import body_quat_xyzw, body_size
from service.ros2.messages import DETECTIONS, JOINT_STATE, TRANSFORMS, serialize, type_store
from service.ros2.options import Ros2Options

FARTHEST_SECOND = 2**31
"""Stamps of ROS count seconds in 32 bits."""


def detections(result: Result, options: Ros2Options) -> bytes:
    """vision_msgs/msg/Detection3DArray: one detection a part, scored by confidence; none while the object is lost."""
    types = type_store().types
    header = header_of(result)

    def detection(part: PartPose) -> Any:
        pose = pose_of(part)
        hypothesis = types["vision_msgs/msg/ObjectHypothesis"](class_id=part.name, score=result.confidence)
        covariance = np.zeros(36)  # unknown: the method gives a confidence, no covariance
        with_covariance = types["geometry_msgs/msg/PoseWithCovariance"](pose=pose, covariance=covariance)
        guess = types["vision_msgs/msg/ObjectHypothesisWithPose"](hypothesis=hypothesis, pose=with_covariance)
        box = types["vision_msgs/msg/BoundingBox3D"](center=pose, size=vector(body_size(part.size)))
        return types["vision_msgs/msg/Detection3D"](
            header=header, results=[guess], bbox=box, id=options.frame_of(part.name)
        )

    message = types[DETECTIONS](header=header, detections=[detection(part) for part in known(result)])
    return serialize(message, DETECTIONS)


def transforms(result: Result, options: Ros2Options) -> bytes:
    """tf2_msgs/msg/TFMessage: one child frame a part, below the frame of the cloud."""
    types = type_store().types
    header = header_of(result)

    def transform(part: PartPose) -> Any:
        value = types["geometry_msgs/msg/Transform"](
            translation=vector(part.translation), rotation=quaternion(body_quat_xyzw(part.quat_xyzw))
        )
        return types["geometry_msgs/msg/TransformStamped"](
            header=header, child_frame_id=options.frame_of(part.name), transform=value
        )

    return serialize(types[TRANSFORMS](transforms=[transform(part) for part in known(result)]), TRANSFORMS)


def joint_states(result: Result) -> bytes:
    """sensor_msgs/msg/JointState: names as in the category, positions in radians or metres."""
    nothing = np.zeros(0)
    message = type_store().types[JOINT_STATE](
        header=header_of(result),
        name=[joint.name for joint in result.joints],
        position=np.array([joint.value for joint in result.joints], np.float64),
        velocity=nothing,
        effort=nothing,
    )
    return serialize(message, JOINT_STATE)


def known(result: Result) -> Sequence[PartPose]:
    """The parts, as long as the track holds: subscribers that know no states must not get poses of a lost object."""
    return () if result.state is State.LOST else result.parts


def has_ros_stamp(result: Result) -> bool:
    """Whether the stamp of a result can be said in ROS, whose seconds have 32 bits."""
    return result.stamp_ns is not None and -FARTHEST_SECOND <= result.stamp_ns // 1_000_000_000 < FARTHEST_SECOND


def header_of(result: Result) -> Any:
    """std_msgs/msg/Header with the stamp and frame of the cloud, as they came."""
    types = type_store().types
    sec, nanosec = divmod(result.stamp_ns or 0, 1_000_000_000)
    stamp = types["builtin_interfaces/msg/Time"](sec=sec, nanosec=nanosec)
    return types["std_msgs/msg/Header"](stamp=stamp, frame_id=result.frame_id)


def pose_of(part: PartPose) -> Any:
    """geometry_msgs/msg/Pose of a part's box, z up."""
    types = type_store().types
    x, y, z = part.translation
    position = types["geometry_msgs/msg/Point"](x=x, y=y, z=z)
    return types["geometry_msgs/msg/Pose"](position=position, orientation=quaternion(body_quat_xyzw(part.quat_xyzw)))


def vector(values: tuple[float, ...]) -> Any:
    """geometry_msgs/msg/Vector3."""
    x, y, z = values
    return type_store().types["geometry_msgs/msg/Vector3"](x=x, y=y, z=z)


def quaternion(quat_xyzw: tuple[float, ...]) -> Any:
    """geometry_msgs/msg/Quaternion, whose order is x, y, z, w."""
    x, y, z, w = quat_xyzw
    return type_store().types["geometry_msgs/msg/Quaternion"](x=x, y=y, z=z, w=w)

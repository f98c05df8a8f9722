from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from captra.health import State
from captra.joints import JointValue
from service.results import PartPose, Result
from service.ros2.messages import DETECTIONS, JOINT_STATE, TRANSFORMS, deserialize
from service.ros2.options import Ros2Options
from service.ros2.outputs import detections, has_ros_stamp, joint_states, transforms

NAMES = Ros2Options("my_laptop", None)
RESULT = Result(
    session_id="9f2c1e07ab34d658",
    seq=7,
    stamp_ns=1_700_000_000_000_000_123,
    frame_id="camera_depth_optical_frame",
    state=State.TRACKING,
    confidence=0.75,
    parts=(
        PartPose("base", (0.1, 0.2, 0.5), (0.0, 0.0, 0.0, 1.0), (0.3, 0.02, 0.2)),
        PartPose("display", (0.1, 0.1, 0.6), (0.5, 0.5, 0.5, 0.5), (0.3, 0.21, 0.01)),
    ),
    joints=(JointValue("hinge", "revolute", 1.25),),
)


def header(message: Any) -> tuple[int, int, str]:
    return message.stamp.sec, message.stamp.nanosec, message.frame_id


def test_a_detection_for_each_part() -> None:
    message = deserialize(detections(RESULT, NAMES), DETECTIONS)
    assert header(message.header) == (1_700_000_000, 123, "camera_depth_optical_frame")
    base, display = message.detections
    assert (base.id, display.id) == ("my_laptop/base", "my_laptop/display")
    assert header(base.header) == header(message.header)
    (guess,) = base.results
    assert (guess.hypothesis.class_id, guess.hypothesis.score) == ("base", 0.75)
    assert guess.pose.pose == base.bbox.center
    centre, size = base.bbox.center, base.bbox.size
    assert (centre.position.x, centre.position.y, centre.position.z) == (0.1, 0.2, 0.5)
    half = np.sqrt(0.5)  # 90° about x: what was y up is z up
    turned = centre.orientation
    assert (turned.x, turned.y, turned.z, turned.w) == pytest.approx((-half, 0, 0, half))
    assert (size.x, size.y, size.z) == (0.3, 0.2, 0.02)


def test_a_child_frame_for_each_part() -> None:
    message = deserialize(transforms(RESULT, NAMES), TRANSFORMS)
    assert [each.child_frame_id for each in message.transforms] == ["my_laptop/base", "my_laptop/display"]
    first = message.transforms[0]
    assert header(first.header) == (1_700_000_000, 123, "camera_depth_optical_frame")
    assert (first.transform.translation.x, first.transform.translation.z) == (0.1, 0.5)
    boxes = deserialize(detections(RESULT, NAMES), DETECTIONS).detections
    assert [each.transform.rotation for each in message.transforms] == [box.bbox.center.orientation for box in boxes]


def test_joints_by_name() -> None:
    message = deserialize(joint_states(RESULT), JOINT_STATE)
    assert header(message.header) == (1_700_000_000, 123, "camera_depth_optical_frame")
    assert message.name == ["hinge"]
    assert message.position.tolist() == [1.25]
    assert len(message.velocity) == len(message.effort) == 0


def test_a_lost_object_is_nowhere() -> None:
    lost = replace(RESULT, state=State.LOST)
    assert deserialize(detections(lost, NAMES), DETECTIONS).detections == []
    assert deserialize(transforms(lost, NAMES), TRANSFORMS).transforms == []


@pytest.mark.parametrize(
    ("stamp_ns", "fits"),
    [(0, True), (-1, True), ((2**31) * 10**9 - 1, True), ((2**31) * 10**9, False), (-(2**63), False), (None, False)],
)
def test_stamps_that_ros_cannot_say(stamp_ns: int | None, fits: bool) -> None:
    result = replace(RESULT, stamp_ns=stamp_ns)
    assert has_ros_stamp(result) is fits
    if fits and stamp_ns is not None:
        stamp = deserialize(detections(result, NAMES), DETECTIONS).header.stamp
        assert stamp.sec * 10**9 + stamp.nanosec == stamp_ns

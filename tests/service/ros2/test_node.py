"""The service as a node of ROS 2, over real Zenoh sockets."""

import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
import zenoh

from service.ros2.messages import DETECTIONS, JOINT_STATE, POINT_CLOUD2, TRANSFORMS
from tests.service.ros2.clouds import STAMP_NS, XYZ, cdr
from tests.service.ros2.peers import (
    HASHES,
    POINTS_KEY,
    both_inboxes,
    read,
    read_attachment,
    rmw_attachment,
    rmw_peer,
)
from tests.service.support import (
    Camera,
    Inbox,
    Running,
    blob,
    f32,
    inbox,
    running,
    session_body,
    token_inbox,
    zenoh_client,
)

POINTS_TOPIC = "/camera/depth/points"
ROS2 = {"points_topic": POINTS_TOPIC, "name": "cup"}


@pytest.fixture(scope="module")
def node() -> Iterator[Running]:
    with running(ros2=True) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


@pytest.fixture
def ros(node: Running) -> Iterator[zenoh.Session]:
    with rmw_peer(node.endpoint) as session:
        yield session


@pytest.fixture
def opened(node: Running) -> Iterator[dict[str, Any]]:
    body = node.open_session(ros2=ROS2)
    yield body
    node.http.delete(f"/v1/sessions/{body['session_id']}")


def camera(ros: zenoh.Session, key: str = POINTS_KEY) -> Camera:
    """A publisher that the service listens to; rmw_zenoh sets no encoding."""
    return Camera(ros, key, encoding="")


def rejected(events: Inbox, count: int) -> None:
    """Wait until so many frames were refused; events of states come in between."""
    index = 0
    while count:
        count -= events.message(index)["kind"] == "rejected"
        index += 1


def test_a_cloud_of_rmw_zenoh_comes_back_as_boxes_and_frames(
    node: Running, ros: zenoh.Session, opened: dict[str, Any]
) -> None:
    boxes, bridged = both_inboxes(ros, "/captra/cup/detections", DETECTIONS)
    frames, _ = both_inboxes(ros, "/tf", TRANSFORMS)
    fields = [("intensity", "f4"), ("z", "f4"), ("rgb", "u4"), ("x", "f4"), ("y", "f4")]
    organized = blob((0.01, 0, 0.5), points=300).reshape(15, 20, 3)
    organized[3, 4] = np.nan
    payload = cdr(organized, fields, pad=3, row_pad=5, big_endian_data=True, big_endian_cdr=True)
    camera(ros).put(payload, attachment=rmw_attachment(41))
    message = read(boxes.sample(0), DETECTIONS)
    assert message.header.stamp.sec * 10**9 + message.header.stamp.nanosec == STAMP_NS
    assert message.header.frame_id == "camera_depth_optical_frame"
    (detection,) = message.detections
    assert detection.id == "cup/mug"
    position = detection.bbox.center.position
    assert (position.x, position.y, position.z) == pytest.approx((0.01, 0, 0.5), abs=2e-3)
    (transform,) = read(frames.sample(0), TRANSFORMS).transforms
    assert (transform.header.frame_id, transform.child_frame_id) == ("camera_depth_optical_frame", "cup/mug")
    assert bridged.sample(0).payload.to_bytes() == boxes.sample(0).payload.to_bytes()
    assert bridged.sample(0).attachment is None


def test_every_message_has_the_attachment_of_rmw_zenoh(
    node: Running, ros: zenoh.Session, opened: dict[str, Any]
) -> None:
    boxes, _ = both_inboxes(ros, "/captra/cup/detections", DETECTIONS)
    frames, _ = both_inboxes(ros, "/tf", TRANSFORMS)
    before_ns = time.time_ns()
    for seq in range(3):
        node.post_frame(opened["session_id"], f32(blob()), seq)
    sent = [read_attachment(boxes.sample(index)) for index in range(3)]
    assert [seq for seq, _, _ in sent] == [1, 2, 3]
    assert all(before_ns <= source_ns <= time.time_ns() for _, source_ns, _ in sent)
    assert len({gid for _, _, gid in sent}) == 1
    assert sent[0][2] != read_attachment(frames.sample(0))[2]


def test_a_cloud_of_the_bridge_is_tracked(node: Running, opened: dict[str, Any]) -> None:
    with zenoh_client(node.endpoint) as bridge:
        results = inbox(bridge, opened["zenoh"]["pose"])
        Camera(bridge, POINTS_TOPIC[1:], encoding="").put(cdr(blob()), attachment=None)
        result = results.message(0)
    assert (result["seq"], result["stamp_ns"], result["frame_id"]) == (0, STAMP_NS, "camera_depth_optical_frame")


def test_gaps_show_and_a_driver_that_starts_again_is_not_old(
    node: Running, ros: zenoh.Session, opened: dict[str, Any]
) -> None:
    results, driver = inbox(ros, opened["zenoh"]["pose"]), camera(ros)
    for index, attachment in enumerate([rmw_attachment(41), rmw_attachment(44), rmw_attachment(1, gid=bytes(16))]):
        driver.put(cdr(blob()), attachment=attachment)
        results.message(index)
    assert [results.message(index)["seq"] for index in range(3)] == [0, 3, 4]
    assert node.session(opened["session_id"])["counters"]["dropped"] == 2


def test_clouds_without_the_object_are_refused_and_leave_no_gap(
    node: Running, ros: zenoh.Session, opened: dict[str, Any]
) -> None:
    events, results, driver = inbox(ros, opened["zenoh"]["event"]), inbox(ros, opened["zenoh"]["pose"]), camera(ros)
    driver.put(cdr(blob()), attachment=rmw_attachment(1))
    results.message(0)
    for seq in range(2, 12):
        driver.put(cdr(blob((0, 0, 5))), attachment=rmw_attachment(seq))
        rejected(events, seq - 1)
    driver.put(cdr(blob()), attachment=rmw_attachment(13))
    while (shown := node.session(opened["session_id"]))["counters"]["processed"] < 2:
        time.sleep(0.01)
    assert (shown["counters"]["rejected"], shown["counters"]["dropped"]) == (10, 1)
    assert shown["last_result"]["seq"] == 12


def test_what_cannot_be_read_is_refused_with_a_reason(
    node: Running, ros: zenoh.Session, opened: dict[str, Any]
) -> None:
    events, results, driver = inbox(ros, opened["zenoh"]["event"]), inbox(ros, opened["zenoh"]["pose"]), camera(ros)
    driver.put(cdr(blob()), attachment=bytes(5))
    assert events.message(0)["reason"] == "malformed-attachment"
    driver.put(b"no message", attachment=rmw_attachment(1))
    assert events.message(1)["reason"] == "malformed-message"
    driver.put(cdr(blob(), [*XYZ[:2], ("z", "i2")]), attachment=rmw_attachment(2))
    assert events.message(2)["reason"] == "unsupported-fields"
    driver.put(cdr(blob()), attachment=rmw_attachment(3))
    assert results.message(0)["state"] == "tracking"


def test_joints_are_published_and_parts_have_frames_of_their_own(node: Running, ros: zenoh.Session) -> None:
    opened = node.open_session("laptop_articulated", ros2={"name": "laptop"})
    joints, _ = both_inboxes(ros, "/captra/laptop/joint_states", JOINT_STATE)
    frames, _ = both_inboxes(ros, "/tf", TRANSFORMS)
    result = node.post_frame(opened["session_id"], f32(blob()), 0).json()
    message = read(joints.sample(0), JOINT_STATE)
    assert (message.name, message.position.tolist()) == (["hinge"], [result["joints"][0]["value"]])
    children = {each.child_frame_id for each in read(frames.sample(0), TRANSFORMS).transforms}
    assert children == {"laptop/base", "laptop/display"}
    node.http.delete(f"/v1/sessions/{opened['session_id']}")


def test_ros2_topic_list_shows_what_is_there_as_long_as_it_is(node: Running, ros: zenoh.Session) -> None:
    opened = node.open_session(ros2=ROS2)
    tokens = token_inbox(ros, "@ros2_lv/0/**")
    shown = {str(tokens.sample(index).key_expr) for index in range(4)}
    (router,) = ros.info.routers_zid()
    assert all(key.startswith(f"@ros2_lv/0/{router}/0/") for key in shown)
    assert len({key.split("/")[4] for key in shown}) == 4, "every entity has a number of its own"
    tf, boxes, points = (HASHES[name] for name in (TRANSFORMS, DETECTIONS, POINT_CLOUD2))
    assert {key.split("/", 5)[5] for key in shown} == {
        "NN/%/%/captra",
        f"MP/%/%/captra/%tf/tf2_msgs::msg::dds_::TFMessage_/{tf}/::,100:,:,:,,",
        f"MP/%/%/captra/%captra%cup%detections/vision_msgs::msg::dds_::Detection3DArray_/{boxes}/::,10:,:,:,,",
        f"MS/%/%/captra/%camera%depth%points/sensor_msgs::msg::dds_::PointCloud2_/{points}/::,10:,:,:,,",
    }
    node.http.delete(f"/v1/sessions/{opened['session_id']}")
    gone = [tokens.sample(index) for index in (4, 5)]
    assert all(sample.kind == zenoh.SampleKind.DELETE for sample in gone)
    assert {str(sample.key_expr).split("/")[5] for sample in gone} == {"MP", "MS"}


def test_the_router_brings_ros_nodes_together(node: Running) -> None:
    with rmw_peer(node.endpoint) as talker, rmw_peer(node.endpoint) as listener:
        heard = inbox(listener, "0/chatter/std_msgs::msg::dds_::String_/RIHS01_x")
        chatter = talker.declare_publisher("0/chatter/std_msgs::msg::dds_::String_/RIHS01_x")
        for _ in range(100):  # nodes find each other in a while
            chatter.put(b"hello")
            if len(heard):
                break
            time.sleep(0.05)
        assert heard.sample(0).payload.to_bytes() == b"hello"


def test_sessions_without_names_get_some(node: Running, ros: zenoh.Session) -> None:
    opened = node.open_session()
    boxes, _ = both_inboxes(ros, f"/captra/mug_{opened['session_id']}/detections", DETECTIONS)
    node.post_frame(opened["session_id"], f32(blob()), 0)
    (detection,) = read(boxes.sample(0), DETECTIONS).detections
    assert detection.id == f"mug_{opened['session_id']}/mug"
    node.http.delete(f"/v1/sessions/{opened['session_id']}")


@pytest.mark.parametrize(
    ("ros2", "pointer"),
    [
        ({"points_topic": "points"}, "/body/ros2/points_topic"),
        ({"points_topic": "/a/**"}, "/body/ros2/points_topic"),
        ({"name": "1st"}, "/body/ros2/name"),
        ({"name": "a/b"}, "/body/ros2/name"),
    ],
)
def test_names_that_are_none_are_refused(node: Running, ros2: dict[str, str], pointer: str) -> None:
    answer = node.http.post("/v1/sessions", json=session_body(ros2=ros2))
    assert (answer.status_code, answer.json()["errors"][0]["pointer"]) == (422, pointer)


def test_the_answer_says_where_to_listen_and_a_name_is_taken_once(node: Running, opened: dict[str, Any]) -> None:
    assert opened["ros2"] == {
        "points_topic": POINTS_TOPIC,
        "detections_topic": "/captra/cup/detections",
        "joint_states_topic": None,
        "frames": ["cup/mug"],
    }
    assert node.session(opened["session_id"])["ros2"] == opened["ros2"]
    answer = node.http.post("/v1/sessions", json=session_body(ros2={"name": "cup"}))
    assert (answer.status_code, answer.json()["reason"]) == (422, "invalid-request")
    assert opened["session_id"] in answer.json()["detail"]


def test_without_the_option_it_is_refused_with_what_to_do(service: Running) -> None:
    answer = service.http.post("/v1/sessions", json=session_body(ros2=ROS2))
    assert (answer.status_code, answer.json()["reason"]) == (422, "unsupported-option")
    assert "--ros2" in answer.json()["detail"]
    assert service.open_session()["ros2"] is None


def test_topics_do_not_get_around_secrets() -> None:
    with running("mug", ros2=True, cloud_secrets=True) as started:
        assert started.service.readiness.wait_prepared(60)
        answer = started.http.post("/v1/sessions", json=session_body(ros2=ROS2))
        assert answer.json()["reason"] == "unsupported-option"
        assert "CAPTRA_CLOUD_SECRETS=false" in answer.json()["detail"]
        assert started.open_session(ros2={"name": "cup"})["zenoh"]["secret"]


def test_a_topic_of_the_service_feeds_sessions_that_name_none() -> None:
    with running("mug", ros2=True, ros2_points_topic=POINTS_TOPIC, ros2_domain=7) as started:
        assert started.service.readiness.wait_prepared(60)
        opened = started.open_session()
        with rmw_peer(started.endpoint) as ros:
            results = inbox(ros, opened["zenoh"]["pose"])
            camera(ros, "7" + POINTS_KEY[1:]).put(cdr(blob()), attachment=rmw_attachment(1))
            assert results.message(0)["stamp_ns"] == STAMP_NS

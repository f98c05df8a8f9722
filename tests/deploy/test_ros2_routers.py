"""Nodes of ROS 2 reach captra through routers that run already, and through those of deploy/."""

import json
import time
from pathlib import Path

import pytest
import zenoh

from service.ros2.messages import DETECTIONS
from tests.service.ros2.clouds import STAMP_NS, cdr
from tests.service.ros2.peers import DRIVER_GID, POINTS_KEY, read, rmw_attachment, rmw_key, rmw_peer
from tests.service.support import Camera, Running, blob, free_endpoint, inbox, running

FOLDER = Path(__file__).parents[2] / "deploy" / "zenoh"
ROS2 = {"points_topic": "/camera/depth/points", "name": "cup"}


def config_of(name: str, **entries: list[str]) -> zenoh.Config:
    config = zenoh.Config.from_file(str(FOLDER / name))
    for key, value in entries.items():
        config.insert_json5(f"{key}/endpoints", json.dumps(value))
    return config


def check_topics(node: Running, network: zenoh.Session, points: str, boxes: str, gid: bytes | None) -> None:
    """Clouds go out until the first boxes come back: routers take a while to know of subscriptions beyond them."""
    assert node.service.readiness.wait_prepared(60)
    node.open_session(ros2=ROS2)
    detections = inbox(network, boxes)
    camera = Camera(network, points, encoding="")
    for seq in range(1, 101):
        camera.put(cdr(blob()), attachment=None if gid is None else rmw_attachment(seq, gid))
        if len(detections):
            break
        time.sleep(0.1)
    stamp = read(detections.sample(0), DETECTIONS).header.stamp
    assert stamp.sec * 10**9 + stamp.nanosec == STAMP_NS


@pytest.mark.parametrize("who_dials", ["robot", "captra"])
def test_rmw_zenoh(who_dials: str) -> None:
    inner, outer = free_endpoint(), free_endpoint()
    dialled = [inner] if who_dials == "robot" else []
    with (
        zenoh.open(config_of("rmw_zenohd.json5", listen=[outer], connect=dialled)),
        running("mug", endpoint=inner, ros2=True, zenoh_connect=() if dialled else (outer,)) as node,
        rmw_peer(outer) as robot,
    ):
        key = rmw_key("/captra/cup/detections", DETECTIONS)
        check_topics(node, robot, POINTS_KEY, key, DRIVER_GID)


def test_the_bridge() -> None:
    with (
        running("mug", ros2=True) as node,
        zenoh.open(config_of("ros2dds.json5", connect=[node.endpoint])) as bridge,
    ):
        check_topics(node, bridge, "camera/depth/points", "captra/cup/detections", None)

"""Depth images, messages of ROS 2, masks and boxes from the client to the service itself, by both ways."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from rosbags.typesys import Stores, get_typestore

from captra.geometry import Pose
from clients import (
    Box,
    Camera,
    DepthImage,
    DepthPng,
    Frame,
    Mask,
    PointCloud2,
    RequestRefusedError,
    Session,
    open_session,
)
from clients.packing import Observation
from clients.regions import Region
from clients.replay import replay
from clients.results import Result

WIDTH, HEIGHT = 64, 48
CAMERA = Camera(fx=60, fy=60, cx=31.5, cy=23.5, width=WIDTH, height=HEIGHT)
CENTRE = (0.0, 0.0, 0.5)

Send = Callable[[Session, Observation, Region | None], Result]


def by_zenoh(session: Session, observation: Observation, mask: Region | None) -> Result:
    (result,) = session.track([Frame(observation, 5, mask)])
    return result


def by_http(session: Session, observation: Observation, mask: Region | None) -> Result:
    return session.post(observation, 5, mask)


def disc() -> np.ndarray:
    """Depth, mm, of a disc of 8 cm at CENTRE before a wall 3 m away, with pixels without depth in between."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    radius_px = np.hypot(u - CAMERA.cx, v - CAMERA.cy)
    return np.select([radius_px < 4.8, radius_px < 8], [500, 0], 3000).astype(np.uint16)


DEPTH_MM = disc()
RIGHT_HALF = (DEPTH_MM == 500) & (np.arange(WIDTH) >= 32)


def organized() -> np.ndarray:
    """The same as points (rows, columns, 3), metres, NaN where there is no depth."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    z = np.where(DEPTH_MM == 0, np.nan, DEPTH_MM * 1e-3)
    return np.stack([(u - CAMERA.cx) / CAMERA.fx * z, (v - CAMERA.cy) / CAMERA.fy * z, z], axis=-1).astype(np.float32)


def message(points: np.ndarray, stamp_ns: int = 7_000_000_005) -> PointCloud2:
    """An organized sensor_msgs/msg/PointCloud2."""
    types = get_typestore(Stores.ROS2_JAZZY)
    kind = types.types
    sec, nanosec = divmod(stamp_ns, 1_000_000_000)
    header = kind["std_msgs/msg/Header"](kind["builtin_interfaces/msg/Time"](sec, nanosec), "ros_camera")
    fields = [kind["sensor_msgs/msg/PointField"](name, 4 * i, 7, 1) for i, name in enumerate("xyz")]
    rows, columns, _ = points.shape
    data = np.frombuffer(points.tobytes(), np.uint8)
    cloud = kind["sensor_msgs/msg/PointCloud2"](
        header,
        rows,
        columns,
        fields,
        is_bigendian=False,
        point_step=12,
        row_step=12 * columns,
        data=data,
        is_dense=False,
    )
    return PointCloud2(bytes(types.serialize_cdr(cloud, "sensor_msgs/msg/PointCloud2")))


def pose_of(parts: int = 1) -> Pose:
    return Pose.from_size(np.tile(np.eye(3), (parts, 1, 1)), np.tile(CENTRE, (parts, 1)), np.full((parts, 3), 0.1))


OBSERVATIONS: dict[str, Observation] = {
    "raw": DepthImage(DEPTH_MM),
    "png": DepthImage(DEPTH_MM).to_png(),
    "metres": DepthImage(np.where(DEPTH_MM == 0, np.nan, DEPTH_MM * 1e-3).astype(np.float32)),
    "organized": organized(),
    "ros": message(organized()),
}


@pytest.mark.parametrize("send", [by_zenoh, by_http])
@pytest.mark.parametrize("name", OBSERVATIONS)
def test_whatever_a_camera_gives_is_tracked(url: str, name: str, send: Send) -> None:
    with open_session("mug", pose_of(), url=url, camera=CAMERA, frame_id="optical") as session:
        result = send(session, OBSERVATIONS[name], None)
    assert result.parts[0].translation == pytest.approx(CENTRE, abs=6e-3)
    of_message = name == "ros"
    assert result.stamp_ns == (7_000_000_005 if of_message else 5)
    assert result.frame_id == ("ros_camera" if of_message else "optical")


def test_units_are_the_cameras(url: str) -> None:
    tenths = Camera(60, 60, 31.5, 23.5, WIDTH, HEIGHT, metres_per_unit=1e-4)
    with open_session("mug", pose_of(), url=url, camera=tenths) as session:
        result = session.post(DepthImage(10 * DEPTH_MM))
    assert result.parts[0].translation == pytest.approx(CENTRE, abs=6e-3)


@pytest.mark.parametrize("send", [by_zenoh, by_http])
@pytest.mark.parametrize("name", OBSERVATIONS)
def test_masks_tell_the_object(url: str, name: str, send: Send) -> None:
    with open_session("laptop_articulated", pose_of(2), url=url, camera=CAMERA, masks="object") as session:
        result = send(session, OBSERVATIONS[name], Mask(RIGHT_HALF))
    for part in result.parts:
        assert part.translation[0] > 0.005, "the middle of the right half of the disc"
        assert part.translation[2] == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize("send", [by_zenoh, by_http])
@pytest.mark.parametrize("name", ["raw", "png", "ros"])
def test_boxes_tell_what_is_outside(url: str, name: str, send: Send) -> None:
    with open_session("laptop_articulated", pose_of(2), url=url, camera=CAMERA, masks="object") as session:
        result = send(session, OBSERVATIONS[name], Box(32, 20, 37, 28))
    assert result.parts[0].translation[0] > 0.005
    assert result.parts[0].translation[2] == pytest.approx(0.5, abs=1e-3)


def test_masks_of_parts_number_them(url: str) -> None:
    lower = np.arange(HEIGHT)[:, None] >= 24
    numbers = np.where(RIGHT_HALF, 1 + lower, 0).astype(np.uint8)
    with open_session("laptop_articulated", pose_of(2), url=url, camera=CAMERA, masks="parts") as session:
        result = session.post(DepthImage(DEPTH_MM), mask=Mask(numbers))
        assert result.parts[1].translation[0] > 0.005
        with pytest.raises(RequestRefusedError, match="has the value 6: laptop_articulated has 2 parts"):
            session.post(DepthImage(DEPTH_MM), mask=Mask(3 * numbers))


def test_a_png_that_is_no_depth_is_refused_by_the_service(url: str) -> None:
    grey = Mask(np.ones((HEIGHT, WIDTH), np.bool_)).to_png()
    with (
        open_session("mug", pose_of(), url=url, camera=CAMERA) as session,
        pytest.raises(RequestRefusedError, match="send 16-bit grey") as caught,
    ):
        session.post(DepthPng(grey))
    assert caught.value.reason == "malformed-image"


def test_recordings_hold_images_and_masks_and_replay_the_same(url: str, tmp_path: Path) -> None:
    path = tmp_path / "session.mcap"
    frames = [Frame(observation, i, Mask(RIGHT_HALF)) for i, observation in enumerate(OBSERVATIONS.values())]
    frames.append(Frame(OBSERVATIONS["png"], 6, Box(32, 20, 37, 28)))
    with open_session("laptop_articulated", pose_of(2), url=url, camera=CAMERA, masks="object", record=path) as session:
        list(session.track(frames))
    pairs = replay(url, path, lambda _: None)
    assert len(pairs) == len(frames)
    assert all(pair.identical for pair in pairs)
    assert all(pair.recorded.parts[0].translation[0] > 0.005 for pair in pairs)

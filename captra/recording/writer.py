"""Writes a session into an MCAP file: what went to the service, what came back, and the same for Foxglove and Rerun."""

import base64
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import orjson
from mcap.writer import CompressionType, Writer

from captra.geometry import Pose
from captra.recording.foxglove import Result, boxes, edges, point_cloud, transforms
from captra.recording.protobuf import encode, schema

SESSION, FRAME, RESULT, EVENT, RESET = "captra.Session", "captra.Frame", "captra.Result", "captra.Event", "captra.Reset"
"""Messages of our own, as JSON: what a replay needs."""
TRUTH = "captra.Truth"
"""Where the object really was, of recordings that know."""
CLOUD_TOPIC = "/cloud"
PAYLOAD_ON = "payload_on"
"""Says that a frame's payload is the message before it on this topic."""
POINTS, TRANSFORMS, BOXES = "foxglove.PointCloud", "foxglove.FrameTransforms", "foxglove.SceneUpdate"
"""Foxglove's messages, as protobuf: what viewers show."""
EDGES = "edges"
"""The boxes once more, as points."""
TOPICS = {
    SESSION: "/captra/session",
    FRAME: "/captra/frames",
    RESULT: "/captra/results",
    EVENT: "/captra/events",
    RESET: "/captra/resets",
    TRUTH: "/captra/truth",
    POINTS: CLOUD_TOPIC,
    TRANSFORMS: "/tf",
    BOXES: "/boxes",
    EDGES: "/box_edges",
}
SCHEMAS = {EDGES: POINTS}
"""Of channels that are not called by their schema."""
DEFAULT_FRAME_ID = "camera"
"""What the service calls the frame of a session that names none."""
ANY_OBJECT = b'{"type": "object"}'
POINT_CLOUD2 = "sensor_msgs/msg/PointCloud2"
"""Written as it came: viewers know it."""

Shown = np.ndarray | bytes | None
"""What a frame shows: points (N, 3), metres; a PointCloud2 in CDR; or nothing that is known."""


class SessionWriter:
    """One file of one session; its methods may be called from any thread. Close it, or the file has no index."""

    def __init__(self, path: Path) -> None:
        self._file = path.open("wb")
        self._writer = Writer(self._file, compression=CompressionType.LZ4)  # keeps up with full clouds of a camera
        self._writer.start(profile="", library="captra")
        self._channels: dict[str, int] = {}
        for name, topic in TOPICS.items():
            if name.startswith("captra."):
                self._declare(name, "jsonschema", ANY_OBJECT, topic, "json")
            else:
                self._declare(name, "protobuf", schema(), topic, "protobuf")
        self._lock = threading.Lock()
        self._closed = False
        self._frame_id = DEFAULT_FRAME_ID

    @property
    def size_bytes(self) -> int:
        """How much is in the file by now."""
        with self._lock:
            return 0 if self._closed else self._file.tell()

    def session(self, body: Mapping[str, Any]) -> None:
        """The body of the POST that opened the session."""
        self._frame_id = str(body.get("frame_id", DEFAULT_FRAME_ID))
        self._write((SESSION, orjson.dumps(body)))

    def frame(self, seq: int, stamp_ns: int, encoding: str, payload: bytes, mask: bytes, shown: Shown) -> None:
        """A frame as it was sent, with its mask or box, and what it shows; a PointCloud2 is both, and kept once."""
        body = {"seq": seq, "stamp_ns": stamp_ns, "encoding": encoding}
        body |= {"mask": base64.b64encode(mask).decode()} if mask else {}
        if isinstance(shown, bytes) and shown == payload:
            self._write((POINT_CLOUD2, shown), (FRAME, orjson.dumps(body | {PAYLOAD_ON: CLOUD_TOPIC})))
            return
        viewed: list[tuple[str, bytes]] = []
        match shown:
            case bytes():
                viewed = [(POINT_CLOUD2, shown)]
            case np.ndarray():
                cloud = point_cloud(shown, stamp_ns, self._frame_id)
                viewed = [(POINTS, encode(POINTS, cloud))]
        self._write((FRAME, orjson.dumps(body | {"payload": base64.b64encode(payload).decode()})), *viewed)

    def result(self, payload: bytes, result: Result) -> None:
        """A result as it came, byte for byte."""
        self._write(
            (RESULT, payload),
            (TRANSFORMS, encode(TRANSFORMS, transforms(result))),
            (BOXES, encode(BOXES, boxes(result))),
            (EDGES, encode(POINTS, edges(result))),
        )

    def event(self, payload: bytes) -> None:
        """An event as it came."""
        self._write((EVENT, payload))

    def reset(self, body: Mapping[str, Any]) -> None:
        """The body of a PUT that started the track again."""
        self._write((RESET, orjson.dumps(body)))

    def truth(self, stamp_ns: int, pose: Pose) -> None:
        """The true pose at the time of a frame."""
        self._write((TRUTH, orjson.dumps({"stamp_ns": stamp_ns, "parts": parts_of(pose)})))

    def close(self) -> None:
        """Write the index; what comes later is not recorded.

        Raises:
            OSError: the disk does not take it; the file is closed as it is.
        """
        with self._lock:
            if not self._closed:
                self._closed = True
                try:
                    self._writer.finish()  # type: ignore[no-untyped-call]
                finally:
                    self._file.close()

    def abandon(self) -> None:
        """Close a file that could not be written as it is: after half a chunk there can be no index of what follows."""
        with self._lock:
            self._closed = True
            with suppress(OSError):  # of what was still to be written
                self._file.close()

    def _declare(self, name: str, schema_encoding: str, schema: bytes, topic: str, encoding: str) -> None:
        number = self._writer.register_schema(SCHEMAS.get(name, name), schema_encoding, schema)
        self._channels[name] = self._writer.register_channel(topic, encoding, number)

    def _write(self, *messages: tuple[str, bytes]) -> None:
        """One message after the other, with none of another thread between them."""
        now_ns = time.time_ns()
        with self._lock:
            if self._closed:
                return
            for name, data in messages:
                if name == POINT_CLOUD2 and name not in self._channels:  # takes half a second: for those who need it
                    self._declare(name, "ros2msg", definition_of(name), CLOUD_TOPIC, "cdr")
                self._writer.add_message(self._channels[name], now_ns, data, now_ns)


def parts_of(pose: Pose) -> list[dict[str, Any]]:
    """A pose as the bodies of the REST API have it: one entry a part, rotation as a matrix, metres."""
    return [
        {"rotation": {"matrix": rotation.tolist()}, "translation": translation.tolist(), "size": size.tolist()}
        for rotation, translation, size in zip(pose.rotation, pose.translation, pose.size, strict=True)
    ]


def definition_of(name: str) -> bytes:
    """The definition of a ROS 2 message with all that it is made of, as MCAP wants it."""
    from rosbags.typesys import Stores, get_typestore

    text, _ = get_typestore(Stores.ROS2_JAZZY).generate_msgdef(name, ros_version=2)
    return text.encode()

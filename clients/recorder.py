"""Writes a session into an MCAP file: what went to the service, what came back, and the same for Foxglove and Rerun."""

import base64
import threading
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import orjson
from mcap.writer import Writer

from captra.data.recordings import RecordingError
from clients.foxglove import SCHEMAS, boxes, point_cloud, transforms
from clients.packing import Packed
from clients.results import Result

SESSION, FRAME, RESULT, EVENT, RESET = "captra.Session", "captra.Frame", "captra.Result", "captra.Event", "captra.Reset"
"""Messages of our own, as JSON: what a replay needs."""
TOPICS = {
    SESSION: "/captra/session",
    FRAME: "/captra/frames",
    RESULT: "/captra/results",
    EVENT: "/captra/events",
    RESET: "/captra/resets",
    "foxglove.PointCloud": "/cloud",
    "foxglove.FrameTransforms": "/tf",
    "foxglove.SceneUpdate": "/boxes",
}
DEFAULT_FRAME_ID = "camera"
"""What the service calls the frame of a session that names none."""
ANY_OBJECT = {"type": "object"}
POINT_CLOUD2 = "sensor_msgs/msg/PointCloud2"
"""Written as it came: viewers know it."""


class McapRecorder:
    """One file of one session; its methods may be called from any thread. Close it, or the file has no index."""

    def __init__(self, path: Path) -> None:
        """Raises RecordingError where the file cannot be written."""
        try:
            self._file = path.open("wb")
        except OSError as error:
            raise RecordingError(
                f"cannot record into {path} ({error.strerror}): name a file in a folder that is there and can be "
                "written"
            ) from error
        self._writer = Writer(self._file)
        self._writer.start(profile="", library="captra")
        self._channels: dict[str, int] = {}
        for name, topic in TOPICS.items():
            schema = orjson.dumps(SCHEMAS.get(name, ANY_OBJECT))
            self._declare(name, "jsonschema", schema, topic, "json")
        self._lock = threading.Lock()
        self._closed = False
        self._frame_id = DEFAULT_FRAME_ID

    def session(self, body: Mapping[str, Any]) -> None:
        """The body of the POST that opened the session."""
        self._frame_id = str(body.get("frame_id", DEFAULT_FRAME_ID))
        self._write(SESSION, orjson.dumps(body))

    def frame(self, packed: Packed, seq: int, stamp_ns: int) -> None:
        """A frame as it was sent, and what it shows."""
        payload, mask = (base64.b64encode(data).decode() for data in (packed.payload, packed.region))
        body = {"seq": seq, "stamp_ns": stamp_ns, "encoding": packed.media_type, "payload": payload}
        self._write(FRAME, orjson.dumps(body | ({"mask": mask} if mask else {})))
        shown = packed.shown()
        if isinstance(shown, bytes):
            self._write(POINT_CLOUD2, shown)
        else:
            cloud = point_cloud(shown, stamp_ns, self._frame_id)
            self._write("foxglove.PointCloud", orjson.dumps(cloud))

    def result(self, payload: bytes, result: Result) -> None:
        """A result as it came, byte for byte."""
        self._write(RESULT, payload)
        self._write("foxglove.FrameTransforms", orjson.dumps(transforms(result)))
        self._write("foxglove.SceneUpdate", orjson.dumps(boxes(result)))

    def event(self, payload: bytes) -> None:
        """An event as it came."""
        self._write(EVENT, payload)

    def reset(self, body: Mapping[str, Any]) -> None:
        """The body of a PUT that started the track again."""
        self._write(RESET, orjson.dumps(body))

    def close(self) -> None:
        """Write the index; what comes later is not recorded."""
        with self._lock:
            if not self._closed:
                self._closed = True
                self._writer.finish()  # type: ignore[no-untyped-call]
                self._file.close()

    def _declare(self, name: str, schema_encoding: str, schema: bytes, topic: str, encoding: str) -> None:
        number = self._writer.register_schema(name, schema_encoding, schema)
        self._channels[name] = self._writer.register_channel(topic, encoding, number)

    def _write(self, name: str, data: bytes) -> None:
        now_ns = time.time_ns()
        with self._lock:
            if name == POINT_CLOUD2 and name not in self._channels:  # takes half a second: for those who need it
                self._declare(name, "ros2msg", definition_of(name), "/cloud", "cdr")
            if not self._closed:
                self._writer.add_message(self._channels[name], now_ns, data, now_ns)


class NullRecorder:
    """Records nothing."""

    def session(self, body: Mapping[str, Any]) -> None:
        """Nothing to do."""

    def frame(self, packed: Packed, seq: int, stamp_ns: int) -> None:
        """Nothing to do."""

    def result(self, payload: bytes, result: Result) -> None:
        """Nothing to do."""

    def event(self, payload: bytes) -> None:
        """Nothing to do."""

    def reset(self, body: Mapping[str, Any]) -> None:
        """Nothing to do."""

    def close(self) -> None:
        """Nothing to do."""


Recorder = McapRecorder | NullRecorder


def recorder_for(path: Path | str | None) -> Recorder:
    """A recorder into a file, or one that records nothing."""
    return NullRecorder() if path is None else McapRecorder(Path(path))


def definition_of(name: str) -> bytes:
    """The definition of a ROS 2 message with all that it is made of, as MCAP wants it."""
    from rosbags.typesys import Stores, get_typestore

    text, _ = get_typestore(Stores.ROS2_JAZZY).generate_msgdef(name, ros_version=2)
    return text.encode()

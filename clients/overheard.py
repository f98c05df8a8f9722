"""What others put on the keys of a session: what of it viewers are shown, and what of it is recorded."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from captra.recording.writer import Shown
from clients.camera import Camera
from clients.clouds import ENCODINGS, I16_METRES
from clients.depth import DepthImage, DepthPng
from clients.regions import PACKED_BOX

SECRET_BYTES = 16
PNG_BEGIN, PNG_END = b"\x89PNG\r\n\x1a\n", b"IEND\xae\x42\x60\x82"
CDR = "application/cdr"
RAW_DEPTH = {"application/vnd.captra.depth.u16": "<u2", "application/vnd.captra.depth.f32": "<f4"}


def mask_in(tail: bytes) -> bytes:
    """The mask or box behind number and stamp, without the session's secret, which must not be recorded."""
    if tail.startswith(PNG_BEGIN):
        return tail[: tail.find(PNG_END) + len(PNG_END)]
    return tail[: PACKED_BOX.size] if len(tail) in {PACKED_BOX.size, PACKED_BOX.size + SECRET_BYTES} else b""


def shown(encoding: str, payload: bytes, camera: Camera | None) -> Shown:
    """What viewers are shown of a frame: points, metres, or a message of ROS 2; nothing of what cannot be read."""
    media_type = encoding.partition(";")[0]
    if media_type == CDR:
        return payload
    try:
        return points_in(media_type, payload, camera)
    except (ValueError, OSError):  # the service refuses it, and says why
        return None


def points_in(media_type: str, payload: bytes, camera: Camera | None) -> np.ndarray | None:
    """Points (N, 3) of a cloud or an image, metres; None for an encoding that has none.

    Raises:
        ValueError, OSError: it is not what it says, or there is no camera for it.
    """
    if media_type == ENCODINGS["f32"].media_type:
        return np.frombuffer(payload, "<f4").reshape(-1, 3)
    if media_type == ENCODINGS["i16"].media_type:
        return np.frombuffer(payload, "<i2").reshape(-1, 3) * I16_METRES
    if media_type == "image/png":
        return DepthPng(payload).shown(camera)
    if media_type in RAW_DEPTH and camera is not None:
        pixels = np.frombuffer(payload, RAW_DEPTH[media_type]).reshape(camera.height, camera.width)
        return DepthImage(pixels).shown(camera)
    return None


def camera_in(state: Mapping[str, Any]) -> Camera | None:
    """The camera that a session was opened with, as the REST API shows it."""
    camera = state["camera"]
    if camera is None or camera["width"] is None:
        return None
    return Camera(**{name: camera[name] for name in Camera.__dataclass_fields__})


def body_of(state: Mapping[str, Any], parts: list[dict[str, Any]]) -> dict[str, Any]:
    """The body of a POST that opens a session which is tracked like this one, with its parts there."""
    names = ("category", "profile", "frame_id", "masks", "prediction", "smoothing", "joint_axes", "camera")
    return {name: state[name] for name in names if state[name] is not None} | {"parts": parts}


def parts_now(state: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Where the last result of a session has its parts."""
    return [
        {"rotation": {"quat_xyzw": part["quat_xyzw"]}, "translation": part["translation"], "size": part["size"]}
        for part in state["last_result"]["parts"]
    ]

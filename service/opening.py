"""How a session was opened, in the words of `POST /v1/sessions`."""

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from captra.recording.writer import parts_of
from service.store import SessionRecord


def options_of(record: SessionRecord) -> dict[str, Any]:
    """What its frames bring and what its track may do; None where it was left out."""
    camera, chosen = record.camera, record.options
    return {
        "masks": record.masks,
        "prediction": chosen.prediction,
        "smoothing": None if chosen.smoothing is None else asdict(chosen.smoothing),
        "joint_axes": None
        if chosen.joint_axes is None
        else {name: list(axis) for name, axis in chosen.joint_axes.items()},
        "camera": None
        if camera is None
        else asdict(camera.intrinsics)
        | {"width": camera.width, "height": camera.height, "metres_per_unit": camera.metres_per_unit},
    }


def body_of(record: SessionRecord) -> Mapping[str, Any]:
    """The body of a POST that opens a session which is tracked alike, from where this one is trusted to be."""
    body = {
        "category": record.category,
        "parts": parts_of(record.trusted.pose),
        "profile": record.profile,
        "frame_id": record.frame_id,
    }
    return body | {name: value for name, value in options_of(record).items() if value is not None}

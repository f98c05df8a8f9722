"""Clouds, poses and boxes as Foxglove's messages have them, so that Foxglove and Rerun show them as they are."""

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np

from captra.health import State

FLOAT32 = 7
"""Number of the type in foxglove.PackedElementField."""

COLOURS = {
    State.TRACKING: (0.2, 0.8, 0.3, 0.4),
    State.UNCERTAIN: (1.0, 0.7, 0.1, 0.4),
    State.RECOVERING: (1.0, 0.7, 0.1, 0.4),
    State.LOST: (0.9, 0.2, 0.2, 0.4),
}
"""Red, green, blue, alpha."""


class Part(Protocol):
    """A part's box, as clients and the service have it."""

    @property
    def name(self) -> str:
        """As in the category."""

    @property
    def translation(self) -> tuple[float, ...]:
        """Centre of the box, metres."""

    @property
    def quat_xyzw(self) -> tuple[float, ...]:
        """Rotation of the box."""

    @property
    def size(self) -> tuple[float, ...]:
        """Extent along the part's own axes, metres."""


class Result(Protocol):
    """What a frame told, as clients and the service have it."""

    @property
    def session_id(self) -> str:
        """Whose object."""

    @property
    def stamp_ns(self) -> int | None:
        """Stamp of the frame."""

    @property
    def frame_id(self) -> str:
        """Frame of the poses."""

    @property
    def state(self) -> State:
        """Whether the track holds."""

    @property
    def parts(self) -> Sequence[Part]:
        """One a part."""


def time_of(stamp_ns: int) -> dict[str, int]:
    """Nanoseconds as seconds and nanoseconds."""
    sec, nsec = divmod(stamp_ns, 1_000_000_000)
    return {"seconds": sec, "nanos": nsec}


def xyz(values: tuple[float, ...]) -> dict[str, float]:
    """A vector, or with a fourth value a quaternion in the order x, y, z, w."""
    return dict(zip("xyzw", values, strict=False))


def point_cloud(points: np.ndarray, stamp_ns: int, frame_id: str) -> dict[str, Any]:
    """foxglove.PointCloud of points (N, 3), metres."""
    return {
        "timestamp": time_of(stamp_ns),
        "frame_id": frame_id,
        "pose": {"position": xyz((0.0, 0.0, 0.0)), "orientation": xyz((0.0, 0.0, 0.0, 1.0))},
        "point_stride": 12,
        "fields": [{"name": name, "offset": 4 * i, "type": FLOAT32} for i, name in enumerate("xyz")],
        "data": points.astype("<f4").tobytes(),
    }


def transforms(result: Result) -> dict[str, Any]:
    """foxglove.FrameTransforms: one child frame a part."""
    return {
        "transforms": [
            {
                "timestamp": time_of(result.stamp_ns or 0),
                "parent_frame_id": result.frame_id,
                "child_frame_id": part.name,
                "translation": xyz(part.translation),
                "rotation": xyz(part.quat_xyzw),
            }
            for part in result.parts
        ]
    }


def boxes(result: Result) -> dict[str, Any]:
    """foxglove.SceneUpdate: a box a part, in the colour of the state."""
    colour = dict(zip("rgba", COLOURS[result.state], strict=True))

    def cube(part: Part) -> dict[str, Any]:
        pose = {"position": xyz(part.translation), "orientation": xyz(part.quat_xyzw)}
        return {"pose": pose, "size": xyz(part.size), "color": colour}

    entity = {
        "timestamp": time_of(result.stamp_ns or 0),
        "frame_id": result.frame_id,
        "id": result.session_id,
        "lifetime": time_of(0),
        "frame_locked": False,
        "cubes": [cube(part) for part in result.parts],
    }
    return {"entities": [entity]}

"""Clouds, poses and boxes as Foxglove's messages have them, so that Foxglove and Rerun show them as they are."""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any, Protocol

import numpy as np

from captra.geometry import matrix_from_quat_xyzw
from captra.health import State

TYPES = {"|u1": 1, "<f4": 7}
"""Their numbers in foxglove.PackedElementField."""
POINT = np.dtype([(axis, "<f4") for axis in "xyz"])
COLOURED = np.dtype([*((axis, "<f4") for axis in "xyz"), *((name, "u1") for name in ("red", "green", "blue", "alpha"))])
"""Points of clouds."""
ALONG_AN_EDGE = 24
"""So many points look like a line."""

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
    return _packed(np.ascontiguousarray(points, "<f4").view(POINT), stamp_ns, frame_id)


def _packed(points: np.ndarray, stamp_ns: int, frame_id: str) -> dict[str, Any]:
    """foxglove.PointCloud of records."""
    fields: Mapping[str, Any] = points.dtype.fields or {}
    return {
        "timestamp": time_of(stamp_ns),
        "frame_id": frame_id,
        "pose": {"position": xyz((0.0, 0.0, 0.0)), "orientation": xyz((0.0, 0.0, 0.0, 1.0))},
        "point_stride": points.dtype.itemsize,
        "fields": [{"name": name, "offset": at, "type": TYPES[kind.str]} for name, (kind, at, *_) in fields.items()],
        "data": points.tobytes(),
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


def edges(result: Result) -> dict[str, Any]:
    """foxglove.PointCloud of the boxes' edges, in the colour of the state: for Rerun, which draws no boxes."""
    points = np.zeros((len(result.parts), len(UNIT_EDGES)), COLOURED)
    for row, part in zip(points, result.parts, strict=True):
        turned = (UNIT_EDGES * part.size) @ matrix_from_quat_xyzw(np.array(part.quat_xyzw)).T
        row["x"], row["y"], row["z"] = (turned + part.translation).T
    red, green, blue, _ = COLOURS[result.state]
    for name, value in {"red": red, "green": green, "blue": blue, "alpha": 1.0}.items():
        points[name] = round(255 * value)
    return _packed(points, result.stamp_ns or 0, result.frame_id)


def _unit_edges() -> np.ndarray:
    """Points on the twelve edges of the cube of side 1 about the origin."""
    along = np.linspace(-0.5, 0.5, ALONG_AN_EDGE)
    ends = [np.array([(step, *end) for step in along]) for end in product((-0.5, 0.5), repeat=2)]
    return np.concatenate([np.roll(edge, axis, axis=1) for edge in ends for axis in range(3)])


UNIT_EDGES = _unit_edges()

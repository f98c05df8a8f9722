"""What the service tells: results and events, and their JSON."""

import time
from dataclasses import dataclass, field
from enum import StrEnum

import orjson

from captra.categories import Category
from captra.geometry import Pose, quat_xyzw_from_matrix
from captra.health import State
from captra.joints import JointValue

Numbers = tuple[float, ...]


@dataclass(frozen=True)
class PartPose:
    """Box of one part, in the frame of the cloud."""

    name: str
    """As in the category."""
    translation: Numbers
    """Centre of the box, metres."""
    quat_xyzw: Numbers
    """Unit quaternion of R_camera_part, in the order x, y, z, w, with w ≥ 0."""
    size: Numbers
    """Extent along the part's own axes, metres."""


@dataclass(frozen=True)
class Timing:
    """Where the time of one frame went, milliseconds; `total` also holds decoding."""

    queue: float = 0.0
    """Waiting for the session."""
    sample: float = 0.0
    """Crop, sampling, canonicalization, neighbourhoods."""
    infer: float = 0.0
    """Both networks."""
    solve: float = 0.0
    """Fits and health."""
    total: float = 0.0
    """From arrival to this result."""


@dataclass(frozen=True)
class Result:
    """Where the object is, according to one frame; or, before the first one, according to the client."""

    session_id: str
    """Whose object."""
    seq: int | None
    """Number of the frame; none for a pose that was given."""
    stamp_ns: int | None
    """Stamp of the frame, as the client gave it; none for a pose that was given."""
    frame_id: str
    """Frame of the poses: that of the cloud."""
    state: State
    """Whether the track holds."""
    confidence: float
    """Probability that the pose is within 5° and 5 cm."""
    parts: tuple[PartPose, ...]
    """In the order of the category's parts."""
    joints: tuple[JointValue, ...]
    """In the order of the category's joints."""
    looks: int | None = None
    """How many poses the frame might be looked around; none for a pose that was given."""
    timing_ms: Timing = field(default_factory=Timing)
    """Milliseconds a stage."""

    def to_json(self) -> bytes:
        """The result as it is published."""
        return orjson.dumps(self)


class EventKind(StrEnum):
    """What happened to a session."""

    STATE = "state"
    REJECTED = "rejected"
    RESET = "reset"
    POSE_REJECTED = "pose-rejected"
    CLOSING = "closing"


@dataclass(frozen=True)
class Event:
    """Something that happened to a session."""

    kind: EventKind
    """What."""
    session_id: str
    """To which session."""
    state: State
    """State after it."""
    previous_state: State
    """State before it."""
    seq: int | None = None
    """The frame it came with, where it has a number."""
    stamp_ns: int | None = None
    """That frame's stamp."""
    reason: str | None = None
    """Slug: why a frame or pose was rejected, or why the session closes."""
    detail: str | None = None
    """The same for people."""
    looks: int | None = None
    """How many poses a frame might be looked around that showed nothing near any of them."""
    time_ns: int = field(default_factory=time.time_ns)
    """When, on the service's clock, nanoseconds since 1970."""

    def to_json(self) -> bytes:
        """The event as it is published."""
        return orjson.dumps(self)


def part_poses(pose: Pose, category: Category) -> tuple[PartPose, ...]:
    """A pose in the form it is published."""
    quats_xyzw = quat_xyzw_from_matrix(pose.rotation).tolist()
    rows = zip(category.parts, pose.translation.tolist(), quats_xyzw, pose.size.tolist(), strict=True)
    return tuple(PartPose(name, tuple(t), tuple(quat_xyzw), tuple(size)) for name, t, quat_xyzw, size in rows)

"""What the service says about a session, as frozen values."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from jaxtyping import Float64

from captra.geometry import Pose, matrix_from_quat_xyzw
from captra.health import State

Vector = tuple[float, ...]


@dataclass(frozen=True)
class PartPose:
    """Where one part is, in the frame of the cloud."""

    name: str
    """As in the category; rigid objects have one part."""
    translation: Vector
    """Centre of the part's box, (3,) metres."""
    quat_xyzw: Vector
    """Rotation part → cloud, (4,), unit quaternion in the order x, y, z, w."""
    size: Vector
    """Extent of the box along the part's own axes, (3,) metres."""

    @property
    def T_camera_part(self) -> Float64[np.ndarray, "4 4"]:
        """Homogeneous transform of points in the part's frame, metres, into the frame of the cloud."""
        transform = np.eye(4)
        transform[:3, :3] = matrix_from_quat_xyzw(np.array(self.quat_xyzw))
        transform[:3, 3] = self.translation
        return transform


@dataclass(frozen=True)
class JointState:
    """State of one joint of an articulated object."""

    name: str
    """As in the category."""
    kind: str
    """`revolute` or `prismatic`."""
    value: float
    """Radians or metres, zero at rest."""


@dataclass(frozen=True)
class Timing:
    """Where the time of one frame went inside the service, milliseconds."""

    queue: float
    """Between arrival and the start of work."""
    sample: float
    """Crop, sampling and neighbourhoods."""
    infer: float
    """Both networks."""
    solve: float
    """Fits and health."""
    total: float
    """From payload in to result out."""


@dataclass(frozen=True)
class Result:
    """The answer to one cloud."""

    session_id: str
    """Of the session that answers."""
    seq: int
    """Number of the cloud, as `Session.put` returned it."""
    stamp_ns: int
    """Capture time of the cloud, as it was sent."""
    frame_id: str
    """Name of the coordinate frame that the cloud and the poses are in; empty when the session has none."""
    state: State
    """Whether the track holds."""
    confidence: float
    """Probability in [0, 1] that the pose is within 5° and 5 cm."""
    parts: tuple[PartPose, ...]
    """One pose a part, in the category's order."""
    joints: tuple[JointState, ...]
    """Joint states in the category's order; empty for rigid objects."""
    timing_ms: Timing
    """Measured by the service."""
    looks: int | None = None
    """How many poses the frame might be looked around; a replay gives it back."""
    round_trip_ms: float | None = field(default=None, compare=False)
    """From `Session.put` to receipt, measured by this client; None where it did not send the cloud."""

    @property
    def pose(self) -> Pose:
        """All parts as arrays."""
        return Pose.from_size(
            matrix_from_quat_xyzw(np.array([part.quat_xyzw for part in self.parts])),
            np.array([part.translation for part in self.parts]),
            np.array([part.size for part in self.parts]),
        )


@dataclass(frozen=True)
class Event:
    """Something that happened to a session."""

    session_id: str
    """Of the session."""
    kind: str
    """`state`, `rejected`, `reset`, `pose-rejected` or `closing`."""
    seq: int | None
    """Number of the cloud that it is about, where there is one."""
    state: State
    """The state after it."""
    reason: str
    """Short machine-readable reason, of rejections and of closing; else empty."""
    detail: str
    """The same for people, with what to do next."""


def parse_result(payload: bytes | str | Mapping[str, Any]) -> Result:
    """Read a result as the service puts it (`application/json`)."""
    body = _members(payload)
    return Result(
        session_id=body["session_id"],
        seq=body["seq"],
        stamp_ns=body["stamp_ns"],
        frame_id=body.get("frame_id") or "",
        state=State(body["state"]),
        confidence=body["confidence"],
        parts=tuple(
            PartPose(part["name"], tuple(part["translation"]), tuple(part["quat_xyzw"]), tuple(part["size"]))
            for part in body["parts"]
        ),
        joints=tuple(JointState(joint["name"], joint["kind"], joint["value"]) for joint in body["joints"]),
        timing_ms=Timing(**{stage: body["timing_ms"][stage] for stage in Timing.__dataclass_fields__}),
        looks=body.get("looks"),
    )


def parse_event(payload: bytes | str | Mapping[str, Any]) -> Event:
    """Read an event as the service puts it (`application/json`)."""
    body = _members(payload)
    return Event(
        session_id=body["session_id"],
        kind=body["kind"],
        seq=body.get("seq"),
        state=State(body["state"]),
        reason=body.get("reason") or "",
        detail=body.get("detail") or "",
    )


def _members(payload: bytes | str | Mapping[str, Any]) -> Mapping[str, Any]:
    return payload if isinstance(payload, Mapping) else json.loads(payload)

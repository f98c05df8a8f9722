"""Bodies that the service answers with. Metres, radians, milliseconds; poses in the frame of the cloud."""

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from captra.health import State
from service.rest.examples import MUG_RESULT, OPENED, SESSION
from service.rest.inputs import Camera, Smoothing
from service.rest.vectors import Matrix3, Vector3, Vector4
from service.track_options import Prediction


class PartPose(BaseModel):
    """Where one part is."""

    name: str = Field(description="As in the category.")
    translation: Vector3 = Field(description="Centre of the box, metres, in the frame of the cloud.")
    quat_xyzw: Vector4 = Field(description="Unit quaternion of R_camera_part in the order x, y, z, w, with w ≥ 0.")
    size: Vector3 = Field(description="Extent of the box along the part's own axes, metres.")


class JointValue(BaseModel):
    """State of one joint."""

    name: str = Field(description="As in the category.")
    kind: Literal["revolute", "prismatic"]
    value: float = Field(description="Radians about the joint's axis, or metres along it.")


class Timing(BaseModel):
    """Where the time of one frame went, milliseconds."""

    queue: float = Field(description="Waiting for the session.")
    sample: float = Field(description="Crop, sampling, canonicalization, neighbourhoods.")
    infer: float = Field(description="Both networks.")
    solve: float = Field(description="Fits and health.")
    total: float = Field(description="From arrival to result, decoding included.")


class Result(BaseModel):
    """Where the object is, according to one frame."""

    model_config = ConfigDict(json_schema_extra={"examples": [MUG_RESULT]})

    session_id: str
    seq: int | None = Field(description="Number of the frame; null for a pose that was given, until a frame came.")
    stamp_ns: int | None = Field(description="Stamp of the frame as the client gave it; null like `seq`.")
    frame_id: str = Field(description="Frame of the poses: that of the cloud.")
    state: State = Field(description="Whether the track holds.")
    confidence: float = Field(ge=0, le=1, description="Probability that the pose is within 5° and 5 cm.")
    parts: list[PartPose] = Field(description="In the order of the category's parts.")
    joints: list[JointValue] = Field(description="In the order of the category's joints.")
    looks: int | None = Field(
        description="How many poses the frame might be looked around; null for a pose that was given."
    )
    timing_ms: Timing


class StreamKeys(BaseModel):
    """Where the session is reached by Zenoh."""

    cloud: str = Field(description="Put clouds here.")
    pose: str = Field(description="Subscribe to results here.")
    event: str = Field(description="Subscribe to events here.")
    endpoints: list[str] = Field(description="Connect to one of these.")
    secret: str | None = Field(
        default=None,
        description="32 hexadecimal digits, in the answer to POST alone: its 16 bytes end every cloud's attachment. "
        "Null where anybody may put clouds.",
    )


class Ros2Topics(BaseModel):
    """Where the session is reached in ROS 2."""

    points_topic: str | None = Field(description="`sensor_msgs/msg/PointCloud2` that it tracks, if any.")
    detections_topic: str = Field(description="`vision_msgs/msg/Detection3DArray` with the parts' boxes.")
    joint_states_topic: str | None = Field(description="`sensor_msgs/msg/JointState`, of articulated categories.")
    frames: list[str] = Field(description="Child frames on /tf, in the order of the parts.")


class OpenedSession(BaseModel):
    """A session that has been opened."""

    model_config = ConfigDict(json_schema_extra={"examples": [OPENED]})

    session_id: str
    category: str
    state: State
    expires_after_s: float = Field(description="The session ends when no frame comes for so many seconds.")
    encodings: list[str] = Field(description="Encodings of clouds that it reads.")
    zenoh: StreamKeys
    ros2: Ros2Topics | None = Field(description="Null where the service is no node of ROS 2.")


class Counters(BaseModel):
    """What became of a session's frames."""

    received: int = Field(description="Reached the service.")
    processed: int = Field(description="Have a result.")
    dropped: int = Field(description="Replaced by newer ones or lost on the way: gaps in `seq`.")
    rejected: int = Field(description="Refused.")
    rejected_by_reason: dict[str, int] = Field(description="Refused, by reason.")


class GivenRotation(BaseModel):
    """R_camera_part of a pose that was given, whatever form it came in."""

    matrix: Matrix3 = Field(description="Rows of the rotation matrix; its columns are the part's axes.")


class GivenPart(BaseModel):
    """The box of one part as it was given: the body of a POST or PUT may hold it as it is."""

    rotation: GivenRotation = Field(description="From the part's axes to the frame of the cloud.")
    translation: Vector3 = Field(description="Centre of the box, metres.")
    size: Vector3 = Field(description="Extent of the box along the part's own axes, metres.")


class SessionState(OpenedSession):
    """A session as it is now."""

    model_config = ConfigDict(json_schema_extra={"examples": [SESSION]})

    profile: str = Field(description="Sampling budget.")
    frame_id: str = Field(description="Frame of clouds that name none.")
    idle_timeout_s: float
    record: bool = Field(description="Whether the service records it.")
    masks: Literal["object", "parts"] | None = Field(description="What masks that come with frames tell.")
    camera: Camera | None = Field(description="Of depth images.")
    prediction: Prediction = Field(description="Where the object is expected in the next frame.")
    smoothing: Smoothing | None = Field(description="Of published poses.")
    joint_axes: dict[str, Vector3] | None = Field(description="Axes that parts are kept to, by joint.")
    started_from: list[GivenPart] = Field(description="Where the track began, or began again with the last PUT.")
    client: bool = Field(
        description="Whether its client's liveliness token was seen: what the client had subscribed to before is known "
        "to the service by then, behind however many routers it is."
    )
    created_ns: int = Field(description="When it was opened, nanoseconds since 1970.")
    counters: Counters
    last_result: Result


class Sessions(BaseModel):
    """All open sessions, oldest first."""

    sessions: list[SessionState]

"""What a session may ask for beyond where its object is, in the words of `POST /v1/sessions`."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from clients.camera import Camera

Prediction = Literal["none", "constant-velocity"]
"""Where the next pose is expected: where the last one was, or where its velocity carries it, by the frames' stamps."""
Axis = Sequence[float] | Float[np.ndarray, "3"]
"""Of a joint, in the frame of the parent part."""
MaskValues = Literal["object", "parts"]
"""What the values of masks mean: zero is background, all else the object; or k is part k of the category, from 1."""


@dataclass(frozen=True)
class Smoothing:
    """A One-Euro filter on published poses: an object at rest does not tremble, a fast one does not lag."""

    cutoff_hz: float = 1.0
    """Cut-off frequency at rest: lower ones tremble less and lag more."""
    translation_gain: float = 10.0
    """Hertz of cut-off per m/s."""
    rotation_gain: float = 2.0
    """Hertz of cut-off per rad/s."""


@dataclass(frozen=True)
class Ros2:
    """What ROS 2 sees of a session, where the service is a node of ROS 2."""

    points_topic: str | None = None
    """Topic of `sensor_msgs/msg/PointCloud2` to track, absolute; by default the service's own."""
    name: str | None = None
    """Begins its topics and child frames; by default category and session id."""


@dataclass(frozen=True)
class SessionOptions:
    """Fields of the body that opens a session; those that are None are left to the service."""

    profile: str | None = None
    """`realtime` or `paper`."""
    frame_id: str | None = None
    """Name of the clouds' frame."""
    idle_timeout_s: float | None = None
    """Closed after so long without a frame."""
    camera: Camera | None = None
    """Of depth images."""
    masks: MaskValues | None = None
    """Whether frames may bring masks, and what these tell."""
    prediction: Prediction | None = None
    """Where the object is expected in the next frame."""
    smoothing: Smoothing | None = None
    """Filters what is published; tracking itself is not changed."""
    joint_axes: Mapping[str, Axis] | None = None
    """Keeps parts on their joints: axis by joint, in the frame of the parent part; others have the category's axes."""
    record: bool | None = None
    """Whether the service records the session."""
    ros2: Ros2 | None = None
    """Its names in ROS 2."""

    def body(self) -> dict[str, Any]:
        """As JSON, without those that are None."""
        members: dict[str, Any] = {name: getattr(self, name) for name in self.__dataclass_fields__}
        if self.camera is not None:
            members["camera"] = self.camera.body()
        if self.smoothing is not None:
            members["smoothing"] = asdict(self.smoothing)
        if self.joint_axes is not None:
            members["joint_axes"] = {name: [float(value) for value in axis] for name, axis in self.joint_axes.items()}
        if self.ros2 is not None:
            members["ros2"] = {name: value for name, value in asdict(self.ros2).items() if value is not None}
        return {name: value for name, value in members.items() if value is not None}

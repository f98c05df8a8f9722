"""Bodies that clients send. Metres and seconds; poses in the frame of the cloud."""

from typing import Annotated, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, model_validator

from service.rest.examples import DEPTH_CAMERA, MUG_PART, ROS2
from service.rest.vectors import Finite, Matrix3, Vector3, Vector4
from service.ros2.names import check_topic
from service.settings import ProfileName
from service.track_options import Prediction


class Input(BaseModel):
    """A body that clients send: what it does not name is refused."""

    model_config = ConfigDict(extra="forbid", strict=True)


class Rotation(Input):
    """R_camera_part, as a quaternion or as a matrix."""

    model_config = ConfigDict(json_schema_extra={"oneOf": [{"required": ["quat_xyzw"]}, {"required": ["matrix"]}]})

    quat_xyzw: Vector4 | None = Field(default=None, description="Unit quaternion in the order x, y, z, w.")
    matrix: Matrix3 | None = Field(
        default=None, description="Rows of a rotation matrix; its columns are the part's axes."
    )

    @model_validator(mode="after")
    def one_form(self) -> Self:
        """Exactly one of the two."""
        if (self.quat_xyzw is None) == (self.matrix is None):
            raise ValueError("give exactly one of quat_xyzw and matrix")
        return self


class Part(Input):
    """The box of one part."""

    model_config = ConfigDict(json_schema_extra={"examples": [MUG_PART]})

    rotation: Rotation = Field(description="From the part's axes to the frame of the cloud.")
    translation: Vector3 = Field(description="Centre of the box, metres.")
    size: Vector3 = Field(description="Extent of the box along the part's own axes, metres.")


Focal = Annotated[float, Field(gt=0, allow_inf_nan=False)]
Gain = Annotated[float, Field(ge=0, le=1e6, allow_inf_nan=False)]
Count = Annotated[int, Field(ge=1, le=65_535)]
Parts = Annotated[list[Part], Field(min_length=1, max_length=64, description="In the order of the category's parts.")]


class Camera(Input):
    """A depth camera, for depth images: a pinhole without distortion."""

    model_config = ConfigDict(json_schema_extra={"examples": [DEPTH_CAMERA]})

    fx: Focal = Field(description="Focal length in columns, pixels.")
    fy: Focal = Field(description="Focal length in rows, pixels.")
    cx: Finite = Field(description="Column of the principal point, pixels; 0 is the middle of the first one.")
    cy: Finite = Field(description="Row of the principal point, pixels.")
    width: Count | None = Field(default=None, description="Columns of every image; needed for raw pixels.")
    height: Count | None = Field(default=None, description="Rows of every image; needed for raw pixels.")
    metres_per_unit: Focal = Field(default=0.001, description="What one unit of a 16-bit pixel is worth, metres.")
    distortion: list[Finite] = Field(
        default_factory=list,
        max_length=14,
        description="Distortion coefficients: zeros, or nothing. Others are refused: rectify the images first.",
    )


class Ros2(Input):
    """What ROS 2 sees of a session."""

    model_config = ConfigDict(json_schema_extra={"examples": [ROS2]})

    points_topic: Annotated[str, AfterValidator(check_topic)] | None = Field(
        default=None,
        max_length=255,
        description="Topic of `sensor_msgs/msg/PointCloud2` to track; by default CAPTRA_ROS2_POINTS_TOPIC.",
    )
    name: str | None = Field(
        default=None,
        pattern="^[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*$",
        max_length=64,
        description="Begins topics and child frames of the session; by default category and session id.",
    )


class Smoothing(Input):
    """The One-Euro filter: still objects rest, fast ones do not lag."""

    cutoff_hz: Annotated[float, Field(gt=0, le=1000, allow_inf_nan=False)] = Field(
        default=1.0, description="Cut-off frequency at rest: lower ones jitter less and lag more."
    )
    translation_gain: Gain = Field(default=10.0, description="Hertz of cut-off per m/s.")
    rotation_gain: Gain = Field(default=2.0, description="Hertz of cut-off per rad/s.")


class NewPose(Input):
    """A pose to start again from."""

    model_config = ConfigDict(json_schema_extra={"examples": [{"parts": [MUG_PART]}]})

    parts: Parts


class NewSession(Input):
    """An object to track, and where it is in the first cloud."""

    model_config = ConfigDict(
        json_schema_extra={
            "examples": [{"category": "mug", "parts": [MUG_PART], "frame_id": "camera_color_optical_frame"}]
        }
    )

    category: str = Field(max_length=100, description="One of `GET /v1/categories`.")
    parts: Parts
    frame_id: str = Field(
        default="camera", max_length=255, description="Name of the frame of the clouds; comes back as it is."
    )
    profile: ProfileName | None = Field(default=None, description="Sampling budget; by default the service's own.")
    idle_timeout_s: Annotated[float, Field(gt=0, allow_inf_nan=False)] | None = Field(
        default=None,
        description="Close the session after so many seconds without a frame; by default the service's own.",
    )
    masks: Literal["object", "parts"] | None = Field(
        default=None,
        description="Whether frames bring masks, and what their pixels tell; by default CoordinateNet segments.",
    )
    camera: Camera | None = Field(default=None, description="Needed by depth images.")
    record: bool = Field(default=False, description="Whether the service records it: `GET /v1/recordings`.")
    ros2: Ros2 | None = Field(default=None, description="Needs a service that is a node of ROS 2 (CAPTRA_ROS2).")
    prediction: Prediction | None = Field(
        default=None,
        description="Where the object is expected in the next frame: where it was, or where its velocity carries it, "
        "by the frames' stamps; by default the service's own choice.",
    )
    smoothing: Smoothing | None = Field(
        default=None, description="Filter what is published, by the frames' stamps; tracking itself is not changed."
    )
    joint_axes: Annotated[dict[str, Vector3], Field(max_length=64)] | None = Field(
        default=None,
        description="Keep parts on their joints: axis by joint, in the parent part's frame; a joint that is not named "
        "has the category's axis. Without it the bundle decides.",
    )

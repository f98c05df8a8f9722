"""Bodies that clients send. Metres and seconds; poses in the frame of the cloud."""

from typing import Annotated, Any, Self

from pydantic import BaseModel, ConfigDict, Field, model_validator

from service.rest.examples import MUG_PART
from service.rest.vectors import Matrix3, Vector3, Vector4
from service.settings import ProfileName


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


Parts = Annotated[list[Part], Field(min_length=1, max_length=64, description="In the order of the category's parts.")]


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
    masks: Any = Field(
        default=None, description="Not supported yet: anything but null is refused with `unsupported-option`."
    )
    camera: Any = Field(
        default=None, description="Not supported yet: anything but null is refused with `unsupported-option`."
    )

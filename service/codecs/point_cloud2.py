"""ROS 2 clouds: sensor_msgs/msg/PointCloud2 in CDR, with whatever fields, padding and byte order they have."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from captra.observations import PointCloud
from service.codecs.frames import Frame
from service.envelopes import Envelope, FrameHeader
from service.rejections import (
    EmptyCloudError,
    MalformedMessageError,
    TooManyPointsError,
    UnknownEncodingError,
    UnsupportedFieldsError,
    WrongByteCountError,
)
from service.ros2.attachments import seq_of
from service.ros2.messages import POINT_CLOUD2, MessageError, deserialize

CDR = "application/cdr"
"""Media type; the schema may follow it."""

FLOATS = {7: "f4", 8: "f8"}
"""Types of coordinates by the numbers of sensor_msgs/msg/PointField."""


@dataclass(frozen=True)
class PointCloud2Codec:
    """Stamp and frame come from the message, its number from whichever attachment it has, if it has one."""

    max_points: int
    """Larger clouds are refused."""
    encoding: str = CDR
    """Media type."""

    def open(self, envelope: Envelope) -> Frame:
        """Deserialize; the data stay as they are.

        Raises:
            UnknownEncodingError: the encoding names another schema.
            MalformedAttachmentError: the attachment is neither ours nor that of rmw_zenoh.
            MalformedMessageError: the payload is no such message.
        """
        parameters = envelope.encoding.partition(";")[2]
        schema = parameters.strip().removeprefix("schema=").strip('"')
        if schema and schema != POINT_CLOUD2:
            raise UnknownEncodingError(f"this session does not read {schema[:100]!r} in CDR: send {POINT_CLOUD2}")
        seq = seq_of(envelope.attachment)
        if not envelope.payload:
            raise EmptyCloudError(f"the message has no bytes: send a {POINT_CLOUD2} in CDR")
        try:
            message = deserialize(envelope.payload, POINT_CLOUD2)
        except MessageError as error:
            raise MalformedMessageError(f"the payload is no {POINT_CLOUD2} in CDR: {error}") from error
        stamp_ns = message.header.stamp.sec * 1_000_000_000 + message.header.stamp.nanosec
        return Frame(FrameHeader(seq, stamp_ns, message.header.frame_id or None), lambda: self.cloud(message))

    def cloud(self, message: Any) -> PointCloud:
        """Views of the coordinates where they lie in the message; maybe none.

        Raises:
            TooManyPointsError: over the limit.
            UnsupportedFieldsError: x, y or z is missing, or no float.
            WrongByteCountError: the data do not have the size that the message says.
        """
        rows, columns = message.height, message.width
        if rows * columns == 0:
            return PointCloud.of(np.zeros((0, 3), np.float32))
        if rows * columns > self.max_points:
            raise TooManyPointsError(
                f"the cloud has {rows * columns} points, the limit is {self.max_points}: crop or thin it out"
            )
        needed = (rows - 1) * message.row_step + columns * message.point_step
        if message.row_step < columns * message.point_step and rows > 1:
            raise WrongByteCountError(
                f"a row_step of {message.row_step} bytes does not hold {columns} points of {message.point_step} bytes"
            )
        if len(message.data) < needed:
            raise WrongByteCountError(
                f"the data have {len(message.data)} bytes: {rows} rows of {columns} points need {needed}"
            )
        fields = {field.name: field for field in message.fields}
        return PointCloud(*(coordinate(message, fields, axis) for axis in "xyz"))


def coordinate(message: Any, fields: dict[str, Any], axis: str) -> np.ndarray:
    """One coordinate of all points, (rows, columns) float32 metres: a view where the message has it so.

    Raises:
        UnsupportedFieldsError: it is missing, or no float.
    """
    there = ", ".join(fields) or "none"
    if axis not in fields:
        raise UnsupportedFieldsError(f"the cloud has no field {axis} (its fields: {there}): x, y and z are needed")
    field = fields[axis]
    kind = FLOATS.get(field.datatype)
    if kind is None or field.count not in {0, 1}:
        raise UnsupportedFieldsError(f"the field {axis} is no single FLOAT32 or FLOAT64 (datatype {field.datatype})")
    dtype = np.dtype((">" if message.is_bigendian else "<") + kind)
    if field.offset + dtype.itemsize > message.point_step:
        raise UnsupportedFieldsError(
            f"the field {axis} at byte {field.offset} reaches beyond the point_step of {message.point_step} bytes"
        )
    values: np.ndarray = np.ndarray(
        (message.height, message.width),
        dtype,
        message.data.data,
        offset=field.offset,
        strides=(message.row_step, message.point_step),
    )
    return values.astype(np.float32, copy=not values.flags.aligned)

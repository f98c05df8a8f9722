"""Foxglove's messages as protobuf, the only form of them that Foxglove and Rerun both show."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from google.protobuf.descriptor_pb2 import FieldDescriptorProto, FileDescriptorProto, FileDescriptorSet
from google.protobuf.descriptor_pool import DescriptorPool
from google.protobuf.duration_pb2 import DESCRIPTOR as DURATION_FILE
from google.protobuf.message_factory import GetMessageClass
from google.protobuf.timestamp_pb2 import DESCRIPTOR as TIMESTAMP_FILE

PACKAGE = "foxglove"
TIMESTAMP, DURATION = ".google.protobuf.Timestamp", ".google.protobuf.Duration"
SCALARS = {
    "bool": FieldDescriptorProto.TYPE_BOOL,
    "bytes": FieldDescriptorProto.TYPE_BYTES,
    "double": FieldDescriptorProto.TYPE_DOUBLE,
    "fixed32": FieldDescriptorProto.TYPE_FIXED32,
    "string": FieldDescriptorProto.TYPE_STRING,
}
REPEATED = "repeated "

MESSAGES: dict[str, dict[str, tuple[int, str]]] = {
    "Vector3": {name: (number, "double") for number, name in enumerate("xyz", 1)},
    "Quaternion": {name: (number, "double") for number, name in enumerate("xyzw", 1)},
    "Color": {name: (number, "double") for number, name in enumerate("rgba", 1)},
    "Pose": {"position": (1, "Vector3"), "orientation": (2, "Quaternion")},
    "PackedElementField": {"name": (1, "string"), "offset": (2, "fixed32"), "type": (3, "enum NumericType")},
    "PointCloud": {
        "timestamp": (1, TIMESTAMP),
        "frame_id": (2, "string"),
        "pose": (3, "Pose"),
        "point_stride": (4, "fixed32"),
        "fields": (5, "repeated PackedElementField"),
        "data": (6, "bytes"),
    },
    "FrameTransform": {
        "timestamp": (1, TIMESTAMP),
        "parent_frame_id": (2, "string"),
        "child_frame_id": (3, "string"),
        "translation": (4, "Vector3"),
        "rotation": (5, "Quaternion"),
    },
    "FrameTransforms": {"transforms": (1, "repeated FrameTransform")},
    "CubePrimitive": {"pose": (1, "Pose"), "size": (2, "Vector3"), "color": (3, "Color")},
    "SceneEntity": {
        "timestamp": (1, TIMESTAMP),
        "frame_id": (2, "string"),
        "id": (3, "string"),
        "lifetime": (4, DURATION),
        "frame_locked": (5, "bool"),
        "cubes": (8, "repeated CubePrimitive"),
    },
    "SceneUpdate": {"entities": (2, "repeated SceneEntity")},
}
"""Number and type of each field that is written here, as Foxglove publishes them."""
ENUMS = {
    "PackedElementField": {
        "NumericType": ("UNKNOWN", "UINT8", "INT8", "UINT16", "INT16", "UINT32", "INT32", "FLOAT32", "FLOAT64")
    }
}
"""Within a message: names of its values, counted from zero."""


def encode(name: str, content: Mapping[str, Any]) -> bytes:
    """A message, e.g. of `foxglove.PointCloud`, from the values of its fields by name."""
    encoded: bytes = _classes()[name](**content).SerializeToString()
    return encoded


@cache
def schema() -> bytes:
    """The definitions of all messages and of what they are made of, as MCAP wants them."""
    files = FileDescriptorSet(file=[_definitions()])
    for imported in (TIMESTAMP_FILE, DURATION_FILE):
        imported.CopyToProto(files.file.add())
    described: bytes = files.SerializeToString()
    return described


@cache
def _classes() -> Mapping[str, Any]:
    pool = DescriptorPool()
    for each in FileDescriptorSet.FromString(schema()).file[1:]:
        pool.Add(each)
    pool.Add(_definitions())
    names = (f"{PACKAGE}.{name}" for name in MESSAGES)
    return {name: GetMessageClass(pool.FindMessageTypeByName(name)) for name in names}


def _definitions() -> FileDescriptorProto:
    file = FileDescriptorProto(name="foxglove.proto", package=PACKAGE, syntax="proto3")
    file.dependency.extend([TIMESTAMP_FILE.name, DURATION_FILE.name])
    for name, fields in MESSAGES.items():
        message = file.message_type.add(name=name)
        for field, (number, kind) in fields.items():
            message.field.add(name=field, number=number, json_name=field, **_typed(kind, name))
        for enum, values in ENUMS.get(name, {}).items():
            message.enum_type.add(name=enum, value=[{"name": each, "number": i} for i, each in enumerate(values)])
    return file


def _typed(kind: str, owner: str) -> dict[str, Any]:
    """Label and type of a field, in the words of a descriptor."""
    single = kind.removeprefix(REPEATED)
    label = FieldDescriptorProto.LABEL_OPTIONAL if single == kind else FieldDescriptorProto.LABEL_REPEATED
    if single in SCALARS:
        return {"label": label, "type": SCALARS[single]}
    if single.startswith("enum "):
        of_enum = f".{PACKAGE}.{owner}.{single.removeprefix('enum ')}"
        return {"label": label, "type": FieldDescriptorProto.TYPE_ENUM, "type_name": of_enum}
    of_message = single if single.startswith(".") else f".{PACKAGE}.{single}"
    return {"label": label, "type": FieldDescriptorProto.TYPE_MESSAGE, "type_name": of_message}

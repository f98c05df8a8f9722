"""Messages are those of Foxglove, byte for byte."""

from typing import Any

import pytest

from captra.recording.protobuf import encode

STAMP = {"seconds": 1, "nanos": 2}
VECTOR = {"x": 1.0, "y": 2.0, "z": 3.0}
TURN = {"x": 0.5, "y": -0.5, "z": 0.5, "w": 0.5}
POSE = {"position": VECTOR, "orientation": TURN}
CUBE = {"pose": POSE, "size": VECTOR, "color": {"r": 0.25, "g": 0.5, "b": 0.75, "a": 1.0}}

HALF, THIRD, FIRST, SECOND = "000000000000e03f", "0000000000000840", "000000000000f03f", "0000000000000040"
VECTOR_HEX = f"09{FIRST}11{SECOND}19{THIRD}"
TURN_HEX = f"09{HALF}11000000000000e0bf19{HALF}21{HALF}"
POSE_HEX = f"0a1b{VECTOR_HEX}1224{TURN_HEX}"
CUBE_HEX = f"88010a43{POSE_HEX}121b{VECTOR_HEX}1a2409000000000000d03f11{HALF}19000000000000e83f21{FIRST}"
HEADER_HEX = "0a0408011002120663616d657261"
"""A stamp, then the name `camera`."""


@pytest.mark.parametrize(
    ("name", "content", "expected"),
    [
        (
            "foxglove.PointCloud",
            {
                "timestamp": STAMP,
                "frame_id": "camera",
                "pose": POSE,
                "point_stride": 12,
                "fields": [{"name": "x", "offset": 4, "type": 7}],
                "data": b"points",
            },
            f"{HEADER_HEX}1a43{POSE_HEX}250c0000002a0a0a0178150400000018073206706f696e7473",
        ),
        (
            "foxglove.FrameTransforms",
            {
                "transforms": [
                    {
                        "timestamp": STAMP,
                        "parent_frame_id": "camera",
                        "child_frame_id": "mug",
                        "translation": VECTOR,
                        "rotation": TURN,
                    }
                ]
            },
            f"0a56{HEADER_HEX}1a036d7567221b{VECTOR_HEX}2a24{TURN_HEX}",
        ),
        (
            "foxglove.SceneUpdate",
            {
                "entities": [
                    {
                        "timestamp": STAMP,
                        "frame_id": "camera",
                        "id": "mug",
                        "lifetime": STAMP,
                        "frame_locked": True,
                        "cubes": [CUBE],
                    }
                ]
            },
            f"12a601{HEADER_HEX}1a036d7567220408011002280142{CUBE_HEX}",
        ),
    ],
)
def test_a_message_is_what_foxgloves_own_package_writes(name: str, content: dict[str, Any], expected: str) -> None:
    """Expected are the bytes of foxglove-schemas-protobuf 0.4.0."""
    assert encode(name, content).hex() == expected

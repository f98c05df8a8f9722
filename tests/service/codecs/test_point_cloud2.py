from itertools import permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from captra.observations import Observation
from service.codecs import CDR, build_codecs
from service.envelopes import Envelope, pack_attachment
from service.rejections import (
    MalformedAttachmentError,
    MissingAttachmentError,
    UnknownEncodingError,
    UnsupportedFieldsError,
)
from service.ros2.attachments import RmwAttachment
from service.ros2.messages import type_hash
from tests.service.ros2.clouds import STAMP_NS, XYZ, cdr
from tests.service.support import Running, blob

CODECS = build_codecs(max_points=100_000, max_payload_bytes=10_000_000)
POINTS = np.random.default_rng(0).uniform(-1, 1, (6, 8, 3)).astype(np.float32)


def observe(payload: bytes) -> Observation:
    frame, _ = CODECS.open(Envelope(CDR, payload, None, 0.0))
    return frame.observe()


@settings(max_examples=60, deadline=None)
@given(
    order=st.sampled_from(list(permutations([*XYZ, ("intensity", "f4"), ("rgb", "u4"), ("ring", "u2")], 6))),
    kind=st.sampled_from(["f4", "f8"]),
    pad=st.sampled_from([0, 1, 3, 4]),
    row_pad=st.sampled_from([0, 5, 16]),
    big_endian_data=st.booleans(),
    big_endian_cdr=st.booleans(),
)
def test_any_layout_gives_the_same_points(
    order: list[tuple[str, str]], kind: str, pad: int, row_pad: int, big_endian_data: bool, big_endian_cdr: bool
) -> None:
    fields = [(name, kind if name in "xyz" else other) for name, other in order]
    payload = cdr(
        POINTS, fields, pad=pad, row_pad=row_pad, big_endian_data=big_endian_data, big_endian_cdr=big_endian_cdr
    )
    cloud = observe(payload)
    assert cloud.shape == (6, 8)
    np.testing.assert_array_equal(cloud.whole().points, POINTS.reshape(-1, 3))
    near = cloud.near(np.zeros(3), 0.9)
    inside = np.flatnonzero(np.linalg.norm(POINTS.reshape(-1, 3), axis=1) < 0.9)
    np.testing.assert_array_equal(near.indices, inside)
    np.testing.assert_array_equal(near.points, POINTS.reshape(-1, 3)[inside])


def test_organized_cloud_leaves_out_pixels_without_depth() -> None:
    points = POINTS.copy()
    points[1, 2] = np.nan
    points[3, 4, 2] = np.inf
    points[5, 0, 1] = np.nan
    cloud = observe(cdr(points))
    expected = np.flatnonzero(np.isfinite(points).all(axis=-1))
    assert len(expected) == 45
    np.testing.assert_array_equal(cloud.whole().indices, expected)
    np.testing.assert_array_equal(cloud.near(np.zeros(3), 9).indices, expected)


@pytest.mark.parametrize("fields", [[("x", "f4"), ("y", "f4")], [("x", "i2"), ("y", "i2"), ("z", "i2")]])
def test_clouds_without_float_coordinates_are_refused(fields: list[tuple[str, str]]) -> None:
    with pytest.raises(UnsupportedFieldsError):
        observe(cdr(POINTS, fields))


@pytest.mark.parametrize(
    ("attachment", "seq"), [(None, None), (pack_attachment(9, 5), 9), (RmwAttachment(8, 3, bytes(range(16))).pack(), 8)]
)
def test_stamp_and_frame_come_from_the_message_and_the_number_from_beside_it(
    attachment: bytes | None, seq: int | None
) -> None:
    frame, _ = CODECS.open(Envelope(CDR, cdr(POINTS), attachment, 0.0))
    assert (frame.header.seq, frame.header.stamp_ns) == (seq, STAMP_NS)
    assert frame.header.frame_id == "camera_depth_optical_frame"


@pytest.mark.parametrize("attachment", [bytes(8), bytes(32), bytes(33), bytes(34)])
def test_other_attachments_are_malformed(attachment: bytes) -> None:
    with pytest.raises(MalformedAttachmentError):
        CODECS.open(Envelope(CDR, cdr(POINTS), attachment, 0.0))


def test_an_empty_attachment_is_missing() -> None:
    with pytest.raises(MissingAttachmentError):
        CODECS.open(Envelope(CDR, cdr(POINTS), b"", 0.0))


@pytest.mark.parametrize("parameters", ["", ";sensor_msgs/msg/PointCloud2", "; schema=sensor_msgs/msg/PointCloud2"])
def test_schema_may_be_named(parameters: str) -> None:
    CODECS.open(Envelope(CDR + parameters, cdr(POINTS), None, 0.0))


def test_another_schema_is_refused() -> None:
    with pytest.raises(UnknownEncodingError, match="Image"):
        CODECS.open(Envelope(f"{CDR};sensor_msgs/msg/Image", cdr(POINTS), None, 0.0))


def test_type_hash_is_that_of_ros() -> None:
    expected = "RIHS01_9198cabf7da3796ae6fe19c4cb3bdd3525492988c70522628af5daa124bae2b5"
    assert type_hash("sensor_msgs/msg/PointCloud2") == expected


def test_by_http_stamp_and_frame_are_those_of_the_message(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    answer = service.post_frame(session_id, cdr(blob()), 4, CDR, stamp_ns=1)
    assert answer.status_code == 200, answer.text
    result = answer.json()
    assert (result["seq"], result["stamp_ns"], result["frame_id"]) == (4, STAMP_NS, "camera_depth_optical_frame")
    assert result["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=2e-3)

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from jaxtyping import Float32

from captra.observations import Observation, PointCloud
from service.codecs import CDR, CLOUD_F32, CLOUD_I16, Codecs, build_codecs
from service.envelopes import Envelope, FrameHeader, pack_attachment, unpack_attachment
from service.rejections import (
    CoordinatesOutOfRangeError,
    FrameRejectedError,
    MalformedAttachmentError,
    MissingAttachmentError,
    NotFiniteError,
    PayloadTooLargeError,
    TooManyPointsError,
    UnknownEncodingError,
    WrongByteCountError,
)
from tests.service.support import f32, i16

CODECS = build_codecs(max_points=1000, max_payload_bytes=20_000)


def observe(envelope: Envelope, codecs: Codecs = CODECS) -> Observation:
    frame, _ = codecs.open(envelope)
    return frame.observe()


def decode(payload: bytes, encoding: str = CLOUD_F32, codecs: Codecs = CODECS) -> Float32[np.ndarray, "points 3"]:
    return observe(Envelope(encoding, payload, pack_attachment(0, 0), 0.0), codecs).whole().points


@given(arrays.arrays(np.float32, (7, 3), elements=st.floats(-100, 100, width=32)))
def test_f32_round_trip_is_exact_and_shares_the_payload(points: Float32[np.ndarray, "7 3"]) -> None:
    payload = f32(points)
    cloud = observe(Envelope(CLOUD_F32, payload, pack_attachment(0, 0), 0.0))
    assert isinstance(cloud, PointCloud)
    np.testing.assert_array_equal(cloud.whole().points, points)
    assert np.shares_memory(cloud.x, np.frombuffer(payload, np.uint8))


@given(arrays.arrays(np.float32, (7, 3), elements=st.floats(-3.25, 3.25, width=32)))
def test_i16_round_trip_is_within_half_a_tenth_of_a_millimetre(points: Float32[np.ndarray, "7 3"]) -> None:
    decoded = decode(i16(points), CLOUD_I16)
    assert decoded.dtype == np.float32
    np.testing.assert_allclose(decoded, points, atol=0.51e-4)


@given(st.integers(0, 2**64 - 1), st.integers(-(2**63), 2**63 - 1))
def test_attachment_is_seq_and_stamp_little_endian(seq: int, stamp_ns: int) -> None:
    packed = pack_attachment(seq, stamp_ns)
    assert packed == seq.to_bytes(8, "little") + stamp_ns.to_bytes(8, "little", signed=True)
    assert unpack_attachment(packed) == FrameHeader(seq, stamp_ns)


@pytest.mark.parametrize("length", [0, 8, 15, 17, 33])
def test_attachment_of_another_length_is_malformed(length: int) -> None:
    with pytest.raises(MalformedAttachmentError):
        unpack_attachment(bytes(length))


def test_attachment_may_not_be_missing() -> None:
    with pytest.raises(MissingAttachmentError):
        unpack_attachment(None)


@pytest.mark.parametrize("encoding", [CLOUD_F32, CLOUD_I16])
def test_a_cloud_may_have_no_points(encoding: str) -> None:
    assert decode(b"", encoding).shape == (0, 3)


@pytest.mark.parametrize(("encoding", "length"), [(CLOUD_F32, 11), (CLOUD_F32, 16), (CLOUD_I16, 5), (CLOUD_I16, 8)])
def test_wrong_byte_count(encoding: str, length: int) -> None:
    with pytest.raises(WrongByteCountError):
        decode(bytes(length), encoding)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("index", [(0, 0), (9, 2), (4, 1)])
def test_not_finite(bad: float, index: tuple[int, int]) -> None:
    points = np.zeros((10, 3), np.float32)
    points[index] = bad
    with pytest.raises(NotFiniteError, match="1 of 10 points"):
        decode(f32(points))


@pytest.mark.parametrize("bad", [1.1e6, -1.1e6, 3e38])
def test_coordinates_out_of_range(bad: float) -> None:
    points = np.zeros((10, 3), np.float32)
    points[3, 1] = bad
    with pytest.raises(CoordinatesOutOfRangeError):
        decode(f32(points))


def test_too_many_points() -> None:
    assert len(decode(bytes(6 * 1000), CLOUD_I16)) == 1000
    with pytest.raises(TooManyPointsError):
        decode(bytes(6 * 1001), CLOUD_I16)


def test_payload_too_large() -> None:
    CODECS.check_size(20_000)
    with pytest.raises(PayloadTooLargeError):
        CODECS.check_size(20_001)


@pytest.mark.parametrize("encoding", ["", "zenoh/bytes", "image/png", "application/json"])
def test_unknown_encoding_names_the_known_ones(encoding: str) -> None:
    with pytest.raises(UnknownEncodingError, match=CLOUD_F32):
        CODECS.find(encoding)


@pytest.mark.parametrize("encoding", [CLOUD_F32.upper(), f" {CLOUD_F32}", f"{CLOUD_F32}; a=b", f"{CLOUD_F32};schema"])
def test_case_and_parameters_of_an_encoding_do_not_matter(encoding: str) -> None:
    assert CODECS.find(encoding).encoding == CLOUD_F32


@given(st.sampled_from([CLOUD_F32, CLOUD_I16, CDR]), st.binary(max_size=200), st.none() | st.binary(max_size=40))
def test_any_bytes_are_read_or_refused(encoding: str, payload: bytes, attachment: bytes | None) -> None:
    try:
        points = observe(Envelope(encoding, payload, attachment, 0.0)).whole().points
    except FrameRejectedError:
        return
    assert np.isfinite(points).all()
    assert len(points) >= 1

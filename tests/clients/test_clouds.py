import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from clients.clouds import BATCH_BYTES, ENCODINGS, attachment, crop_ball, encode_f32, encode_i16, get_encoding, thin_out

near = arrays(np.float32, st.tuples(st.integers(1, 50), st.just(3)), elements=st.floats(-3.25, 3.25, width=32))


@given(near)
def test_i16_keeps_points_to_half_a_tenth_of_a_millimetre(points: np.ndarray) -> None:
    decoded = np.frombuffer(encode_i16(points), "<i2").reshape(-1, 3) * 1e-4
    assert np.abs(decoded - points).max() <= 0.5e-4 + 1e-6


@given(near)
def test_f32_keeps_points_exactly(points: np.ndarray) -> None:
    assert np.array_equal(np.frombuffer(encode_f32(points), "<f4").reshape(-1, 3), points)


@pytest.mark.parametrize("name", ENCODINGS)
def test_pixels_without_depth_are_left_out(name: str) -> None:
    points = np.array([[0, 0, 1], [np.nan, 0, 1], [0, np.inf, 1], [0, 1, 2]], np.float64)
    whole = ENCODINGS[name].encode(points)
    assert whole == ENCODINGS[name].encode(points[[0, 3]])


def test_an_organized_cloud_is_a_list_of_points() -> None:
    grid = np.arange(24, dtype=np.float32).reshape(2, 4, 3) / 100
    assert encode_f32(grid) == encode_f32(grid.reshape(-1, 3))


@pytest.mark.parametrize("shape", [(3, 100), (9,), (5, 4)])
def test_other_shapes_are_refused(shape: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match="a cloud has the shape"):
        encode_f32(np.zeros(shape))


def test_i16_leaves_out_what_it_cannot_express_and_refuses_to_send_nothing() -> None:
    assert encode_i16(np.array([[0, 0, 1.0], [0, 0, 3.3]])) == encode_i16(np.array([[0, 0, 1.0]]))
    with pytest.raises(ValueError, match="encoding='f32'"):
        encode_i16(np.array([[0, 0, 4.0]]))


def test_an_empty_cloud_is_left_for_the_service_to_refuse() -> None:
    assert encode_i16(np.zeros((0, 3))) == encode_f32(np.zeros((0, 3))) == b""


def test_unknown_encodings_are_named_with_the_known_ones() -> None:
    with pytest.raises(ValueError, match="'f64': use one of i16, f32"):
        get_encoding("f64")


def test_attachment_is_sequence_number_and_stamp() -> None:
    assert attachment(1, -2) == bytes([1, 0, 0, 0, 0, 0, 0, 0, 254, 255, 255, 255, 255, 255, 255, 255])


def test_crop_ball_keeps_what_is_within_the_radius() -> None:
    points = np.array([[0, 0, 1], [0, 0.2, 1], [0, 0, 1.4]])
    assert crop_ball(points, np.array([0, 0, 1]), 0.3).tolist() == points[:2].tolist()


@given(st.integers(0, 40_000))
def test_a_thinned_cloud_fits_one_batch_and_keeps_both_ends(count: int) -> None:
    points = np.linspace(0, 1, 3 * count).reshape(count, 3)
    thin = thin_out(points)
    assert len(encode_i16(thin)) <= BATCH_BYTES
    assert len(thin) == min(count, BATCH_BYTES // 6)
    if count:
        assert np.array_equal(thin[[0, -1]], points[[0, -1]])

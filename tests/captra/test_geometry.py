import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra import geometry

SEEDS = st.integers(0, 2**32 - 1)
ANGLES = st.one_of(st.floats(0, np.pi), st.sampled_from([0.0, 1e-9, 1e-6, np.pi - 1e-7, np.pi]))


def random_rotation(seed: int, angle: float) -> np.ndarray:
    return geometry.axis_angle(np.random.default_rng(seed).standard_normal(3), angle)


@given(SEEDS, ANGLES)
def test_quaternion_round_trip_at_every_angle(seed: int, angle: float) -> None:
    rotation = random_rotation(seed, angle)
    quat_xyzw = geometry.quat_xyzw_from_matrix(rotation)
    assert quat_xyzw[3] >= 0
    np.testing.assert_allclose(np.linalg.norm(quat_xyzw), 1)
    np.testing.assert_allclose(geometry.matrix_from_quat_xyzw(quat_xyzw), rotation, atol=1e-9)


def test_quaternions_are_ordered_x_y_z_w() -> None:
    quarter_turn_about_z = geometry.matrix_from_quat_xyzw(np.array([0, 0, np.sqrt(0.5), np.sqrt(0.5)]))
    np.testing.assert_allclose(quarter_turn_about_z @ [1, 0, 0], [0, 1, 0], atol=1e-12)


@given(SEEDS, ANGLES)
def test_angle_of_axis_angle(seed: int, angle: float) -> None:
    np.testing.assert_allclose(geometry.rotation_angle(random_rotation(seed, angle)), angle, atol=1e-6)


@given(SEEDS, st.floats(0, 3))
def test_composition_of_opposite_turns_is_identity(seed: int, angle: float) -> None:
    turn = random_rotation(seed, angle) @ random_rotation(seed, -angle)
    np.testing.assert_allclose(turn, np.eye(3), atol=1e-12)


@given(SEEDS, st.floats(0, 0.2))
def test_projection_is_the_nearest_rotation(seed: int, noise: float) -> None:
    rng = np.random.default_rng(seed)
    matrix = random_rotation(seed, 1.0) + noise * rng.standard_normal((3, 3))
    nearest = geometry.project_to_rotation(matrix)
    assert geometry.is_rotation(nearest, 1e-9)
    other = nearest @ geometry.axis_angle(rng.standard_normal(3), 0.05)
    assert np.linalg.norm(matrix - nearest) <= np.linalg.norm(matrix - other) + 1e-12


def test_projection_never_returns_a_reflection() -> None:
    assert np.linalg.det(geometry.project_to_rotation(np.diag([1.0, 1.0, -1.0]))) == pytest.approx(1)


@given(SEEDS, ANGLES)
def test_six_numbers_give_back_the_first_two_columns(seed: int, angle: float) -> None:
    rotation = random_rotation(seed, angle)
    vector = np.concatenate([3 * rotation[:, 0], 2 * rotation[:, 1] + 0.5 * rotation[:, 0]])
    np.testing.assert_allclose(geometry.rotation_from_6d(vector), rotation, atol=1e-9)


@given(SEEDS)
def test_axis_becomes_the_y_column(seed: int) -> None:
    axis = np.random.default_rng(seed).standard_normal(3)
    rotation = geometry.rotation_from_axis(axis)
    assert geometry.is_rotation(rotation, 1e-9)
    np.testing.assert_allclose(rotation[:, 1], axis / np.linalg.norm(axis))


@pytest.mark.parametrize(
    "matrix",
    [np.eye(3) * 1.1, np.diag([1.0, 1.0, -1.0]), np.full((3, 3), np.nan), np.eye(4), np.zeros((3, 3))],
)
def test_what_is_no_rotation(matrix: np.ndarray) -> None:
    assert not geometry.is_rotation(matrix)


def test_scale_of_a_given_pose_is_the_diagonal_of_its_box() -> None:
    pose = geometry.Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.array([[0.3, 0.4, 1.2]]))
    np.testing.assert_allclose(pose.scale, [1.3])
    corners = geometry.box_corners(pose.size)[0]
    assert len(np.unique(corners, axis=0)) == 8
    np.testing.assert_allclose(np.ptp(corners, axis=0), pose.size[0])
    np.testing.assert_allclose(np.linalg.norm(corners, axis=1), 0.65)


def test_part_keeps_the_leading_axis() -> None:
    pose = geometry.Pose.from_size(np.stack([np.eye(3)] * 3), np.arange(9.0).reshape(3, 3), np.ones((3, 3)))
    assert pose.part(1).num_parts == 1
    np.testing.assert_array_equal(pose.part(1).translation, [[3, 4, 5]])

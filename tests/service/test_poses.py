import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import CATEGORIES
from captra.geometry import axis_angle, is_rotation, quat_xyzw_from_matrix, rotation_angle
from service.rejections import NotARotationError
from service.rest.inputs import Part, Rotation
from service.rest.poses import pose_of, rotation_of

angles = st.floats(-3, 3)
axes = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda axis: np.linalg.norm(axis) > 1e-3)


@given(axes, angles)
def test_quaternion_and_matrix_give_the_rotation_they_mean(axis: tuple[float, ...], angle: float) -> None:
    rotation = axis_angle(np.array(axis), angle)
    by_matrix = rotation_of(Rotation(matrix=rotation.tolist()), "mug")
    by_quaternion = rotation_of(Rotation(quat_xyzw=quat_xyzw_from_matrix(rotation).tolist()), "mug")
    for given_rotation in (by_matrix, by_quaternion):
        assert rotation_angle(rotation.T @ given_rotation) < 1e-6


@given(axes, angles, st.integers(0, 2**32 - 1))
def test_rounding_of_single_precision_is_forgiven_and_removed(axis: tuple[float, ...], angle: float, seed: int) -> None:
    rotation = axis_angle(np.array(axis), angle)
    rounded = rotation + np.random.default_rng(seed).uniform(-1e-5, 1e-5, (3, 3))
    cleaned = rotation_of(Rotation(matrix=rounded.tolist()), "mug")
    assert is_rotation(cleaned, 1e-12)
    assert rotation_angle(rotation.T @ cleaned) < 1e-4


@given(st.tuples(*[st.floats(-1e300, 1e300)] * 9))
def test_any_nine_numbers_are_a_rotation_or_refused(numbers: tuple[float, ...]) -> None:
    matrix = np.reshape(numbers, (3, 3)).tolist()
    try:
        rotation = rotation_of(Rotation(matrix=matrix), "mug")
    except NotARotationError:
        return
    assert is_rotation(rotation)


def test_mirror_is_no_rotation() -> None:
    with pytest.raises(NotARotationError, match="display"):
        rotation_of(Rotation(matrix=[[1, 0, 0], [0, 1, 0], [0, 0, -1]]), "display")


def test_parts_keep_their_order() -> None:
    parts = [
        Part(rotation=Rotation(quat_xyzw=[0, 0, 0, 1]), translation=[x, 0, 1], size=[0.1 + x, 0.2, 0.3])
        for x in (0.0, 0.5)
    ]
    pose = pose_of(parts, CATEGORIES["laptop_articulated"])
    assert pose.translation[:, 0].tolist() == [0, 0.5]
    assert pose.size[:, 0].tolist() == [0.1, 0.6]
    np.testing.assert_allclose(pose.scale, np.linalg.norm(pose.size, axis=1))

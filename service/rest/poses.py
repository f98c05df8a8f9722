"""From the parts that a client gives to a pose, refusing what is none."""

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.geometry import Pose, is_rotation, matrix_from_quat_xyzw, project_to_rotation
from service.rejections import (
    ImplausiblePoseError,
    NotARotationError,
    SizeNotPositiveError,
    WrongNumberOfPartsError,
)
from service.rest.inputs import Part, Rotation

SMALLEST_EDGE_M, LARGEST_EDGE_M, FARTHEST_M = 1e-4, 4.0, 1e4
"""Cabinets are smaller than the largest edge; whatever is tracked measures more centimetres than that."""
TOLERANCE = 1e-3
"""How far a quaternion may be from unit length, and a matrix from orthonormal."""
ORTHONORMAL = 1e-12
"""How far rounding leaves a matrix from orthonormal."""


def pose_of(parts: Sequence[Part], category: Category) -> Pose:
    """The pose that a client gives.

    Raises:
        WrongNumberOfPartsError: not one entry for each part of the category.
        NotARotationError: a quaternion is not of unit length, or a matrix is no rotation.
        SizeNotPositiveError: an edge of a box is zero or negative.
        ImplausiblePoseError: a box is so large, small or far that it cannot be in metres.
    """
    if len(parts) != category.num_parts:
        names = ", ".join(category.parts)
        raise WrongNumberOfPartsError(
            f"{category.name} has {category.num_parts} parts ({names}), {len(parts)} are given: "
            "give each of them, in this order"
        )
    rotations = [rotation_of(part.rotation, name) for part, name in zip(parts, category.parts, strict=True)]
    sizes = np.array([part.size for part in parts], np.float64)
    translations = np.array([part.translation for part in parts], np.float64)
    check_boxes(translations, sizes)
    return Pose.from_size(np.stack(rotations), translations, sizes)


def rotation_of(rotation: Rotation, part: str) -> Float64[np.ndarray, "3 3"]:
    """R_camera_part, made exactly orthonormal.

    Raises:
        NotARotationError: it is too far from a rotation.
    """
    if rotation.quat_xyzw is not None:
        quat_xyzw = np.array(rotation.quat_xyzw, np.float64)
        length = float(np.linalg.norm(quat_xyzw)) if np.abs(quat_xyzw).max() < 2 else np.inf
        if abs(length - 1) > TOLERANCE:
            raise NotARotationError(
                f"the quaternion of {part} has the length {length:g}, not 1: normalize it (x, y, z, w)"
            )
        return matrix_from_quat_xyzw(quat_xyzw / length)
    matrix = np.array(rotation.matrix, np.float64)
    if np.abs(matrix).max() > 2 or not is_rotation(matrix, TOLERANCE):
        raise NotARotationError(
            f"the matrix of {part} is no rotation: its rows must be orthonormal and right-handed, without scale. "
            "Mirrored axes (determinant −1), a matrix with scale, or one of another shape?"
        )
    # What is as orthonormal as numbers can be stays as it is, so that a recorded pose replays to the last digit.
    return matrix if is_rotation(matrix, ORTHONORMAL) else project_to_rotation(matrix)


def check_boxes(translations: Float64[np.ndarray, "parts 3"], sizes: Float64[np.ndarray, "parts 3"]) -> None:
    """Refuse boxes that are none, or not in metres.

    Raises:
        SizeNotPositiveError: an edge is zero or negative.
        ImplausiblePoseError: an edge or a distance is out of range.
    """
    if (sizes <= 0).any():
        raise SizeNotPositiveError(f"the smallest edge is {sizes.min():g} m: every edge of a box is longer than zero")
    if sizes.min() < SMALLEST_EDGE_M or sizes.max() > LARGEST_EDGE_M:
        raise ImplausiblePoseError(
            f"edges measure {sizes.min():g} to {sizes.max():g} m, outside {SMALLEST_EDGE_M:g} to {LARGEST_EDGE_M:g} m: "
            "sizes are in metres; divide centimetres by 100, millimetres by 1000"
        )
    farthest = np.abs(translations).max()
    if farthest > FARTHEST_M:
        raise ImplausiblePoseError(
            f"the box is {farthest:g} m away: translations are in metres, in the camera frame; "
            "divide millimetres by 1000"
        )

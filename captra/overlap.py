"""Volume of the intersection of two boxes, exactly."""

import numpy as np
from jaxtyping import Float64

from captra.compiled import compiled
from captra.geometry import box_corners

_FACES = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
_SHRINK = 1 - 1e-6
"""More than what rotations in single precision lack of being orthonormal."""
_MOST_VERTICES = 16


@compiled
def _faces_inside(
    corners: Float64[np.ndarray, "8 3"],
    faces: Float64[np.ndarray, "6 4"],
    half: Float64[np.ndarray, "3"],
    origin: Float64[np.ndarray, "3"],
) -> float:
    """Six times the volume of the cones from `origin` to what lies of each face in the centred box of half extents."""
    total = 0.0
    polygon = np.empty((_MOST_VERTICES, 3))
    clipped = np.empty((_MOST_VERTICES, 3))
    for f in range(6):
        count = 4
        for i in range(4):
            polygon[i] = corners[faces[f, i]]
        for axis in range(3):
            for sign in (-1.0, 1.0):
                kept = 0
                for i in range(count):
                    a, b = polygon[i], polygon[(i + 1) % count]
                    inside_a, inside_b = half[axis] - sign * a[axis], half[axis] - sign * b[axis]
                    if inside_a >= 0:
                        clipped[kept] = a
                        kept += 1
                    if (inside_a >= 0) != (inside_b >= 0):
                        clipped[kept] = a + (b - a) * (inside_a / (inside_a - inside_b))
                        kept += 1
                count = kept
                polygon[:count] = clipped[:count]
        for i in range(1, count - 1):
            total += np.dot(polygon[0] - origin, np.cross(polygon[i] - origin, polygon[i + 1] - origin))
    return total


def intersection_volume(
    size_a: Float64[np.ndarray, "3"],
    size_b: Float64[np.ndarray, "3"],
    R_a_b: Float64[np.ndarray, "3 3"],
    t_a_b: Float64[np.ndarray, "3"],
) -> float:
    """Volume shared by box a and box b, whose centre and axes are given in a's frame.

    The boundary of the intersection is the faces of each box inside the other; the divergence theorem sums them up.
    b is shrunk by a millionth, so that coinciding faces count once.
    """
    centre_a_in_b = -R_a_b.T @ t_a_b
    corners_b_in_a = box_corners(size_b * _SHRINK) @ R_a_b.T + t_a_b
    corners_a_in_b = box_corners(size_a) @ R_a_b + centre_a_in_b
    of_b = _faces_inside(corners_b_in_a, _FACES, size_a / 2, np.zeros(3))
    of_a = _faces_inside(corners_a_in_b, _FACES, size_b * _SHRINK / 2, centre_a_in_b)
    return max(0.0, float(of_a + of_b) / 6)

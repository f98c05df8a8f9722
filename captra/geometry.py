"""Rotations, similarities and boxes in NumPy, double precision, metres and radians."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

Array = np.ndarray


@dataclass(frozen=True)
class Pose:
    """9DoF pose of all P parts of one object, in the frame of the cloud."""

    rotation: Float64[Array, "parts 3 3"]
    """R_camera_part, columns are the part's axes."""
    translation: Float64[Array, "parts 3"]
    """Centre of each part's box, metres."""
    scale: Float64[Array, " parts"]
    """The similarity's scale, metres: the diagonal of the box in normalized coordinates is 1."""
    size: Float64[Array, "parts 3"]
    """Extent of each part's box along its own axes, metres."""

    @staticmethod
    def from_size(
        rotation: Float[Array, "parts 3 3"], translation: Float[Array, "parts 3"], size: Float[Array, "parts 3"]
    ) -> "Pose":
        """Make a pose whose scale is the diagonal of its box, as a client gives it."""
        size = np.asarray(size, np.float64)
        return Pose(
            rotation=np.asarray(rotation, np.float64),
            translation=np.asarray(translation, np.float64),
            scale=np.linalg.norm(size, axis=-1),
            size=size,
        )

    @property
    def num_parts(self) -> int:
        """P."""
        return len(self.scale)

    def part(self, index: int) -> "Pose":
        """The pose of one part, still with a leading axis of length 1."""
        chosen = slice(index, index + 1)
        return Pose(self.rotation[chosen], self.translation[chosen], self.scale[chosen], self.size[chosen])


def matrix_from_quat_xyzw(quat_xyzw: Float[Array, "*batch 4"]) -> Float64[Array, "*batch 3 3"]:
    """Rotation matrices of unit quaternions in the order x, y, z, w."""
    x, y, z, w = np.moveaxis(np.asarray(quat_xyzw, np.float64), -1, 0)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def quat_xyzw_from_matrix(rotation: Float[Array, "*batch 3 3"]) -> Float64[Array, "*batch 4"]:
    """Unit quaternions in the order x, y, z, w with w ≥ 0.

    The quaternion is the dominant eigenvector of a 4×4 matrix linear in R (Bar-Itzhack, 2000): stable for every angle.
    """
    r = np.asarray(rotation, np.float64)
    matrix = np.empty((*r.shape[:-2], 4, 4))
    trace = np.trace(r, axis1=-2, axis2=-1)
    matrix[..., :3, :3] = r + np.swapaxes(r, -1, -2) - trace[..., None, None] * np.eye(3)
    vector = np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], axis=-1)
    matrix[..., :3, 3] = vector
    matrix[..., 3, :3] = vector
    matrix[..., 3, 3] = trace
    quat = np.linalg.eigh(matrix)[1][..., -1]
    return np.where(quat[..., 3:] < 0, -quat, quat)


def axis_angle(axis: Float[Array, "*batch 3"], angle: Float[Array, "*batch"] | float) -> Float64[Array, "*batch 3 3"]:
    """Rotation by `angle` radians about `axis`, which need not be of unit length (Rodrigues)."""
    axis = np.asarray(axis, np.float64)
    half = np.broadcast_to(np.asarray(angle, np.float64), axis.shape[:-1])[..., None] / 2
    unit = axis / np.linalg.norm(axis, axis=-1, keepdims=True)
    return matrix_from_quat_xyzw(np.concatenate([unit * np.sin(half), np.cos(half)], axis=-1))


def rotation_angle(rotation: Float[Array, "*batch 3 3"]) -> Float64[Array, "*batch"]:
    """Angle of a rotation in radians, in [0, π], accurate also near both ends."""
    r = np.asarray(rotation, np.float64)
    sine = np.linalg.norm(
        np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], axis=-1),
        axis=-1,
    )
    return np.asarray(np.arctan2(sine, np.trace(r, axis1=-2, axis2=-1) - 1))


def rotation_vector(rotation: Float[Array, "*batch 3 3"]) -> Float64[Array, "*batch 3"]:
    """Axis times angle, radians, of rotations whose angle is well below π: the inverse of `axis_angle`."""
    r = np.asarray(rotation, np.float64)
    vector = np.stack([r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]], axis=-1)
    sine = np.linalg.norm(vector, axis=-1, keepdims=True)
    return np.asarray(np.where(sine > 1e-9, rotation_angle(r)[..., None] / np.maximum(sine, 1e-9), 0.5) * vector)


def rotation_from_vector(vector: Float[Array, "*batch 3"]) -> Float64[Array, "*batch 3 3"]:
    """Rotation by the length of each vector, radians, about its direction; identity for zero."""
    v = np.asarray(vector, np.float64)
    angle = np.linalg.norm(v, axis=-1)
    return axis_angle(np.where(angle[..., None] > 0, v, [1.0, 0.0, 0.0]), angle)


def is_rotation(matrix: Float[Array, "*batch 3 3"], tolerance: float = 1e-3) -> bool:
    """Whether every matrix is finite, orthonormal within `tolerance` and right-handed."""
    m = np.asarray(matrix, np.float64)
    if m.shape[-2:] != (3, 3) or not np.isfinite(m).all():
        return False
    orthonormal = np.abs(np.swapaxes(m, -1, -2) @ m - np.eye(3)).max() <= tolerance
    return bool(orthonormal and (np.linalg.det(m) > 0).all())


def project_to_rotation(matrix: Float[Array, "*batch 3 3"]) -> Float64[Array, "*batch 3 3"]:
    """The rotation nearest to each matrix in the Frobenius norm (SVD; Moakher 2002, Euclidean mean)."""
    u, _, vt = np.linalg.svd(np.asarray(matrix, np.float64))
    u[..., :, 2] *= np.sign(np.linalg.det(u @ vt))[..., None]
    return np.asarray(u @ vt)


def _normalize(vector: Float[Array, "*batch 3"]) -> Float[Array, "*batch 3"]:
    return np.asarray(vector / np.maximum(np.linalg.norm(vector, axis=-1, keepdims=True), 1e-8))


def rotation_from_6d(vector: Float[Array, "*batch 6"]) -> Float64[Array, "*batch 3 3"]:
    """Continuous 6D representation → matrix: x from the first three, z ⟂ both, y = z × x (Zhou et al. 2019)."""
    v = np.asarray(vector, np.float64)
    x = _normalize(v[..., :3])
    z = _normalize(np.cross(x, v[..., 3:]))
    return np.stack([x, np.cross(z, x), z], axis=-1)


def rotation_from_axis(vector: Float[Array, "*batch 3"]) -> Float64[Array, "*batch 3 3"]:
    """Direction of the y axis → matrix, for objects symmetric about y: z = e_x × y, x = y × z."""
    y = _normalize(np.asarray(vector, np.float64))
    z = _normalize(np.cross(np.broadcast_to([1.0, 0.0, 0.0], y.shape), y))
    return np.stack([np.cross(y, z), y, z], axis=-1)


def box_corners(size: Float[Array, "*batch 3"]) -> Float64[Array, "*batch 8 3"]:
    """The eight corners of centred boxes, in the box's own frame."""
    signs = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    return np.asarray(np.asarray(size, np.float64)[..., None, :] * signs)

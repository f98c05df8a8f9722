"""Closed loops, mirror images and bends: what frames, rings and wrapped fronts are made of."""

import numpy as np
from jaxtyping import Float, Float64

from captra.data.shapes.mesh import Mesh, grid_mesh


def closed_sweep(
    curve: Float[np.ndarray, "K 3"], section: Float[np.ndarray, "*K S 2"], plane_normal: Float[np.ndarray, " 3"]
) -> Mesh:
    """Sweep a closed cross-section (in-plane normal, plane normal) along a closed planar curve.

    The in-plane normal points inwards where the curve runs counter-clockwise seen against `plane_normal`. The last
    point of the curve is not the first one again.
    """
    tangent = np.roll(curve, -1, axis=0) - np.roll(curve, 1, axis=0)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    normal = np.cross(plane_normal, tangent)
    across = np.cross(tangent, normal)
    sections = np.broadcast_to(section, (len(curve), *section.shape[-2:]))
    rings = curve[:, None] + sections[..., :1] * normal[:, None] + sections[..., 1:] * across[:, None]
    return _joined(grid_mesh(np.concatenate([rings, rings[:1]]), caps=False), rings.shape[0] * rings.shape[1])


def _joined(mesh: Mesh, count: int) -> Mesh:
    """Let the repeated last ring be the first one."""
    return Mesh(mesh.vertices[:count], mesh.faces % np.int32(count))


def mirrored(mesh: Mesh, axis: int) -> Mesh:
    """Mirror image across the plane through the origin normal to an axis; faces stay wound outwards."""
    signs = np.ones(3, np.float32)
    signs[axis] = -1
    return Mesh(mesh.vertices * signs, np.ascontiguousarray(mesh.faces[:, ::-1]))


def bent(points: Float[np.ndarray, "N 3"], radius: float) -> Float64[np.ndarray, "N 3"]:
    """Wrap the x-y plane around a cylinder along y of this radius behind it (towards -z); x is the arc length."""
    angle = points[:, 0] / radius
    reach = radius + points[:, 2]
    return np.stack([reach * np.sin(angle), points[:, 1], reach * np.cos(angle) - radius], axis=-1)


def bent_mesh(mesh: Mesh, radius: float) -> Mesh:
    """As `bent`, for a mesh."""
    return Mesh(bent(mesh.vertices.astype(np.float64), radius).astype(np.float32), mesh.faces)

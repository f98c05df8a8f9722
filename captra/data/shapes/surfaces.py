"""Surfaces of revolution, sweeps and simple solids."""

import numpy as np
from jaxtyping import Float

from captra.data.shapes.curves import rounded_polyline, superellipse, superellipse_factor
from captra.data.shapes.mesh import Mesh, grid_mesh

SEGMENTS = 40
"""Vertices around a surface of revolution: 0.15 mm from the true circle at a radius of 5 cm."""


def revolve(
    profile: Float[np.ndarray, "K 2"],
    factor: Float[np.ndarray, "K S"] | Float[np.ndarray, " S"] | None = None,
    segments: int = SEGMENTS,
) -> Mesh:
    """Turn a profile of (radius, y) about the y axis; from the lower outside over the top it encloses a solid.

    `factor` multiplies the radius by direction (and station), which makes squared, oval, faceted or fluted
    bodies. Directions are counted from +x towards -z.
    """
    radial = np.ones(segments) if factor is None else np.asarray(factor)
    around = radial.shape[-1]
    angle = np.arange(around) * (2 * np.pi / around)
    radius = profile[:, :1] * radial
    rings = np.stack(
        [radius * np.cos(angle), np.broadcast_to(profile[:, 1:], radius.shape), -radius * np.sin(angle)], axis=-1
    )
    on_axis = profile[:, 0] < 1e-7
    return grid_mesh(rings[~on_axis], caps=True) if not on_axis.any() else _with_poles(rings, on_axis)


def _with_poles(rings: Float[np.ndarray, "K S 3"], on_axis: Float[np.ndarray, " K"]) -> Mesh:
    body = grid_mesh(rings[~on_axis], caps=True)
    vertices = body.vertices.copy()
    if on_axis[0]:
        vertices[-2] = rings[0, 0]
    if on_axis[-1]:
        vertices[-1] = rings[-1, 0]
    return Mesh(vertices, body.faces)


def sweep(
    curve: Float[np.ndarray, "K 3"], section: Float[np.ndarray, "K S 2"], plane_normal: Float[np.ndarray, " 3"]
) -> Mesh:
    """Sweep a closed cross-section (in-plane normal, plane normal) along a planar curve, with flat ends."""
    tangent = np.gradient(curve, axis=0)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    normal = np.cross(plane_normal, tangent)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-9)
    across = np.cross(tangent, normal)
    rings = curve[:, None] + section[..., :1] * normal[:, None] + section[..., 1:] * across[:, None]
    return grid_mesh(rings, caps=True)


def tube(
    curve: Float[np.ndarray, "K 3"],
    radius: Float[np.ndarray, " K"] | float,
    plane_normal: Float[np.ndarray, " 3"],
    segments: int = 8,
) -> Mesh:
    """Round tube along a planar curve, its ends tapered to half their radius."""
    radii = np.broadcast_to(np.asarray(radius, np.float64), (len(curve),))
    first, last = curve[0] - curve[1], curve[-1] - curve[-2]
    ends = [v / max(float(np.linalg.norm(v)), 1e-9) for v in (first, last)]
    curve = np.concatenate([[curve[0] + ends[0] * radii[0] * 0.7], curve, [curve[-1] + ends[1] * radii[-1] * 0.7]])
    radii = np.concatenate([[radii[0] * 0.5], radii, [radii[-1] * 0.5]])
    return sweep(curve, radii[:, None, None] * superellipse(segments, 2.0), plane_normal)


def box(size: Float[np.ndarray, " 3"] | tuple[float, float, float]) -> Mesh:
    """Box centred at the origin."""
    corners = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]) * np.asarray(size)
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    faces = [face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]
    return Mesh(corners.astype(np.float32), np.array(faces, np.int32))


def rounded_box(size: tuple[float, float, float], exponent: float, fillet: float, segments: int = 32) -> Mesh:
    """Superellipse of x and z extruded along y, its upper and lower edges rounded by `fillet` metres."""
    angle = np.arange(segments) * (2 * np.pi / segments)
    half = size[1] / 2
    outline = rounded_polyline(np.array([[0, -half], [1, -half], [1, half], [0, half]]), 0.0)
    inset = min(fillet, 0.45 * min(size)) * 2 / min(size[0], size[2])
    if inset > 1e-3:
        drop = inset * min(size[0], size[2]) / 2
        corner = np.linspace(0, np.pi / 2, 4)
        low = np.stack([1 - inset + inset * np.sin(corner), -half + drop * (1 - np.cos(corner))], -1)
        outline = np.concatenate([[[0, -half]], low, low[::-1] * [1, -1], [[0, half]]])
    body = revolve(outline, superellipse_factor(angle, exponent))
    return body.stretched(np.array([size[0] / 2, 1, size[2] / 2]))


def superellipsoid(size: tuple[float, float, float], exponent: float = 2.0, segments: int = 20) -> Mesh:
    """Ellipsoid-like solid with extents `size`; larger exponents are boxier."""
    latitude = np.linspace(-np.pi / 2, np.pi / 2, max(6, segments // 2))
    power = 2 / exponent
    profile = np.stack([np.abs(np.cos(latitude)) ** power, np.sign(latitude) * np.abs(np.sin(latitude)) ** power], -1)
    profile[0, 0] = profile[-1, 0] = 0
    angle = np.arange(segments) * (2 * np.pi / segments)
    return revolve(profile, superellipse_factor(angle, exponent)).stretched(np.asarray(size) / 2)


def capsule(length: float, radius: float, top_radius: float | None = None, segments: int = 14) -> Mesh:
    """Capsule along y from 0 to `length` (centres of its round ends), tapering to `top_radius`."""
    top = radius if top_radius is None else top_radius
    a = np.linspace(-np.pi / 2, 0, 4)
    low = np.stack([radius * np.cos(a), radius * np.sin(a)], -1)
    high = np.stack([top * np.cos(a[::-1]), length - top * np.sin(a[::-1])], -1)
    profile = np.concatenate([low, high])
    profile[0, 0] = profile[-1, 0] = 0
    return revolve(profile, segments=segments)


def inset(profile: Float[np.ndarray, "K 2"], distance: float) -> Float[np.ndarray, "K 2"]:
    """Move a profile towards its inside along the normals (the outside lies right of the direction of travel)."""
    tangent = np.gradient(profile, axis=0)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    return profile + distance * np.stack([-tangent[:, 1], tangent[:, 0]], -1)

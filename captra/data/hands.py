"""Crude hands and grippers that touch an object, in the object frame."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64
from scipy.spatial import ConvexHull

from captra.data.shapes.curves import superellipse
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import box, capsule, superellipsoid, tube

_DIRECTIONS = superellipse(12, 2.0)


@dataclass(frozen=True)
class GripFrame:
    """Right-handed frame of a grasp: the fingers close in the plane of `across` and `out`."""

    axis: Float64[np.ndarray, " 3"]
    """Fingers lie side by side along it."""
    across: Float64[np.ndarray, " 3"]
    """First direction of the closing plane."""
    out: Float64[np.ndarray, " 3"]
    """Second direction of the closing plane."""

    def flat(self, points: Float[np.ndarray, "N 3"]) -> Float64[np.ndarray, "N 2"]:
        """Coordinates in the closing plane."""
        return np.asarray(points @ np.stack([self.across, self.out], -1))

    def raised(self, flat: Float[np.ndarray, "N 2"], height: float) -> Float64[np.ndarray, "N 3"]:
        """Back to the object frame, at `height` along the axis."""
        return np.asarray(flat[:, :1] * self.across + flat[:, 1:] * self.out + height * self.axis)

    @property
    def matrix(self) -> Float64[np.ndarray, "3 3"]:
        """Columns across, axis, out."""
        return np.stack([self.across, self.axis, self.out], -1)


def _grip_frame(rng: np.random.Generator) -> GripFrame:
    axis = np.eye(3)[pick(rng, ((6, 1), (1, 0), (1, 2)))]
    helper = np.eye(3)[0] if abs(axis[0]) < 0.5 else np.eye(3)[1]
    angle = between(rng, 0, 2 * np.pi)
    first = np.cross(axis, helper)
    second = np.cross(axis, first)
    out = np.cos(angle) * first + np.sin(angle) * second
    return GripFrame(axis, np.cross(axis, out), out)


def _slab(vertices: Float[np.ndarray, "V 3"], frame: GripFrame, height: float) -> Float64[np.ndarray, "N 2"]:
    along = vertices @ frame.axis
    for reach in (0.012, 0.03, 0.08):
        near = np.abs(along - height) < reach
        if near.sum() >= 12:
            return frame.flat(vertices[near])
    return frame.flat(vertices)


def _outline(flat: Float[np.ndarray, "N 2"], distance: float) -> Float64[np.ndarray, "K 2"]:
    """Convex outline of points, moved out by `distance`, counter-clockwise, starting towards the second axis."""
    try:
        corners = flat[ConvexHull(flat).vertices]
    except Exception:  # noqa: BLE001  flat or degenerate slabs: Qhull's own error type is private
        corners = flat[:1]
    grown = (corners[:, None] + distance * _DIRECTIONS).reshape(-1, 2)
    ring = grown[ConvexHull(grown).vertices]
    centre = (ring.min(0) + ring.max(0)) / 2
    bearing = np.arctan2(-(ring - centre)[:, 0], (ring - centre)[:, 1])  # 0 towards the second axis
    start = int(np.argmin(np.abs(bearing)))
    return np.roll(ring, -start, axis=0)


def _walk(ring: Float[np.ndarray, "K 2"], length: float, backwards: bool) -> Float64[np.ndarray, "L 2"]:
    path = np.concatenate([ring, ring[:1]])
    path = path[::-1] if backwards else path
    lengths = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    at = np.linspace(0, min(length, 0.48 * lengths[-1]), 9)
    return np.stack([np.interp(at, lengths, path[:, d]) for d in range(2)], -1)


def hand(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Fingers wrapped around a cross-section, thumb the other way, palm and forearm outside."""
    frame = _grip_frame(rng)
    size = between(rng, 0.75, 1.25)
    along = vertices @ frame.axis
    middle = np.quantile(along, between(rng, 0.1, 0.9))
    count = pick(rng, ((4, 4), (1.5, 3), (1.5, 2), (1, 1)))
    backwards = chance(rng, 0.5)
    spacing, gap = between(rng, 0.017, 0.022) * size, pick(rng, ((3, 0.0), (1, between(rng, 0, 0.012))))
    meshes = []
    for k in range(count):
        height = float(middle + (k - (count - 1) / 2) * spacing)
        radius = between(rng, 0.0065, 0.0095) * size
        ring = _outline(_slab(vertices, frame, height), radius + gap)
        path = _walk(ring, between(rng, 0.05, 0.1) * size, backwards)
        meshes.append(tube(frame.raised(path, height), np.linspace(1.1, 0.85, len(path)) * radius, frame.axis))
    if chance(rng, 0.85):
        height = float(middle + between(rng, -1.5, 1.5) * spacing)
        radius = between(rng, 0.0085, 0.0115) * size
        ring = _outline(_slab(vertices, frame, height), radius + gap)
        path = _walk(ring, between(rng, 0.03, 0.07) * size, not backwards)
        meshes.append(tube(frame.raised(path, height), np.linspace(1.15, 0.9, len(path)) * radius, frame.axis))
    outline = _outline(_slab(vertices, frame, float(middle)), 0.0)
    top = outline[0]
    thick = between(rng, 0.022, 0.034) * size
    palm_size = (between(rng, 0.05, 0.09) * size, max(0.03, count * spacing * 1.05), thick)
    centre = frame.raised(top[None], float(middle))[0] + frame.out * (thick / 2 + 0.004 + gap)
    meshes.append(superellipsoid(palm_size, between(rng, 2.3, 4), 16).moved(frame.matrix, centre))
    meshes.append(forearm(rng, centre, frame, size))
    return merged(meshes)


def forearm(rng: np.random.Generator, wrist: Float[np.ndarray, " 3"], frame: GripFrame, size: float) -> Mesh:
    """An arm from a wrist away from the object, more or less along `out`."""
    direction = frame.out * between(rng, 0.35, 1.2) + frame.axis * between(rng, -0.8, 0.8)
    direction += frame.across * between(rng, -1.0, 1.0)
    direction /= np.linalg.norm(direction)
    arm = capsule(between(rng, 0.15, 0.35), between(rng, 0.022, 0.032) * size, between(rng, 0.028, 0.045) * size)
    return arm.moved(_frame_along(direction), wrist + direction * 0.02)


def _frame_along(direction: Float[np.ndarray, " 3"]) -> Float64[np.ndarray, "3 3"]:
    """Rotation that carries y to `direction`."""
    helper = np.eye(3)[int(np.argmin(np.abs(direction)))]
    x = np.cross(direction, helper)
    x /= np.linalg.norm(x)
    return np.stack([x, direction, np.cross(x, direction)], -1)


def handle_grip(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Fingers curled around the bar of a handle at +x, palm outside of it."""
    size = between(rng, 0.75, 1.2)
    right = float(vertices[:, 0].max())
    bar = vertices[vertices[:, 0] > right - 0.012]
    low, high = bar[:, 1].min(), bar[:, 1].max()
    thick = between(rng, 0.006, 0.012)
    radius = between(rng, 0.006, 0.009) * size
    ring = thick / 2 + radius + between(rng, 0.001, 0.005)
    spacing = 2.1 * radius
    count = int(np.clip(round((high - low) / spacing) + rng.integers(-1, 2), 1, 4))
    side = 1.0 if chance(rng, 0.5) else -1.0
    angle = np.linspace(0.2, between(rng, 3.6, 5.4), 12)
    meshes = []
    for k in range(count):
        y = (low + high) / 2 + (k - (count - 1) / 2) * spacing
        curve = np.column_stack([np.cos(angle) * ring, np.zeros(12), side * np.sin(angle) * ring * 1.15])
        meshes.append(tube(curve + np.array([right - thick / 2, y, 0]), radius, np.array([0.0, 1.0, 0.0])))
    palm = (between(rng, 0.025, 0.034) * size, max(0.05, count * spacing * 1.1), between(rng, 0.06, 0.085) * size)
    centre = np.array([right + ring + palm[0] / 2, (low + high) / 2 + between(rng, -0.02, 0.01), -side * 0.02])
    meshes.append(superellipsoid(palm, 2.6, 16).moved(translation=centre))
    if chance(rng, 0.7):
        start = np.array([right + 0.01, high + between(rng, 0, 0.012), 0])
        path = start + np.linspace(0, 1, 5)[:, None] * [-between(rng, 0.02, 0.05), 0.01, side * 0.01]
        meshes.append(tube(path, 0.009 * size, np.array([0.0, 0.0, 1.0])))
    frame = GripFrame(np.array([0.0, 1, 0]), np.array([0.0, 0, -1]), np.array([1.0, 0, 0]))
    meshes.append(forearm(rng, centre, frame, size))
    return merged(meshes)


def palm_below(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """A flat hand or tray that carries the object from below (or covers it from above)."""
    up = -1.0 if chance(rng, 0.8) else 1.0
    level = float((vertices[:, 1] * up).max()) * up
    thick, width = between(rng, 0.015, 0.03), between(rng, 0.07, 0.1)
    angle = between(rng, 0, 2 * np.pi)
    out = np.array([np.cos(angle), 0, np.sin(angle)])
    frame = GripFrame(np.array([0.0, up, 0]), np.cross([0.0, up, 0], out), out)
    centre = np.array([0, level + up * thick / 2, 0]) + out * between(rng, 0, 0.03)
    meshes = [superellipsoid((width, thick, between(rng, 0.09, 0.12)), 3.0, 18).moved(frame.matrix, centre)]
    for k in range(4):
        start = centre - out * 0.04 + frame.across * (k - 1.5) * 0.02
        tip = start - out * between(rng, 0.06, 0.08) - np.array([0, up, 0]) * between(rng, -0.03, 0.0)
        path = start + np.linspace(0, 1, 4)[:, None] * (tip - start)
        meshes.append(tube(path, 0.008, frame.across))
    meshes.append(forearm(rng, centre + out * 0.05, frame, 1.0))
    return merged(meshes)


def gripper(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Two parallel fingers that pinch the object, a palm and a wrist behind them."""
    frame = _grip_frame(rng)
    approach, close, side = frame.out, frame.across, frame.axis
    along = vertices @ approach
    depth = between(rng, 0.005, 0.06)
    front = float(along.max()) - depth
    offset = float(np.quantile(vertices @ side, between(rng, 0.25, 0.75)))
    near = (np.abs(vertices @ side - offset) < 0.02) & (along > front - 0.01)
    held = vertices[near] if near.sum() >= 4 else vertices
    low, high = float((held @ close).min()), float((held @ close).max())
    thick, width = between(rng, 0.006, 0.016), between(rng, 0.012, 0.03)
    length = depth + between(rng, 0.01, 0.06)
    basis = np.stack([close, side, approach], -1)
    meshes = []
    for sign, edge in ((1.0, high), (-1.0, low)):
        finger = box((thick, width, length))
        centre = close * (edge + sign * thick / 2) + side * offset + approach * (front + length / 2)
        meshes.append(finger.moved(basis, centre))
    span = max(high - low + 2 * thick, between(rng, 0.06, 0.14))
    palm = (span + between(rng, 0, 0.04), between(rng, 0.03, 0.07), between(rng, 0.03, 0.07))
    middle = close * (low + high) / 2 + side * offset
    back = front + length + palm[2] / 2
    meshes.append(box(palm).moved(basis, middle + approach * back))
    wrist = capsule(between(rng, 0.1, 0.3), between(rng, 0.025, 0.045))
    meshes.append(wrist.moved(_frame_along(approach), middle + approach * (back + 0.02)))
    return merged(meshes)

"""Temples: from the hinge at the origin to -z, bent down behind the ear."""

import numpy as np
from jaxtyping import Float, Float64

from captra.data.shapes.curves import resampled, rounded_polyline, superellipse, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.glasses_front import FrontPlan
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import sweep

X = np.eye(3)[0]
STATIONS = 30


def make_temple(rng: np.random.Generator, plan: FrontPlan) -> list[Mesh]:
    """The temple at +x."""
    length = between(rng, 0.105, 0.155)
    if plan.shield:
        length = between(rng, 0.095, 0.135)
    curve = resampled(_side(rng, length), STATIONS)
    t = np.linspace(0, 1, STATIONS)
    tall, thick = _heights(rng, plan, t), _widths(rng, plan, t)
    section = np.stack([tall, thick], -1)[:, None] / 2 * superellipse(10, between(rng, 2.0, 5.0))
    mesh = sweep(np.insert(curve, 0, 0.0, axis=1), section, X)
    return [_spread(rng, mesh, length, plan.shield)]


def _side(rng: np.random.Generator, length: float) -> Float64[np.ndarray, "K 2"]:
    """(y, z) seen from the side: straight, bent at the ear, evenly curved, or hooked around it."""
    kind = pick(rng, ((6, "bent"), (2, "straight"), (1.5, "curved"), (0.4, "hooked")))
    slope = between(rng, -0.06, 0.12)
    if kind == "straight":
        return np.array([[0.0, 0.0], [-slope * length / 2, -length / 2], [-slope * length, -length]])
    if kind == "curved":
        t = np.linspace(0, 1, 12)
        return np.column_stack([-slope * length * t - between(rng, 0.05, 0.3) * length * t**3, -length * t])
    ear = between(rng, 0.6, 0.82) * length
    tip = length - ear
    turn = np.radians(between(rng, 5, 60) if kind == "bent" else between(rng, 70, 90))
    elbow = np.array([-slope * ear, -ear])
    end = elbow + tip * np.array([-np.sin(turn), -np.cos(turn)])
    corners = [np.zeros(2), elbow, end]
    if kind == "hooked":
        corners.append(end + 0.6 * tip * np.array([-0.7, 0.7]))
    return rounded_polyline(np.array(corners), 0.5 * tip, steps=8)


def _heights(rng: np.random.Generator, plan: FrontPlan, t: Float[np.ndarray, " K"]) -> Float64[np.ndarray, " K"]:
    """Extent along y: wires with a sleeve, bars, or broad blades that taper."""
    start = plan.joint_height
    if start < 0.004:
        wire = max(start * between(rng, 0.6, 1.0), 0.0009)
        sleeve = wire if chance(rng, 0.25) else max(between(rng, 0.002, 0.005), wire)
        edge = between(rng, 0.55, 0.75)
        return through((0, 0.1, edge, edge + 0.08, 1), (start, wire, wire, sleeve, sleeve), t)
    middle = start * between(rng, 0.5, 1.05)
    tip = between(rng, 0.003, 0.011)
    return through((0, 0.3, 0.7, 0.95, 1), (start, middle, between(rng, 0.5, 1) * middle + 0.001, tip, 0.6 * tip), t)


def _widths(rng: np.random.Generator, plan: FrontPlan, t: Float[np.ndarray, " K"]) -> Float64[np.ndarray, " K"]:
    start = plan.joint_width
    middle = max(start * between(rng, 0.6, 1.1), 0.0009)
    return through((0, 0.3, 0.75, 1), (start, middle, middle, max(middle, between(rng, 0.0015, 0.0045))), t)


def _spread(rng: np.random.Generator, mesh: Mesh, length: float, shield: bool) -> Mesh:
    """Bow outwards and close in behind the ear, or splay."""
    vertices = mesh.vertices.copy()
    t = np.clip(-vertices[:, 2] / length, 0, None)
    bow = between(rng, -0.006, 0.008)
    inwards = between(rng, -0.025, 0.01) if shield or chance(rng, 0.35) else between(rng, -0.012, 0.008)
    vertices[:, 0] += (4 * bow * t * (1 - t) + inwards * t**2).astype(np.float32)
    return Mesh(vertices, mesh.faces)

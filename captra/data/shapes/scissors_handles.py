"""Shanks and finger rings of scissors: wire loops, moulded grips, round, oval, tear-shaped."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Float64

from captra.data.shapes.curves import resampled, rounded_polyline, superellipse, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.loops import closed_sweep
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import sweep
from captra.geometry import axis_angle

Y = np.eye(3)[1]
AROUND = 36
STATIONS = 14


@dataclass(frozen=True)
class HandlePlan:
    """One handle with its ring at +x and -z, metres."""

    length: float
    """From the pivot to the far end of the ring, before it is turned."""
    inner: tuple[float, float]
    """Half the ring's opening across and along."""
    exponent: float
    """2 for an ellipse, more for a rounded rectangle."""
    egg: float
    """By how much the ring widens towards its far end."""
    tilt: float
    """Of the ring in its plane, rad."""
    bar: float
    """Width of the ring's bar in its plane."""
    height: float
    """Thickness of the ring along the pivot."""
    gap: float
    """Between the ring and the plane x = 0."""
    shank: float
    """Width of the shank near the pivot."""
    root_thickness: float
    """Of the shank near the pivot; it lies just below y = 0 there."""
    root: float
    """How far the shank reaches over the blade, towards +z."""
    level: float
    """y of the ring's middle."""
    swing: float
    """Angle about the pivot by which the ring is offset towards +x, rad."""
    exponent_bar: float
    """Cross-section of the bar: 2 is round."""


def draw_handles(
    rng: np.random.Generator, length: float, blade_width: float, blade_thickness: float
) -> tuple[HandlePlan, HandlePlan]:
    """Right and left handle of a pair: alike, or with a longer ring on one side."""
    moulded = chance(rng, 0.65)
    size = float(np.clip(length / 0.085, 0.55, 1.3))
    bar = (between(rng, 0.004, 0.0105) if moulded else between(rng, 0.0028, 0.0065)) * size
    height = (between(rng, 0.005, 0.014) if moulded else between(rng, 0.0025, 0.006)) * size
    across = between(rng, 0.009, 0.0155) * size
    along = min(across * between(rng, 1.0, 2.2), 0.5 * (0.82 * length - bar))
    swing = np.radians(pick(rng, ((3, 0.0), (3, between(rng, -6, 6)), (1, between(rng, -22, 22)))))
    levelled = chance(rng, 0.6)
    right = HandlePlan(
        length=length,
        inner=(min(across, along), along),
        exponent=pick(rng, ((3, 2.0), (2, between(rng, 2.0, 3.2)))),
        egg=pick(rng, ((2, 0.0), (3, between(rng, -0.15, 0.35)))),
        tilt=np.radians(between(rng, -12, 18)),
        bar=bar,
        height=height,
        gap=pick(rng, ((4, between(rng, 0.0002, 0.003)), (1, between(rng, 0.003, 0.014)))),
        shank=max(blade_width * between(rng, 0.8, 1.4), bar * (between(rng, 0.9, 2.6) if moulded else 1.0)),
        root_thickness=blade_thickness + (between(rng, 0.0005, 0.004) * size if moulded else 0.0),
        root=between(rng, 0.0, 0.02) * size if moulded else 0.0,
        level=0.0 if levelled else -between(rng, 0.2, 0.6) * height,
        swing=float(swing),
        exponent_bar=pick(rng, ((3, 2.0), (3, between(rng, 2.5, 6.0)))),
    )
    left = replace(right, swing=-right.swing)
    if chance(rng, 0.6):
        longer = min(right.inner[1] * between(rng, 1.0, 1.9), 0.5 * (0.85 * length - bar))
        wider = min(right.inner[0] * between(rng, 0.85, 1.2), longer)
        other = replace(left, inner=(wider, longer), tilt=np.radians(between(rng, -12, 18)))
        left = replace(other, length=length * between(rng, 0.94, 1.12), egg=between(rng, -0.1, 0.3))
    if chance(rng, 0.4):
        left, right = replace(right, swing=left.swing), replace(left, swing=right.swing)
    return right, left


def make_handle_half(rng: np.random.Generator, plan: HandlePlan) -> list[Mesh]:
    """Shank and ring in the frame of the scissors."""
    ring = _ring_outline(plan)
    shank, section = _shank(rng, plan, ring)
    swing = axis_angle(Y, -plan.swing)
    ends = through((0, 1), (1, between(rng, 0.75, 1.2)), np.abs(np.linspace(-1, 1, AROUND)))
    bars = (
        superellipse(8, plan.exponent_bar, (plan.bar / 2, plan.height / 2))
        * np.stack([ends, ends * 0 + 1], -1)[:, None]
    )
    meshes = [closed_sweep(_upright(ring), bars, Y), sweep(_upright(shank), section, Y)]
    return [_levelled(mesh.moved(swing), plan) for mesh in meshes]


def _upright(flat: Float[np.ndarray, "K 2"]) -> Float64[np.ndarray, "K 3"]:
    return np.insert(flat, 1, 0.0, axis=1)


def _ring_outline(plan: HandlePlan) -> Float64[np.ndarray, "K 2"]:
    """Middle of the ring's bar, (x, z)."""
    half = np.array(plan.inner) + plan.bar / 2
    unit = superellipse(AROUND, plan.exponent)
    unit = unit * np.column_stack([1 - plan.egg * unit[:, 1], np.ones(AROUND)])
    c, s = np.cos(plan.tilt), np.sin(plan.tilt)
    ring = (unit * half) @ np.array([[c, s], [-s, c]]).T
    ring -= [ring[:, 0].min(), ring[:, 1].min()]
    return np.asarray(ring + [plan.gap + plan.bar / 2, plan.bar / 2 - plan.length])


def _shank(
    rng: np.random.Generator, plan: HandlePlan, ring: Float64[np.ndarray, "K 2"]
) -> tuple[Float64[np.ndarray, "L 2"], Float64[np.ndarray, "L S 2"]]:
    """Its middle line and cross-sections, from the pivot to the upper end of the ring."""
    top = ring[np.argsort(-(ring[:, 1] - between(rng, -0.6, 0.4) * ring[:, 0]))[0]]
    bend = np.array([top[0] * between(rng, 0.15, 0.75), top[1] * between(rng, 0.35, 0.65)])
    beyond = top + (top - bend) / max(float(np.linalg.norm(top - bend)), 1e-6) * 0.3 * plan.bar
    start = np.array([0.0, plan.root + 0.5 * plan.shank])
    curve = resampled(rounded_polyline(np.array([start, [0.0, 0.0], bend, beyond]), 1.0, steps=8), STATIONS)
    t = np.linspace(0, 1, STATIONS)
    wide = plan.bar * between(rng, 0.9, 2.6)
    width = through((0, 0.25, 0.7, 1), (plan.shank * 0.7, plan.shank, wide, plan.bar * between(rng, 0.9, 1.6)), t)
    tall = through((0, 0.3, 1), (plan.root_thickness, plan.root_thickness * 1.05, plan.height), t)
    return curve, np.stack([width, tall], -1)[:, None] / 2 * superellipse(10, max(plan.exponent_bar, 2.5))


def _levelled(mesh: Mesh, plan: HandlePlan) -> Mesh:
    """Below y = 0 at the pivot, at the ring's level further on."""
    vertices = mesh.vertices.copy()
    at = np.clip((-vertices[:, 2] - 0.1 * plan.length) / (0.35 * plan.length), 0, 1)
    vertices[:, 1] += (1 - at) * (-plan.root_thickness / 2) + at * plan.level
    return Mesh(vertices, mesh.faces)

"""Mugs and cups: a hollow body turned about y, and a handle towards +x."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import polygon_factor, rounded_polyline, superellipse_factor, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.handles import Attachment, make_handle
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import SEGMENTS, revolve

STATIONS = 22


@dataclass(frozen=True)
class MugPlan:
    """Overall proportions, metres."""

    height: float
    """Without the handle."""
    radius: float
    """At the mouth."""
    wall: float
    """Thickness of the wall near the rim."""
    handle_width: tuple[float, float]
    """Range of the handle's extent across the x-y plane."""
    handle_gap: tuple[float, float]
    """Range of the room for fingers."""


def make_mug(rng: np.random.Generator) -> Shape:
    """Draw a mug: espresso cup to beer mug, tight box centred, handle to +x."""
    plan = _plan(rng)
    at = np.linspace(0, 1, STATIONS)
    outer = plan.radius * _body(rng, at)
    factor = _section(rng)
    foot = _foot(rng, plan, float(outer[0]))
    body_bottom = foot[-1, 1] if len(foot) else 0.0
    y = body_bottom + at * (plan.height - body_bottom)
    meshes = [revolve(_profile(rng, plan, y, outer, foot), factor)]
    meshes.append(_handle(rng, plan, y, outer * factor[0]))
    if chance(rng, 0.02):
        meshes.append(_lid(rng, plan, float(outer[-1])))
    return rigid_shape("mug", meshes)


def _plan(rng: np.random.Generator) -> MugPlan:
    kind = pick(rng, ((5, "mug"), (2.2, "low"), (1.2, "espresso"), (1.4, "beer"), (1, "tall"), (1, "any")))
    narrow, wide = (0.007, 0.017), (0.013, 0.032)
    width = pick(rng, ((3, narrow), (2, wide)))
    wall = between(rng, 0.0012, 0.006)
    if kind == "mug":
        height = between(rng, 0.078, 0.125)
        return MugPlan(height, height * between(rng, 0.34, 0.56), wall, width, (0.016, 0.036))
    if kind == "low":
        height = between(rng, 0.042, 0.08)
        return MugPlan(height, between(rng, 0.04, 0.068), wall, width, (0.010, 0.03))
    if kind == "espresso":
        height = between(rng, 0.04, 0.072)
        return MugPlan(height, height * between(rng, 0.38, 0.65), between(rng, 0.0015, 0.005), narrow, (0.008, 0.024))
    if kind == "beer":
        height = between(rng, 0.11, 0.21)
        wall = between(rng, 0.003, 0.011)
        return MugPlan(height, height * between(rng, 0.28, 0.45), wall, (0.012, 0.034), (0.02, 0.055))
    if kind == "tall":
        height = between(rng, 0.11, 0.19)
        return MugPlan(height, between(rng, 0.032, 0.046), wall, width, (0.014, 0.036))
    height = between(rng, 0.04, 0.16)
    return MugPlan(height, np.clip(height * between(rng, 0.28, 1.0), 0.022, 0.075), wall, width, (0.008, 0.045))


def _body(rng: np.random.Generator, t: Float64[np.ndarray, " K"]) -> Float64[np.ndarray, " K"]:
    """Outer radius over relative height, 1 at the mouth."""
    kind = pick(
        rng, ((4.5, "straight"), (2.8, "taper"), (2, "belly"), (1.2, "waist"), (2, "bowl"), (0.8, "step"), (1, "free"))
    )
    if kind == "straight":
        r = 1 - (1 - t) * between(rng, -0.02, 0.05)
    elif kind == "taper":
        r = 1 - (1 - t) ** between(rng, 0.7, 1.6) * between(rng, -0.25, 0.42)
    elif kind == "belly":
        peak, bottom = between(rng, 1.02, 1.3), between(rng, 0.65, 1.05)
        r = through((0, between(rng, 0.25, 0.6), 1), (bottom, peak, 1), t)
    elif kind == "waist":
        r = through((0, between(rng, 0.35, 0.7), 1), (between(rng, 0.8, 1.15), between(rng, 0.72, 0.92), 1), t)
    elif kind == "bowl":
        power, start = between(rng, 1.6, 3.2), between(rng, 0.35, 0.7)
        r = start + (1 - start) * (1 - (1 - t) ** power) ** (1 / between(rng, 1.0, 2.2))
    elif kind == "step":
        edge, low = between(rng, 0.15, 0.6), between(rng, 0.7, 0.93)
        soft = between(rng, 0.03, 0.15)
        r = low + (1 - low) / (1 + np.exp(-(t - edge) / soft * 3))
    else:
        knots = np.linspace(0, 1, 5)
        r = through(knots, [*rng.uniform(0.7, 1.15, 4), 1.0], t)
    if chance(rng, 0.2):
        r = r + between(rng, 0.02, 0.1) * np.clip((t - 0.8) / 0.2, 0, 1) ** 2  # flared lip
    if chance(rng, 0.1):
        r = r * (1 + between(rng, 0.005, 0.02) * np.sin(2 * np.pi * between(rng, 3, 9) * t))  # turned ridges
    return np.asarray(r / r[-1])


def _section(rng: np.random.Generator) -> Float64[np.ndarray, " S"]:
    kind = pick(rng, ((8.2, "round"), (0.6, "polygon"), (0.5, "square"), (0.5, "flutes"), (0.4, "oval")))
    angle = np.arange(SEGMENTS) * (2 * np.pi / SEGMENTS)
    if kind == "polygon":
        return polygon_factor(angle, int(rng.integers(5, 11)), between(rng, 0.0, 0.5))
    if kind == "square":
        return superellipse_factor(angle, between(rng, 2.4, 5.0))
    if kind == "flutes":
        return np.asarray(1 + between(rng, 0.008, 0.03) * np.cos(int(rng.integers(8, 17)) * angle))
    if kind == "oval":
        return np.asarray(1 / np.hypot(np.cos(angle), np.sin(angle) / between(rng, 0.82, 1.2)))
    return np.ones(SEGMENTS)


def _foot(rng: np.random.Generator, plan: MugPlan, bottom: float) -> Float64[np.ndarray, "K 2"]:
    """Outer outline of a foot ring from the table upwards, or nothing."""
    if not chance(rng, 0.25):
        return np.zeros((0, 2))
    height = between(rng, 0.002, 0.10 * plan.height)
    radius = bottom * between(rng, 0.6, 0.98)
    return np.array([[radius * between(rng, 0.95, 1.15), 0.0], [radius, height]])


def _profile(
    rng: np.random.Generator,
    plan: MugPlan,
    y: Float64[np.ndarray, " K"],
    outer: Float64[np.ndarray, " K"],
    foot: Float64[np.ndarray, "L 2"],
) -> Float64[np.ndarray, "M 2"]:
    """(radius, y) from the centre of the bottom over the outside and the rim to the centre of the inner floor."""
    bottom = y[0]
    fillet = pick(rng, ((2, 0.002), (2, between(rng, 0.003, 0.012)), (1.5, between(rng, 0.01, 0.035))))
    fillet = min(fillet, 0.6 * (plan.height - bottom), 0.6 * outer[0])
    above = np.array([np.interp(bottom + fillet, y, outer), bottom + fillet])
    corner = rounded_polyline(np.array([[0, bottom], [outer[0], bottom], above]), fillet, 7)
    outside = np.concatenate([corner, np.column_stack([outer, y])[y > above[1]]])
    if len(foot):
        hollow = 0.3 * foot[-1, 1]
        ring = np.array([[0.0, hollow], [0.85 * foot[0, 0], hollow], [0.9 * foot[0, 0], 0.0]])
        outside = np.concatenate([ring, foot, outside[1:]])
    wall = min(plan.wall, 0.3 * float(outer.min()))
    thickening = between(rng, 1.0, 2.5) if chance(rng, 0.3) else 1.0
    floor = bottom + min(wall * between(rng, 1.0, 2.5), 0.2 * plan.height)
    level = floor
    if chance(rng, 0.15):
        level = floor + between(rng, 0.2, 0.9) * (plan.height - floor)  # liquid, seen as a flat surface
    down = np.linspace(plan.height - wall * 0.5, max(level, floor + 1e-3), 14)
    inner = np.interp(down, y, outer) - wall * np.interp(down, [floor, plan.height], [thickening, 1.0])
    inner = np.maximum(inner, 0.25 * outer.min())
    round_floor = min(max(fillet - wall, 0.001), 0.5 * (plan.height - floor))
    if level == floor:
        drop = np.clip((floor + round_floor - down) / max(round_floor, 1e-6), 0, 1)
        inner = inner - round_floor * (1 - np.sqrt(np.maximum(0, 1 - drop**2)))
    rim = np.array(
        [[outer[-1] - wall * 0.15, plan.height + wall * 0.2], [outer[-1] - wall * 0.75, plan.height + wall * 0.2]]
    )
    inside = np.column_stack([np.maximum(inner, 0.002), down])
    return np.concatenate([outside, rim, inside, [[0.0, down[-1]]]])


def _handle(
    rng: np.random.Generator, plan: MugPlan, y: Float64[np.ndarray, " K"], outer: Float64[np.ndarray, " K"]
) -> Mesh:
    height = plan.height
    thickness = between(rng, 0.0045, 0.0155) * np.clip(height / 0.1, 0.55, 1.4)
    width = between(rng, *plan.handle_width) * np.clip(height / 0.1, 0.6, 1.4)
    if chance(rng, 0.35):
        width = thickness * between(rng, 0.85, 1.5)
    span = np.clip(pick(rng, ((4, between(rng, 0.45, 0.8)), (1, between(rng, 0.28, 0.45)))) * height, 0.02, 0.13)
    low, high = 0.5 * thickness + 0.03 * height, height - 0.5 * thickness
    span = min(span, 0.95 * (high - low))
    bottom = low + between(rng, 0.05, 0.95) * (high - low - span) if chance(rng, 0.75) else high - span
    top = bottom + span
    x_top, x_bottom = np.interp([top, bottom], y, outer)
    wall = min(plan.wall, 0.3 * float(outer.min()))
    sink = float(np.clip(width**2 / (8 * min(x_top, x_bottom)) + 5e-4, 0.4 * wall, 0.95 * wall + 3e-4))
    gap = between(rng, *plan.handle_gap)
    handle = make_handle(rng, Attachment((x_top, top), (x_bottom, bottom), sink), gap, thickness, width)
    if chance(rng, 0.1):
        twist = np.radians(between(rng, -9, 9))
        c, s = np.cos(twist), np.sin(twist)
        turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
        pivot = np.array([0, (top + bottom) / 2, 0])
        handle = handle.moved(translation=-pivot).moved(turn, pivot)
    return handle


def _lid(rng: np.random.Generator, plan: MugPlan, mouth: float) -> Mesh:
    height, knob = between(rng, 0.004, 0.015), between(rng, 0.004, 0.012)
    outline = np.array(
        [[0, 0], [mouth, 0], [mouth, height * 0.4], [knob * 1.2, height], [knob, height + knob], [0, height + knob]]
    )
    return revolve(rounded_polyline(outline, 0.003)).moved(translation=np.array([0, plan.height, 0]))

"""Cans: a wall turned about y, a lid with a tab, dents; the tight box is centred on the axis of symmetry."""

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.can_outlines import CanPlan, draw_plan, wall
from captra.data.shapes.curves import rounded_polyline, superellipse_factor
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, grid_mesh
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import revolve, rounded_box
from captra.geometry import axis_angle

AROUND = 48
"""Directions: a multiple of four, so that the extremes along x and z are vertices."""


def make_can(rng: np.random.Generator) -> Shape:
    """Draw a can: drinks can to paint tin, closed, opened or dented."""
    plan = draw_plan(rng)
    outline = wall(rng, plan)
    below, above = _bottom(rng, plan, outline), _top(rng, plan, outline)
    profile = np.concatenate([below, outline, above])
    angle = np.arange(AROUND) * (2 * np.pi / AROUND)
    radius = profile[:, :1] * np.ones(AROUND)
    y = np.repeat(profile[:, 1:], AROUND, axis=1)
    radius = radius * _section(rng, plan, angle) * _dents(rng, plan, angle, profile[:, 1])
    if plan.lid == "mouth":
        inside = np.arange(len(profile)) >= len(below) + len(outline) + 2
        y = y - _mouth(rng, plan, radius, angle) * inside[:, None]
    rings = np.stack([radius * np.cos(angle), y, -radius * np.sin(angle)], -1)
    meshes = [grid_mesh(rings, caps=True), *_fittings(rng, plan, outline, above)]
    return rigid_shape("can", meshes)


def _bottom(rng: np.random.Generator, plan: CanPlan, outline: Float64[np.ndarray, "K 2"]) -> Float64[np.ndarray, "L 2"]:
    """From near the centre of the underside to the wall."""
    edge = float(outline[0, 0])
    if plan.bottom == "flat":
        return np.array([[1e-4, 0.0], [edge - 5e-4, 0.0]])
    ring = between(rng, 0.0008, 0.002)
    if plan.bottom == "rim":
        up = between(rng, 0.0015, 0.005)
        panel = between(rng, 0.4, 0.85) * edge
        return np.array([[1e-4, up * 0.7], [panel, up * 0.7], [panel + 0.001, up], [edge - ring, up], [edge - ring, 0]])
    dome = min(between(rng, 0.004, 0.012), 0.3 * plan.height)
    t = np.linspace(0.01, 0.92, 7)
    inner = edge - between(rng, 0.002, 0.005)
    return np.concatenate([np.column_stack([inner * t, dome * np.sqrt(1 - t**2)]), [[inner, 0.0005], [edge - ring, 0]]])


def _top(rng: np.random.Generator, plan: CanPlan, outline: Float64[np.ndarray, "K 2"]) -> Float64[np.ndarray, "L 2"]:
    """From the upper end of the wall over the rim to near the centre of the lid, with stations all over the lid."""
    edge, height = outline[-1]
    if plan.top == "flat" and plan.lid != "open":
        return _panel(edge - 5e-4, height)
    bead = between(rng, 0.0008, 0.0022)
    out = between(rng, 0.0, 0.0015)
    rim = np.array([[edge + out, height], [edge + out, height + bead], [edge - bead, height + bead]])
    if plan.lid in {"open", "bent"}:
        deep = between(rng, 0.5, 0.97) * plan.height
        if chance(rng, 0.4):
            deep = between(rng, 0.08, 0.5) * plan.height  # filled
        down = outline[::-1][1:] - [between(rng, 0.0003, 0.001), 0]
        down = down[down[:, 1] > height - deep]
        return np.concatenate([rim, down, _panel(float(down[-1, 0]), height - deep)])
    sunk = min(between(rng, 0.0015, 0.0065), 0.25 * plan.height)
    if plan.top == "plug":
        inner = edge * between(rng, 0.74, 0.9)
        ridge = np.array([[inner + 0.002, height + bead - 0.001], [inner, height + bead], [inner - 0.001, height]])
        return np.concatenate([rim, ridge, _panel(inner - 0.002, height + bead - sunk * 0.7)])
    slope = between(rng, 0.0, 0.003)
    gutter = np.array([[edge - bead - slope, height + bead - sunk - 0.001]])
    rise = between(rng, 0.0, 0.0018)
    inner = edge - bead - slope - between(rng, 0.001, 0.004)
    return np.concatenate([rim, gutter, _panel(inner, height + bead - sunk - 0.001 + rise)])


def _panel(radius: float, y: float) -> Float64[np.ndarray, "L 2"]:
    return np.column_stack([radius * np.linspace(1, 0.02, 12), np.full(12, y)])


def _section(
    rng: np.random.Generator, plan: CanPlan, angle: Float64[np.ndarray, " S"]
) -> Float64[np.ndarray, " S"] | float:
    """Flat tins are squared or oval now and then; point-symmetric, so the box stays centred."""
    if not chance(rng, 0.12 if plan.height < 1.2 * plan.radius else 0.015):
        return 1.0
    if chance(rng, 0.5):
        return superellipse_factor(angle, between(rng, 2.3, 4.0)) * between(rng, 0.85, 1.0)
    return np.asarray(1 / np.hypot(np.cos(angle), np.sin(angle) / between(rng, 0.75, 0.93)))


def _dents(
    rng: np.random.Generator, plan: CanPlan, angle: Float64[np.ndarray, " S"], y: Float64[np.ndarray, " K"]
) -> Float64[np.ndarray, "K S"]:
    """Factor of the radius: dents of limited height, or a crumpled wall whose harmonics are even.

    Either way, both rims and most of the wall stay round, and with them the centre of the box.
    """
    factor = np.ones((len(y), len(angle)))
    crumpled = 1.6 if plan.bottom == "domed" else 0.3
    kind = pick(rng, ((6.5, "none"), (2.2, "dents"), (crumpled, "crumpled")))
    at = (y / plan.height)[:, None]
    fade = np.clip(np.minimum(at - 0.05, 0.93 - at) / 0.12, 0, 1)
    if kind == "dents":
        for _ in range(int(rng.integers(1, 4))):
            depth, width = between(rng, 0.02, 0.16), between(rng, 0.3, 0.9)
            middle, tall = between(rng, 0.25, 0.75), between(rng, 0.06, 0.2)
            turn = np.angle(np.exp(1j * (angle - between(rng, 0, 2 * np.pi))))
            factor -= depth * np.exp(-((turn / width) ** 2) * 2) * np.exp(-(((at - middle) / tall) ** 2) * 2) * fade
    elif kind == "crumpled":
        for _ in range(5):
            around, along, phase = 2 * int(rng.integers(1, 4)), between(rng, 1, 7), rng.uniform(0, 6, 2)
            wave = np.cos(around * angle + phase[0]) * np.sin(2 * np.pi * along * at + phase[1])
            factor -= between(rng, 0.005, 0.025) * (1 + wave) * fade
    return factor


def _mouth(
    rng: np.random.Generator,
    plan: CanPlan,
    radius: Float64[np.ndarray, "K S"],
    angle: Float64[np.ndarray, " S"],
) -> Float64[np.ndarray, "K S"]:
    """How far the lid is pressed down where a drinks can is opened."""
    lid = plan.radius * plan.neck
    x, z = radius * np.cos(angle) / lid, radius * np.sin(angle) / lid
    across = ((x - 0.5) / between(rng, 0.26, 0.34)) ** 2 + (z / between(rng, 0.3, 0.4)) ** 2
    return np.asarray((across < 1) * between(rng, 0.3, 0.8) * plan.height)


def _fittings(
    rng: np.random.Generator, plan: CanPlan, outline: Float64[np.ndarray, "K 2"], above: Float64[np.ndarray, "L 2"]
) -> list[Mesh]:
    """Tab, cap or the lid that hangs on."""
    edge, height = (float(v) for v in outline[-1])
    level = float(above[-1, 1])
    if plan.lid == "bent":
        return [_bent_lid(rng, edge, float(above[:, 1].max()))]
    if plan.lid == "open":
        return []
    if plan.top == "overcap":
        low, tall = between(rng, 0.003, 0.012), between(rng, 0.0015, 0.012)
        radius = max(edge, plan.radius) + between(rng, 0.0006, 0.002)
        corners = [[0, height - low], [radius, height - low], [radius, height + tall], [0, height + tall]]
        return [revolve(rounded_polyline(np.array(corners), between(rng, 0.0003, 0.003)), segments=AROUND)]
    if plan.top == "ring" or (plan.top == "rim" and chance(rng, 0.55)):
        return _tab(rng, edge, level, food=plan.top == "rim")
    return []


def _tab(rng: np.random.Generator, edge: float, level: float, food: bool) -> list[Mesh]:
    """A tab that is riveted to the lid; the tab of a food tin points away from the rim and is longer."""
    turn = axis_angle(np.array([0.0, 1, 0]), 0.0 if not food else between(rng, 0, 2 * np.pi))
    long = edge * (between(rng, 0.7, 0.95) if food else between(rng, 0.75, 0.95))
    wide, thick = edge * between(rng, 0.42, 0.62), between(rng, 0.0008, 0.002)
    lift = axis_angle(np.array([0.0, 0, 1]), -between(rng, 0.0, 0.06) if chance(rng, 0.8) else -between(rng, 0.1, 1.2))
    tab = rounded_box((long, thick, wide), between(rng, 2.5, 5), 0.0004, 20)
    front = edge * (between(rng, 0.5, 0.65) if food else between(rng, 0.1, 0.22))
    tab = tab.moved(translation=np.array([-long / 2, thick / 2, 0])).moved(lift)
    tab = tab.moved(translation=np.array([front, level + 4e-4, 0])).moved(turn)
    rivet = rounded_box((0.006, 0.0022, 0.006), 2.0, 0.0004, 12)
    return [tab, rivet.moved(turn, turn @ np.array([front * 0.6, level + 0.0006, 0]))]


def _bent_lid(rng: np.random.Generator, edge: float, top: float) -> Mesh:
    """The lid of an opened tin, bent up at -x but still above the can, so that the box stays centred on the axis."""
    radius = 0.94 * edge
    disc = revolve(np.array([[0, 0], [radius, 0], [radius, 6e-4], [0, 6e-4]]), segments=AROUND)
    opened = axis_angle(np.array([0.0, 0, 1]), np.radians(between(rng, 15, 88)))
    hinge = np.array([-0.97 * edge, top - 0.001, 0])
    return disc.moved(translation=np.array([radius, 0, 0])).moved(opened, hinge)

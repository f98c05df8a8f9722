"""Handles of drawers: bars, arches, knobs, cups, lips, or none."""

from collections.abc import Callable, Sequence

import numpy as np

from captra.data.shapes.cabinet_plan import CabinetPlan, Cell
from captra.data.shapes.cabinets import board
from captra.data.shapes.curves import rounded_polyline
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import capsule, revolve, superellipsoid, tube
from captra.geometry import axis_angle

HandleMaker = Callable[[Cell, float], list[Mesh]]
"""From an opening and the z of its front to meshes."""

X, Y, Z = np.eye(3)
TO_FRONT = axis_angle(X, np.pi / 2)
ALONG_X = axis_angle(Z, -np.pi / 2)


def draw_handle(rng: np.random.Generator, plan: CabinetPlan) -> HandleMaker:
    """One kind for all drawers of a cabinet."""
    unit = float(np.clip(plan.width / plan.columns / 0.45, 0.45, 1.1))
    kind = pick(rng, ((3, "bar"), (3, "arch"), (3, "knob"), (1.2, "cup"), (1.2, "lip"), (1.5, "none"), (0.6, "ring")))
    if kind == "none":
        return lambda _cell, _face: []
    if kind == "lip":
        return _lip(rng, unit)
    mesh = {"bar": _bar, "arch": _arch, "knob": _knob, "cup": _cup, "ring": _ring}[kind](rng, unit)
    pair = chance(rng, 0.75 if plan.width / plan.columns > 0.7 else 0.12)
    level = pick(rng, ((3, 0.5), (2, between(rng, 0.5, 0.85))))
    return _placed(mesh, [0.27, 0.73] if pair else [0.5], level)


def _placed(mesh: Mesh, positions: Sequence[float], level: float) -> HandleMaker:
    """`mesh` stands out to +z from its origin."""
    low_y, high_y = mesh.bounds()[:, 1]

    def make(cell: Cell, face: float) -> list[Mesh]:
        left, low, right, high = cell
        y = float(np.clip(low + level * (high - low), low - low_y, max(high - high_y, low - low_y)))
        return [mesh.moved(translation=np.array([left + at * (right - left), y, face])) for at in positions]

    return make


def _lip(rng: np.random.Generator, unit: float) -> HandleMaker:
    """A profile along the upper edge."""
    tall, out = between(rng, 0.006, 0.03) * unit, between(rng, 0.008, 0.03) * unit
    share = pick(rng, ((2, 1.0), (1, between(rng, 0.2, 0.8))))

    def make(cell: Cell, face: float) -> list[Mesh]:
        left, _, right, high = cell
        middle, half = (left + right) / 2, (right - left) / 2 * share
        return [board((middle - half, high - tall - 0.003, face - 1e-3), (middle + half, high - 0.003, face + out))]

    return make


def _length(rng: np.random.Generator, unit: float) -> float:
    return pick(rng, ((3, between(rng, 0.08, 0.18)), (1, between(rng, 0.18, 0.34)))) * unit


def _bar(rng: np.random.Generator, unit: float) -> Mesh:
    """A straight rod on two posts."""
    length, reach, radius = _length(rng, unit), between(rng, 0.018, 0.04) * unit, between(rng, 0.003, 0.008) * unit
    rod = (
        capsule(length, radius, segments=10)
        if chance(rng, 0.6)
        else board((-radius, 0, -radius), (radius, length, radius))
    )
    posts = capsule(reach, radius * between(rng, 0.6, 1.0), segments=8).moved(TO_FRONT)
    apart = length * between(rng, 0.3, 0.5)
    meshes = [rod.moved(ALONG_X, np.array([-length / 2, 0, reach]))]
    return merged([*meshes, *(posts.moved(translation=np.array([s * apart, 0, 0])) for s in (-1, 1))])


def _arch(rng: np.random.Generator, unit: float) -> Mesh:
    """A bent rod, angular to round."""
    length, reach, radius = _length(rng, unit), between(rng, 0.018, 0.045) * unit, between(rng, 0.003, 0.009) * unit
    shoulder = length / 2 * between(rng, 0.5, 1.0)
    path = np.array([[-length / 2, 0, 0], [-shoulder, 0, reach], [shoulder, 0, reach], [length / 2, 0, 0]])
    drop = between(rng, 0.0, 0.02) * unit if chance(rng, 0.2) else 0.0
    path[1:3, 1] -= drop
    normal = np.array([0.0, reach, drop]) / np.hypot(reach, drop)
    return tube(rounded_polyline(path, between(rng, 0.1, 1.0) * reach), radius, normal)


def _knob(rng: np.random.Generator, unit: float) -> Mesh:
    radius, reach = between(rng, 0.009, 0.022) * unit, between(rng, 0.015, 0.035) * unit
    if chance(rng, 0.2):
        half = np.array([radius, radius * between(rng, 0.7, 1.3)])
        return board((-half[0], -half[1], 0), (half[0], half[1], reach))
    stem = radius * between(rng, 0.3, 0.9)
    outline = np.array(
        [[0, -1e-3], [stem, -1e-3], [stem, 0.4 * reach], [radius, 0.65 * reach], [0.8 * radius, reach], [0, reach]]
    )
    return revolve(rounded_polyline(outline, between(rng, 0.0, 0.006)), segments=16).moved(TO_FRONT)


def _cup(rng: np.random.Generator, unit: float) -> Mesh:
    size = between(rng, 0.06, 0.11) * unit, between(rng, 0.025, 0.045) * unit, between(rng, 0.03, 0.055) * unit
    return superellipsoid(size, between(rng, 2.0, 3.0), 18)


def _ring(rng: np.random.Generator, unit: float) -> Mesh:
    """A plate with a hanging loop."""
    half, tall = between(rng, 0.02, 0.05) * unit, between(rng, 0.015, 0.035) * unit
    backing = board((-half, -0.3 * tall, -1e-3), (half, 0.4 * tall, 0.004))
    path = np.array([[-half, 0, 0.003], [-0.8 * half, -tall, 0.008], [0.8 * half, -tall, 0.008], [half, 0, 0.003]])
    normal = np.array([0.0, 0.005, tall]) / np.hypot(0.005, tall)
    return merged([backing, tube(rounded_polyline(path, 0.5 * tall), 0.0035 * unit, normal)])

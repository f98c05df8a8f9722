"""Scissors: two crossing halves, closed at rest, the pivot along y, blades towards +z.

The right half has its ring at +x and lies below the other; opening the left half turns its blade towards +x.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import superellipse, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.loops import mirrored
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.scissors_handles import HandlePlan, draw_handles, make_handle_half
from captra.data.shapes.shape import Shape, articulated_shape
from captra.data.shapes.surfaces import revolve, sweep
from captra.geometry import axis_angle

Y, Z = np.eye(3)[1:]
OPENING_DEG = (0.0, 70.0)
STATIONS = 18


@dataclass(frozen=True)
class BladePlan:
    """Both blades, metres."""

    length: float
    """From the pivot to the tip."""
    width: float
    """Near the pivot, from the cutting edge to the spine."""
    taper: tuple[float, float]
    """Width at 60 % of the length and at the tip over that near the pivot."""
    thickness: float
    """Across the plane of cutting."""
    overlap: float
    """By which the cutting edges pass each other when closed, near the pivot."""
    bow: float
    """Sideways shift of the tips towards +x: curved blades."""
    lift: float
    """Shift of the tips towards +y: blades that bend out of their plane."""


def make_scissors(rng: np.random.Generator) -> Shape:
    """Draw scissors: nail scissors to shears, symmetric or with a wider ring for the fingers."""
    length = pick(rng, ((5, between(rng, 0.12, 0.23)), (2, between(rng, 0.085, 0.13)), (1, between(rng, 0.22, 0.28))))
    share = pick(rng, ((5, between(rng, 0.42, 0.62)), (1, between(rng, 0.25, 0.42)), (1, between(rng, 0.6, 0.7))))
    blade = _draw_blade(rng, length * share)
    right, left = draw_handles(rng, length * (1 - share), blade.width, blade.thickness)
    halves = [_half(rng, blade, right, blade.bow), _half(rng, blade, left, -blade.bow)]
    halves[1] = [mesh.moved(axis_angle(Z, np.pi)) for mesh in halves[1]]
    halves[1 if chance(rng, 0.7) else 0].append(_screw(rng, blade))
    halves = [[_lifted(mesh, blade) for mesh in half] for half in halves]
    if chance(rng, 0.12):  # left-handed
        halves = [[mirrored(mesh, axis=1) for mesh in half] for half in halves]
    return articulated_shape("scissors", halves, np.zeros((1, 3)), np.radians([OPENING_DEG]))


def _draw_blade(rng: np.random.Generator, length: float) -> BladePlan:
    width = float(
        np.clip(length * pick(rng, ((5, between(rng, 0.09, 0.2)), (1, between(rng, 0.2, 0.28)))), 0.004, 0.024)
    )
    tip = pick(rng, ((5, between(rng, 0.04, 0.2)), (2, between(rng, 0.2, 0.7))))
    middle = between(rng, 0.5 + 0.4 * tip, 0.95)
    return BladePlan(
        length=length,
        width=width,
        taper=(middle, tip),
        thickness=between(rng, 0.0008, 0.0022) * np.clip(length / 0.08, 0.7, 1.6),
        overlap=width * between(rng, 0.1, 0.9),
        bow=length * between(rng, -0.2, 0.2) if chance(rng, 0.12) else 0.0,
        lift=length * between(rng, -0.22, 0.22) if chance(rng, 0.12) else 0.0,
    )


def _half(rng: np.random.Generator, plan: BladePlan, handle: HandlePlan, bow: float) -> list[Mesh]:
    """Blade and handle of the half with its ring at +x, just below y = 0."""
    return [_blade(plan, bow), *make_handle_half(rng, handle)]


def _blade(plan: BladePlan, bow: float) -> Mesh:
    t = np.concatenate([np.linspace(0, 0.9, STATIONS - 4), [0.94, 0.97, 0.99, 1.0]])
    middle, tip = plan.taper
    width = plan.width * through((0, 0.12, 0.6, 1), (0.9, 1, middle, tip), t)
    width *= np.sqrt(np.clip(1 - ((t - 0.9) / 0.1).clip(0) ** 2, 0.02, 1))  # round tip
    edge = plan.overlap * (1 - t) + 0.3 * width * t
    z = plan.length * t - 0.4 * plan.width * (1 - t)
    curve = np.column_stack([edge - width / 2 + bow * t**2, np.full(len(t), -plan.thickness / 2), z])
    half = np.column_stack([width / 2, np.full(len(t), plan.thickness / 2)])
    return sweep(curve, half[:, None] * superellipse(8, 5.0), Y)


def _screw(rng: np.random.Generator, plan: BladePlan) -> Mesh:
    radius = between(rng, 0.2, 0.45) * plan.width
    low, high = plan.thickness + between(rng, 0.0003, 0.002), plan.thickness + between(rng, 0.0005, 0.003)
    outline = np.array([[0, -low], [radius, -low], [radius, 0.6 * high], [0.7 * radius, high], [0, high]])
    return revolve(outline, segments=16)


def _lifted(mesh: Mesh, plan: BladePlan) -> Mesh:
    if plan.lift == 0:
        return mesh
    at: Float64[np.ndarray, " V"] = np.clip(mesh.vertices[:, 2] / plan.length, 0, None).astype(np.float64)
    vertices = mesh.vertices.copy()
    vertices[:, 1] += plan.lift * at**2
    return Mesh(vertices, mesh.faces)

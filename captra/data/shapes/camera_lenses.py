"""Lenses: barrels turned about the x axis that start at x = 0 and look towards +x."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import rounded_polyline
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, grid_mesh
from captra.data.shapes.plates import Rectangle, stacked
from captra.data.shapes.surfaces import box, revolve

AROUND = 40

TOWARDS_X = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])
"""Carries y to x and x to -y."""


@dataclass(frozen=True)
class LensPlan:
    """Overall measures, metres."""

    radius: float
    """Of the barrel."""
    length: float
    """From the body to the front edge."""
    stages: int
    """Number of barrel sections."""


def make_lens(rng: np.random.Generator, plan: LensPlan) -> list[Mesh]:
    """A barrel in sections with a sunk front glass or a cap; a hood now and then."""
    outline, front = _barrel(rng, plan)
    capped = chance(rng, 0.15)
    profile = np.concatenate([[[0.0, -0.004], [outline[0, 0], -0.004]], outline, _front(rng, front, plan, capped)])
    ribs = 1 + between(rng, 0.0, 0.012) * np.cos(int(rng.choice([10, 13, 20])) * np.arange(AROUND) / AROUND * 2 * np.pi)
    grip = _in_rings(rng, profile[:, 1], plan.length)
    meshes = [revolve(profile, 1 + (ribs - 1) * grip[:, None], AROUND)]
    if plan.length > 0.03 and not capped and chance(rng, 0.22):
        meshes.append(_hood(rng, front, plan.length))
    if plan.length > 0.025 and chance(rng, 0.2):
        meshes.append(_lever(rng, plan))
    return [mesh.moved(TOWARDS_X) for mesh in meshes]


def _barrel(rng: np.random.Generator, plan: LensPlan) -> tuple[Float64[np.ndarray, "K 2"], float]:
    """Outline of the sections from the body to the front edge, and the radius there."""
    kind = pick(rng, ((3, "telescope"), (3, "steps"), (1.5, "flare"), (1, "straight")))
    ends = np.sort(np.concatenate([[0, 1], rng.uniform(0.1, 0.92, plan.stages - 1)])) * plan.length
    if kind == "telescope":
        radii = plan.radius * np.cumprod([1.0, *rng.uniform(0.78, 0.97, plan.stages - 1)])
    elif kind == "steps":
        radii = plan.radius * rng.uniform(0.88, 1.04, plan.stages)
    elif kind == "flare":
        radii = plan.radius * np.linspace(between(rng, 0.72, 0.9), 1.0, plan.stages)
    else:
        radii = plan.radius * rng.uniform(0.98, 1.01, plan.stages)
    points = []
    for low, high, radius in zip(ends[:-1], ends[1:], radii, strict=True):
        points += [[radius, low], [radius * between(rng, 0.98, 1.0), high]]
    outline = rounded_polyline(np.array(points), between(rng, 0.0003, 0.002), 3)
    return outline, float(outline[-1, 0])


def _front(rng: np.random.Generator, radius: float, plan: LensPlan, capped: bool) -> Float64[np.ndarray, "K 2"]:
    """From the front edge to the axis: glass behind a rim, or a cap that is flush."""
    end = plan.length
    if capped:
        return np.array([[0.96 * radius, end + 0.0015], [0.9 * radius, end + 0.0025], [0.0, end + 0.0025]])
    rim = between(rng, 0.72, 0.95) * radius
    glass = between(rng, 0.35, 0.98) * rim
    deep = min(between(rng, 0.001, 0.012), 0.6 * plan.length)
    t = np.linspace(1, 0, 6)
    dome = between(rng, -0.05, 0.3) * glass
    glass_points = np.column_stack([glass * t, end - deep + dome * np.cos(t * np.pi / 2)])
    glass_points[:, 1] = np.maximum(glass_points[:, 1], 0.0)
    return np.concatenate([[[rim, end]], glass_points])


def _in_rings(rng: np.random.Generator, y: Float64[np.ndarray, " K"], length: float) -> Float64[np.ndarray, " K"]:
    """Where along the barrel there are ribs."""
    low = between(rng, 0.1, 0.5) * length
    return np.asarray(((y > low) & (y < low + between(rng, 0.2, 0.5) * length)).astype(np.float64))


def _hood(rng: np.random.Generator, radius: float, length: float) -> Mesh:
    """A thin open tube in front, round or cut to petals."""
    low, tall = length - 0.008, between(rng, 0.018, 0.06)
    wide, thick = radius * between(rng, 1.02, 1.3), 0.0015
    angle = np.arange(AROUND) * (2 * np.pi / AROUND)
    petals = between(rng, 0.15, 0.4) * np.cos(2 * angle) if chance(rng, 0.5) else np.zeros(AROUND)
    edge = low + tall * (1 + petals - petals.max())
    radii = np.array([radius - 0.001, radius + thick, wide + thick, wide, radius - 0.001])
    heights = [np.full(AROUND, low), np.full(AROUND, low), edge, edge, np.full(AROUND, low + 0.004)]
    rings = [np.column_stack([r * np.cos(angle), y, -r * np.sin(angle)]) for r, y in zip(radii, heights, strict=True)]
    return grid_mesh(np.stack(rings), caps=True)


def _lever(rng: np.random.Generator, plan: LensPlan) -> Mesh:
    """A tripod collar, a focus lever or a switch on the barrel."""
    size = (between(rng, 0.004, 0.012), between(rng, 0.006, 0.02), between(rng, 0.006, 0.02))
    angle = between(rng, 0, 2 * np.pi)
    reach = plan.radius + size[0] * 0.2
    at = np.array([reach * np.cos(angle), plan.length * between(rng, 0.2, 0.7), reach * np.sin(angle)])
    return box(size).moved(translation=at)


def bellows(rng: np.random.Generator, side: float, length: float) -> list[Mesh]:
    """A folding camera's pleated leather, a front standard and a small lens."""
    folds = int(rng.integers(4, 9))
    taper = between(rng, 0.45, 0.8)
    layers = []
    for k in range(2 * folds + 1):
        size = side * (1 + (taper - 1) * k / (2 * folds)) * (1.0 if k % 2 else 0.88)
        layers.append((Rectangle.centred(size, size, 0.003), length * k / (2 * folds)))
    standard = box((0.9 * side * taper, 0.006, 0.95 * side * taper)).moved(translation=np.array([0, length, 0]))
    folded = [mesh.moved(TOWARDS_X) for mesh in (stacked(layers), standard)]
    lens = make_lens(rng, LensPlan(side * between(rng, 0.22, 0.34), between(rng, 0.008, 0.025), 2))
    return [*folded, *(mesh.moved(translation=np.array([length, 0, 0])) for mesh in lens)]

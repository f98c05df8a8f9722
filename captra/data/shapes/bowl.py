"""Bowls: a hollow body turned about y on a foot, with a rim; its tight box is centred on the axis of symmetry."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.bowl_outlines import FAMILIES, BowlOutline
from captra.data.shapes.curves import polygon_factor, rounded_polyline, superellipse_factor
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import inset, revolve

AROUND = 48
"""Directions: a multiple of four, so that the extremes along x and z are vertices."""


@dataclass(frozen=True)
class BowlPlan:
    """Overall measures, metres."""

    radius: float
    """Of the mouth."""
    height: float
    """From the table to the rim."""
    wall: float
    """Thickness of the wall."""
    foot: float
    """Height of the foot; 0 stands on its bottom."""


def make_bowl(rng: np.random.Generator) -> Shape:
    """Draw a bowl: dip to salad bowl, flat to deep, of sheet metal to stone."""
    outline = pick(rng, FAMILIES)(rng)
    plan = _plan(rng, outline)
    profile = _profile(rng, plan, outline)
    return rigid_shape("bowl", [revolve(profile, _section(rng, plan, profile), AROUND)])


def _plan(rng: np.random.Generator, outline: BowlOutline) -> BowlPlan:
    radius = pick(
        rng,
        (
            (6, between(rng, 0.055, 0.095)),
            (1.2, between(rng, 0.03, 0.055)),
            (2.0, between(rng, 0.09, 0.13)),
            (0.6, between(rng, 0.13, 0.185)),
        ),
    )
    height = 2 * radius * between(rng, *outline.deep)
    if chance(rng, 0.15):
        height *= between(rng, 0.75, 1.3)
    thin, medium, thick = between(rng, 0.0008, 0.002), between(rng, 0.002, 0.0045), between(rng, 0.0045, 0.012)
    wall = min(pick(rng, ((2, thin), (5, medium), (2, thick))), 0.13 * radius, 0.2 * height)
    foot = between(rng, 0.002, 0.012) if chance(rng, 0.5) else 0.0
    if chance(rng, 0.06):
        foot = between(rng, 0.15, 0.4) * height
    return BowlPlan(radius, height, wall, min(foot, 0.45 * height))


def _profile(rng: np.random.Generator, plan: BowlPlan, outline: BowlOutline) -> Float64[np.ndarray, "M 2"]:
    """(radius, y) from the centre of the underside over the outside and the rim to the centre of the inner floor."""
    rise = plan.height - plan.foot
    outer = np.column_stack([plan.radius * outline.radius, plan.foot + rise * outline.height])
    grown = 1 + between(rng, 0.3, 2.0) * np.clip(1 - outline.height / 0.5, 0, 1) if chance(rng, 0.4) else 1.0
    inner = inset(outer, plan.wall)
    inner = outer + (inner - outer) * np.broadcast_to(grown, len(outer))[:, None]
    floor = plan.foot + plan.wall * float(np.broadcast_to(grown, len(outer))[0])
    inner[:, 1] = np.maximum(inner[:, 1], floor)
    inner[:, 0] = np.maximum(inner[:, 0], 0.004)
    bottom = float(outer[0, 0])
    return np.concatenate([_underside(rng, plan, bottom), outer, *_rim(rng, plan, outer, inner), _inside(rng, inner)])


def _underside(rng: np.random.Generator, plan: BowlPlan, bottom: float) -> Float64[np.ndarray, "L 2"]:
    """From the centre out to where the wall begins."""
    if plan.foot == 0:
        hollow = between(rng, 0, 0.5) * plan.wall if chance(rng, 0.5) else 0.0
        return np.array([[0.0, hollow], [0.7 * bottom, hollow], [0.8 * bottom, 0.0]])
    tall = plan.foot > 0.014
    spread = between(rng, 0.8, 1.5) if tall else between(rng, 0.85, 1.1)
    stem = between(rng, 0.35, 0.8) if tall else between(rng, 0.6, 0.98)
    ring = max(bottom * stem, 0.3 * plan.radius)
    lip = min(ring * spread, 0.95 * plan.radius)
    wide = min(between(rng, 0.002, 0.006), 0.5 * lip)
    deep = 0.0 if chance(rng, 0.3) else 0.8 * plan.foot  # a solid or a hollow foot
    path = [[0.0, deep], [lip - 2 * wide, deep], [lip - wide, 0.0], [lip, 0.0], [ring, 0.97 * plan.foot]]
    return rounded_polyline(np.array(path), [0, 0.001, 0.0005, 0.001, 0], 3)


def _rim(
    rng: np.random.Generator, plan: BowlPlan, outer: Float64[np.ndarray, "K 2"], inner: Float64[np.ndarray, "K 2"]
) -> list[Float64[np.ndarray, "L 2"]]:
    """Between the last points of the outer and the inner surface."""
    edge, back, wall = outer[-1], inner[-1], plan.wall
    kind = pick(rng, ((4, "round"), (2, "flat"), (1.5, "rolled"), (0.6, "flange")))
    middle = (edge + back) / 2
    if kind == "round":
        return [middle[None] + np.array([[0.25 * wall, 0.35 * wall], [-0.25 * wall, 0.35 * wall]])]
    if kind == "flat":
        return []
    if kind == "rolled":
        bead = max(between(rng, 0.8, 1.8) * wall, between(rng, 0.0012, 0.003))
        angle = np.linspace(-0.4 * np.pi, 0.9 * np.pi, 7)
        return [edge + [0.3 * bead, 0] + bead * np.column_stack([np.cos(angle), np.sin(angle)])]
    out = plan.radius * between(rng, 0.04, 0.2)
    up = out * between(rng, -0.1, 0.25)
    return [np.array([edge + [out, up - 0.5 * wall], edge + [out, up + 0.5 * wall], back + [0, wall]])]


def _inside(rng: np.random.Generator, inner: Float64[np.ndarray, "K 2"]) -> Float64[np.ndarray, "L 2"]:
    """Down the inside to the centre of the floor, or of what the bowl is filled with."""
    down = inner[::-1]
    floor = float(inner[:, 1].min())
    if not chance(rng, 0.12):
        return np.concatenate([down, [[0.5 * down[-1, 0], floor], [0.0, floor]]])
    level = floor + between(rng, 0.25, 0.92) * (float(down[0, 1]) - floor)
    above = down[down[:, 1] > level]
    radius = float(np.interp(level, inner[:, 1], inner[:, 0]))
    heap = between(rng, 0.05, 0.5) * (float(down[0, 1]) - floor) if chance(rng, 0.3) else 0.0  # liquid is flat
    t = np.linspace(1, 0, 6)
    content = np.column_stack([radius * t, level + heap * np.cos(t * np.pi / 2) ** 2])
    return np.concatenate([above, content])


def _section(
    rng: np.random.Generator, plan: BowlPlan, profile: Float64[np.ndarray, "M 2"]
) -> Float64[np.ndarray, "M AROUND"] | None:
    """Departures from the circle that grow from the foot to the rim; point-symmetric, so the box stays centred."""
    if not chance(rng, 0.15):
        return None
    angle = np.arange(AROUND) * (2 * np.pi / AROUND)
    kind = pick(rng, ((3, "flutes"), (2, "facets"), (1.2, "square"), (1.5, "wavy rim")))
    grown = np.clip((profile[:, 1] / plan.height - 0.05) / 0.5, 0, 1)[:, None]
    if kind == "flutes":
        factor = 1 + between(rng, 0.008, 0.03) * np.cos(4 * int(rng.integers(2, 5)) * angle)
    elif kind == "facets":
        factor = polygon_factor(angle, int(rng.choice([6, 8, 12])), between(rng, 0.0, 0.4))
    elif kind == "square":
        factor = superellipse_factor(angle, between(rng, 2.3, 3.6)) * between(rng, 0.86, 1.0)
    else:
        factor = 1 + between(rng, 0.02, 0.05) * np.cos(2 * int(rng.integers(2, 6)) * angle)
        grown = np.clip((profile[:, 1] / plan.height - 0.55) / 0.45, 0, 1)[:, None] ** 2
    return np.asarray(1 + (factor - 1) * grown)

"""Cans by kind: measures, the wall's outline and how both ends are closed."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import through
from captra.data.shapes.draws import between, chance, pick

STATIONS = 64
"""Of the wall: enough for fourteen beads."""

Bottom = Literal["domed", "rim", "flat"]
Top = Literal["ring", "rim", "flat", "plug", "overcap"]
Lid = Literal["closed", "mouth", "open", "bent"]


@dataclass(frozen=True)
class CanPlan:
    """What a can is like, metres."""

    radius: float
    """Of the wall."""
    height: float
    """With its rims."""
    neck: float
    """Radius of the upper rim, relative to the wall's."""
    neck_height: float
    """How far down from the top the wall is drawn in."""
    base: float
    """Radius of the ring that it stands on, relative to the wall's."""
    base_height: float
    """How far up the wall is drawn in."""
    bottom: Bottom
    """How the lower end is closed."""
    top: Top
    """What the upper end is like."""
    lid: Lid
    """Whether and how it is opened."""
    beads: bool
    """Whether the wall may have beads."""


def draw_plan(rng: np.random.Generator) -> CanPlan:
    """Drinks can, food tin, flat tin or canister."""
    kind = pick(rng, ((4.5, drink), (3, food), (1.3, flat), (1, canister)))
    return kind(rng)


def drink(rng: np.random.Generator) -> CanPlan:
    """Drawn aluminium: a neck, a narrow upper rim, a domed bottom on a ring."""
    radius, height = pick(rng, ((4, (0.0331, 0.122)), (2, (0.029, 0.146)), (1.5, (0.0265, 0.134)), (1, (0.0331, 0.168)),
                                (0.7, (0.0265, 0.089)), (0.5, (0.042, 0.16))))  # fmt: skip
    stretch = between(rng, 0.94, 1.08)
    radius, height = radius * stretch, height * stretch * between(rng, 0.9, 1.1)
    return CanPlan(
        radius,
        height,
        neck=between(rng, 0.74, 0.97),
        neck_height=between(rng, 0.005, 0.026),
        base=between(rng, 0.7, 0.9),
        base_height=between(rng, 0.003, 0.015),
        bottom="domed",
        top=pick(rng, ((9, "ring"), (0.6, "flat"))),
        lid=pick(rng, ((5, "closed"), (4, "mouth"), (0.5, "open"))),
        beads=False,
    )


def food(rng: np.random.Generator) -> CanPlan:
    """Tin plate: a straight wall with a rim at both ends, beads, ring pull or none."""
    radius = between(rng, 0.023, 0.055)
    height = radius * 2 * between(rng, 0.95, 2.0)
    narrowed = chance(rng, 0.25)
    return CanPlan(
        radius,
        height,
        neck=1 + between(rng, 0.0, 0.035),
        neck_height=between(rng, 0.001, 0.003),
        base=between(rng, 0.88, 0.97) if narrowed else 1 + between(rng, 0.0, 0.035),
        base_height=between(rng, 0.003, 0.012) if narrowed else between(rng, 0.001, 0.003),
        bottom=pick(rng, ((5, "rim"), (1, "flat"))),
        top=pick(rng, ((6, "rim"), (1, "flat"), (0.7, "overcap"))),
        lid=pick(rng, ((6, "closed"), (1.6, "open"), (0.5, "bent"))),
        beads=True,
    )


def flat(rng: np.random.Generator) -> CanPlan:
    """Wider than high: fish, pet food, shoe polish."""
    radius = between(rng, 0.03, 0.06)
    height = radius * 2 * between(rng, 0.22, 0.8)
    return CanPlan(
        radius,
        height,
        neck=1 + between(rng, -0.02, 0.05),
        neck_height=between(rng, 0.001, 0.003),
        base=1 + between(rng, -0.12, 0.03),
        base_height=between(rng, 0.001, 0.006),
        bottom=pick(rng, ((4, "rim"), (1, "flat"))),
        top=pick(rng, ((5, "rim"), (1, "flat"), (1, "plug"), (1, "overcap"))),
        lid=pick(rng, ((6, "closed"), (1.4, "open"), (0.4, "bent"))),
        beads=chance(rng, 0.3),
    )


def canister(rng: np.random.Generator) -> CanPlan:
    """Paint, coffee, powdered milk, tennis balls: a plug lid, an overcap or a plain end."""
    radius = between(rng, 0.035, 0.078)
    height = min(radius * 2 * between(rng, 0.9, 2.6), 0.26)
    return CanPlan(
        radius,
        height,
        neck=1 + between(rng, -0.04, 0.03),
        neck_height=between(rng, 0.001, 0.01),
        base=1 + between(rng, -0.05, 0.03),
        base_height=between(rng, 0.001, 0.006),
        bottom=pick(rng, ((4, "rim"), (2, "flat"))),
        top=pick(rng, ((3, "plug"), (3, "overcap"), (2, "flat"), (1, "rim"))),
        lid=pick(rng, ((6, "closed"), (1, "open"))),
        beads=chance(rng, 0.4),
    )


def wall(rng: np.random.Generator, plan: CanPlan) -> Float64[np.ndarray, "STATIONS 2"]:
    """Outer outline (radius, y) of the wall from the lower to the upper rim."""
    t = np.linspace(0, 1, STATIONS)
    low, high = plan.base_height, plan.height - min(plan.neck_height, 0.3 * plan.height)
    steep = between(rng, 0.3, 1.4)
    y = np.concatenate([np.linspace(0, low, 5), np.linspace(low, high, STATIONS - 12)[1:-1]])
    y = np.concatenate([y, np.linspace(high, plan.height, 9)])
    foot = plan.base + (1 - plan.base) * np.clip(y / low, 0, 1) ** steep
    drawn = np.clip((y - high) / (plan.height - high), 0, 1)
    curve = pick(rng, ((2, drawn), (2, 0.5 - 0.5 * np.cos(np.pi * drawn)), (1, drawn**1.7), (1, drawn**0.6)))
    radius = plan.radius * foot * (1 + (plan.neck - 1) * curve)
    if plan.beads and chance(rng, 0.6):
        radius = radius + _beads(rng, plan, y)
    if chance(rng, 0.06):
        radius = radius * through((0, 0.5, 1), (1, between(rng, 0.85, 1.06), 1), t)
    return np.column_stack([radius, y])


def _beads(rng: np.random.Generator, plan: CanPlan, y: Float64[np.ndarray, " K"]) -> Float64[np.ndarray, " K"]:
    """Ribs that are rolled into the wall, in one or two groups."""
    count, depth = int(rng.integers(3, 13)), between(rng, 0.0004, 0.0018)
    low, high = between(rng, 0.1, 0.35) * plan.height, between(rng, 0.65, 0.9) * plan.height
    phase = (y - low) / (high - low)
    ribs = depth * (0.5 * np.cos(2 * np.pi * count * phase) - 0.5) * ((phase > 0) & (phase < 1))
    if chance(rng, 0.25):
        ribs = ribs * (np.abs(phase - 0.5) > 0.17)
    return np.asarray(ribs)

"""Outer outlines of bowls: radius over height, from the foot of the wall to the rim."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import through
from captra.data.shapes.draws import between, chance

STATIONS = 28


@dataclass(frozen=True)
class BowlOutline:
    """Outside of the wall, relative to the radius of the mouth."""

    radius: Float64[np.ndarray, " K"]
    """1 at the rim, unless the mouth is drawn in."""
    height: Float64[np.ndarray, " K"]
    """Relative height of each station, 0 to 1."""
    deep: tuple[float, float]
    """Range of height by diameter of the mouth that suits this outline."""


def _at() -> Float64[np.ndarray, " K"]:
    return np.asarray(0.5 - 0.5 * np.cos(np.linspace(0, np.pi, STATIONS)))


def rounded(rng: np.random.Generator) -> BowlOutline:
    """Part of a ball or an ellipsoid: the outline turns from flat to steep."""
    bottom, power = between(rng, 0.2, 0.6), between(rng, 1.7, 3.2)
    turn = np.linspace(0, np.pi / 2 * between(rng, 0.8, 1.0), STATIONS)
    radius = np.sin(turn) ** (2 / power)
    height = 1 - np.cos(turn) ** (2 / power)
    radius, height = radius / radius[-1], height / height[-1]
    return BowlOutline(bottom + (1 - bottom) * radius, height, (0.2, 0.62))


def conical(rng: np.random.Generator) -> BowlOutline:
    """Straight or nearly straight walls that lean out."""
    t = _at()
    bottom, bend = between(rng, 0.25, 0.8), between(rng, -0.08, 0.12)
    return BowlOutline(bottom + (1 - bottom) * t + bend * np.sin(np.pi * t), t, (0.16, 0.55))


def upright(rng: np.random.Generator) -> BowlOutline:
    """A steep wall over a wide floor, its lower edge rounded off."""
    t = _at()
    lean, corner = between(rng, 0.0, 0.14), between(rng, 0.08, 0.6)
    rise = np.clip(t / corner, 0, 1)
    start = between(rng, 0.5, 0.92)
    quarter = start + (1 - lean - start) * np.sqrt(1 - (1 - rise) ** 2)
    return BowlOutline(quarter + lean * t, t, (0.16, 0.6))


def belled(rng: np.random.Generator) -> BowlOutline:
    """Bellied below, flared at the rim, in an S."""
    t = _at()
    bottom, waist = between(rng, 0.25, 0.55), between(rng, 0.75, 0.93)
    knots = (0, between(rng, 0.12, 0.3), between(rng, 0.5, 0.8), 1)
    return BowlOutline(through(knots, (bottom, between(rng, 0.6, 0.74), waist, 1), t), t, (0.25, 0.6))


def drawn_in(rng: np.random.Generator) -> BowlOutline:
    """Widest below the rim."""
    t = _at()
    bottom, widest = between(rng, 0.35, 0.75), between(rng, 1.02, 1.22)
    radius = through((0, 0.2, between(rng, 0.4, 0.75), 1), (bottom, (bottom + 2 * widest) / 3, widest, 1), t)
    return BowlOutline(radius, t, (0.3, 0.75))


def dish(rng: np.random.Generator) -> BowlOutline:
    """A shallow well with a broad flat brim, as of a soup plate."""
    t = _at()
    brim, bottom = between(rng, 0.62, 0.86), between(rng, 0.35, 0.6)
    top = between(rng, 0.7, 0.95)
    radius = through((0, 0.5 * top, top, 1), (bottom, 0.5 * (bottom + brim) + 0.08, brim, 1), t)
    return BowlOutline(radius, t, (0.14, 0.3))


def stepped(rng: np.random.Generator) -> BowlOutline:
    """A shoulder part of the way up, as of stacking and mixing bowls."""
    t = _at()
    bottom, lower, step = between(rng, 0.4, 0.8), between(rng, 0.84, 0.95), between(rng, 0.35, 0.85)
    radius = np.where(t < step, bottom + (lower - bottom) * np.sqrt(t / step), lower + (0.98 - lower) * 0.6)
    radius = radius + np.clip((t - step) / (1 - step), 0, 1) * (1 - radius)
    return BowlOutline(radius, t, (0.2, 0.55))


def free(rng: np.random.Generator) -> BowlOutline:
    """Through random knots."""
    t = _at()
    values = np.sort(rng.uniform(0.3, 1.05, 3)) if chance(rng, 0.7) else rng.uniform(0.5, 1.08, 3)
    return BowlOutline(through((0, 0.3, 0.65, 1), (*values, 1.0), t), t, (0.18, 0.65))


FAMILIES: tuple[tuple[float, Callable[[np.random.Generator], BowlOutline]], ...] = (
    (4.5, rounded),
    (2.0, conical),
    (2.2, upright),
    (1.6, belled),
    (0.7, drawn_in),
    (0.7, dish),
    (0.7, stepped),
    (1.0, free),
)

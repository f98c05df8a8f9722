"""Outlines of lenses, counter-clockwise seen from +z, around the lens's own centre; +x is away from the nose."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import superellipse
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, grid_mesh

AROUND = 48

Outline = Float64[np.ndarray, "S 2"]


@dataclass(frozen=True)
class Style:
    """How a superellipse is turned into a lens."""

    half: tuple[float, float]
    """Half its width and height, metres."""
    exponent: float = 2.2
    """2 for an ellipse, more for a rounded rectangle."""
    widening: float = 0.0
    """Relative growth of the width towards the top."""
    lift: float = 0.0
    """Relative rise of the upper outer corner: cat eyes."""
    nasal_cut: float = 0.0
    """Relative rise of the lower inner corner: aviators."""
    flat_top: float = 1.0
    """Relative height at which the top is cut."""


def lens_outline(style: Style) -> Outline:
    """(x, y) of `AROUND` points, the first one at +x."""
    x, y = superellipse(AROUND, style.exponent).T
    right, left = np.clip(x, 0, None), np.clip(-x, 0, None)
    upper, lower = np.clip(y, 0, None), np.clip(-y, 0, None)
    wide = x * (1 + style.widening * y)
    tall = np.minimum(y, style.flat_top) + style.lift * right**2 * upper + style.nasal_cut * left**1.5 * lower**0.7
    return np.column_stack([wide * style.half[0], tall * style.half[1]])


def draw_style(rng: np.random.Generator) -> Style:
    """One of the families of frames."""
    return pick(rng, FAMILIES)(rng)


def _round(rng: np.random.Generator) -> Style:
    radius = between(rng, 0.019, 0.027)
    return Style((radius, radius * between(rng, 0.9, 1.05)), between(rng, 1.9, 2.3), flat_top=_flat(rng))


def _oval(rng: np.random.Generator) -> Style:
    half = between(rng, 0.021, 0.028)
    return Style((half, half * between(rng, 0.48, 0.85)), between(rng, 2.0, 2.8), between(rng, -0.04, 0.1))


def _rectangle(rng: np.random.Generator) -> Style:
    half = between(rng, 0.023, 0.03)
    tall = half * between(rng, 0.4, 0.75)
    return Style((half, tall), between(rng, 3.0, 8.0), between(rng, -0.02, 0.1), between(rng, 0, 0.12))


def _square(rng: np.random.Generator) -> Style:
    half = between(rng, 0.022, 0.031)
    return Style((half, half * between(rng, 0.75, 1.0)), between(rng, 2.8, 6.0), between(rng, 0, 0.14))


def _wayfarer(rng: np.random.Generator) -> Style:
    half = between(rng, 0.023, 0.028)
    cut, lift = between(rng, 0, 0.25), between(rng, 0.0, 0.25)
    return Style((half, half * between(rng, 0.66, 0.9)), between(rng, 2.5, 3.6), between(rng, 0.08, 0.2), lift, cut)


def _aviator(rng: np.random.Generator) -> Style:
    half = between(rng, 0.026, 0.032)
    tall = half * between(rng, 0.78, 0.98)
    cut = between(rng, 0.2, 0.55)
    return Style((half, tall), between(rng, 2.0, 2.8), between(rng, 0, 0.12), 0.0, cut, _flat(rng))


def _cat_eye(rng: np.random.Generator) -> Style:
    half = between(rng, 0.022, 0.028)
    lift = between(rng, 0.25, 0.7)
    return Style((half, half * between(rng, 0.55, 0.85)), between(rng, 2.0, 3.2), between(rng, 0.05, 0.2), lift)


def _panto(rng: np.random.Generator) -> Style:
    half = between(rng, 0.02, 0.026)
    return Style(
        (half, half * between(rng, 0.85, 1.0)), between(rng, 2.1, 2.7), between(rng, 0.05, 0.16), flat_top=0.85
    )


def _flat(rng: np.random.Generator) -> float:
    return between(rng, 0.6, 0.9) if chance(rng, 0.35) else 1.0


FAMILIES: tuple[tuple[float, Callable[[np.random.Generator], Style]], ...] = (
    (2.0, _round),
    (1.5, _oval),
    (2.5, _rectangle),
    (2.0, _square),
    (2.5, _wayfarer),
    (2.0, _aviator),
    (1.2, _cat_eye),
    (1.5, _panto),
)


def shield_outline(rng: np.random.Generator) -> Outline:
    """One lens for both eyes with a notch for the nose; its width is measured along the wrap."""
    half = np.array([between(rng, 0.068, 0.092), between(rng, 0.016, 0.03)])
    outline = superellipse(2 * AROUND, between(rng, 2.6, 6.0)) * half
    below = outline[:, 1] < 0
    depth, width = between(rng, 0.3, 0.95) * half[1], between(rng, 0.009, 0.02)
    outline[:, 1] += below * depth * np.exp(-((outline[:, 0] / width) ** 2)) * np.abs(outline[:, 1]) / half[1]
    sides = np.abs(outline[:, 0]) / half[0]
    outline[:, 1] *= 1 - between(rng, 0.0, 0.5) * np.clip(sides - 0.4, 0, 1) ** 2 * (outline[:, 1] < 0)
    return np.asarray(outline)


def lens(outline: Outline, centre: tuple[float, float], thickness: float, bulge: float) -> Mesh:
    """A plate with this outline whose faces bulge towards +z in the middle; star-shaped about `centre`."""
    middle = np.array(centre)
    steps = np.array([0.02, 0.3, 0.6, 0.85, 1.0])
    layers = []
    for side, scales in ((-1, steps), (1, steps[::-1])):
        for scale in scales:
            ring = middle + (outline - middle) * scale
            z = side * thickness / 2 + bulge * (1 - scale**2)
            layers.append(np.column_stack([ring, np.full(len(ring), z)]))
    return grid_mesh(np.stack(layers), caps=True)

"""Kinds of cameras and their measures. x is forward, y up, z towards the photographer's right hand."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from captra.data.shapes.camera_lenses import LensPlan
from captra.data.shapes.draws import between, chance, pick

Hump = Literal["none", "prism", "rounded", "box", "plate"]


@dataclass(frozen=True)
class CameraPlan:
    """Overall measures, metres; positions are relative to the middle of the body's front."""

    depth: float
    """Of the body, along x."""
    height: float
    """Of the body without hump and knobs."""
    width: float
    """Of the body, along z."""
    exponent: float
    """How boxy the body is seen from above."""
    fillet: float
    """Of its upper and lower edges."""
    lens: LensPlan
    """What stands out to the front."""
    lens_y: float
    """Height of the lens axis above the middle of the body."""
    lens_z: float
    """Its place across."""
    grip: float
    """How far the grip stands out; 0 for none."""
    hump: Hump
    """What stands on the body above the lens."""
    knobs: int
    """Largest number of dials on top."""
    folding: bool
    """Whether a bellows carries the lens."""


def draw_plan(rng: np.random.Generator) -> CameraPlan:
    """One of the kinds, by how often one meets them."""
    kinds: tuple[tuple[float, Callable[[np.random.Generator], CameraPlan]], ...] = (
        (3.2, compact),
        (2.2, mirrorless),
        (3.2, reflex),
        (1.8, film_reflex),
        (1.2, rangefinder),
        (0.7, boxy),
    )
    return pick(rng, kinds)(rng)


def compact(rng: np.random.Generator) -> CameraPlan:
    """Pocket camera: flat, its lens retracted or run out."""
    height, width = between(rng, 0.05, 0.074), between(rng, 0.084, 0.12)
    radius = min(between(rng, 0.012, 0.028), 0.44 * height)
    out = pick(rng, ((1, between(rng, 0.001, 0.006)), (2, between(rng, 0.006, 0.025)), (1.5, between(rng, 0.02, 0.06))))
    return CameraPlan(
        depth=between(rng, 0.016, 0.036),
        height=height,
        width=width,
        exponent=between(rng, 3, 14),
        fillet=between(rng, 0.001, 0.008),
        lens=LensPlan(radius, out, int(rng.integers(1, 4))),
        lens_y=height * between(rng, -0.1, 0.05),
        lens_z=-width * between(rng, -0.05, 0.22),
        grip=pick(rng, ((3, 0.0), (2, between(rng, 0.002, 0.01)))),
        hump=pick(rng, ((8, "none"), (1, "box"), (0.7, "rounded"))),
        knobs=int(rng.integers(0, 4)),
        folding=False,
    )


def mirrorless(rng: np.random.Generator) -> CameraPlan:
    """System camera: a flat body, a wide mount, a low hump or none."""
    height, width = between(rng, 0.058, 0.085), between(rng, 0.1, 0.136)
    return CameraPlan(
        depth=between(rng, 0.026, 0.045),
        height=height,
        width=width,
        exponent=between(rng, 4, 14),
        fillet=between(rng, 0.001, 0.008),
        lens=_system_lens(rng, between(rng, 0.027, 0.038), 0.015),
        lens_y=height * between(rng, -0.1, 0.02),
        lens_z=-width * between(rng, 0.0, 0.14),
        grip=pick(rng, ((1, 0.0), (3, between(rng, 0.006, 0.03)))),
        hump=pick(rng, ((2, "none"), (2, "rounded"), (2, "box"), (1, "prism"))),
        knobs=int(rng.integers(1, 5)),
        folding=False,
    )


def reflex(rng: np.random.Generator) -> CameraPlan:
    """Digital reflex or bridge camera: a high pentaprism, a deep grip, a large lens."""
    size = between(rng, 0.82, 1.12)
    height, width = size * between(rng, 0.07, 0.095), size * between(rng, 0.115, 0.145)
    if chance(rng, 0.1):
        height += between(rng, 0.03, 0.05)  # battery grip
    return CameraPlan(
        depth=size * between(rng, 0.038, 0.062),
        height=height,
        width=width,
        exponent=between(rng, 2.8, 8),
        fillet=between(rng, 0.003, 0.014),
        lens=_system_lens(rng, size * between(rng, 0.03, 0.044), 0.025),
        lens_y=size * between(rng, -0.012, 0.004),
        lens_z=-width * between(rng, 0.0, 0.13),
        grip=between(rng, 0.012, 0.038) * size,
        hump=pick(rng, ((3, "prism"), (4, "rounded"))),
        knobs=int(rng.integers(1, 5)),
        folding=False,
    )


def film_reflex(rng: np.random.Generator) -> CameraPlan:
    """Metal reflex camera: a boxy body without grip, an angular prism, knobs at both ends."""
    height, width = between(rng, 0.058, 0.078), between(rng, 0.126, 0.152)
    return CameraPlan(
        depth=between(rng, 0.03, 0.048),
        height=height,
        width=width,
        exponent=between(rng, 5, 20),
        fillet=between(rng, 0.0005, 0.004),
        lens=_system_lens(rng, between(rng, 0.027, 0.036), 0.025),
        lens_y=height * between(rng, -0.08, 0.06),
        lens_z=width * between(rng, -0.06, 0.04),
        grip=pick(rng, ((5, 0.0), (1, between(rng, 0.004, 0.014)))),
        hump=pick(rng, ((5, "prism"), (1, "box"))),
        knobs=int(rng.integers(3, 6)),
        folding=False,
    )


def rangefinder(rng: np.random.Generator) -> CameraPlan:
    """Flat-topped old camera: a full top plate with windows, a short lens or a bellows."""
    height, width = between(rng, 0.062, 0.088), between(rng, 0.105, 0.148)
    folding = chance(rng, 0.25)
    return CameraPlan(
        depth=between(rng, 0.026, 0.044),
        height=height,
        width=width,
        exponent=between(rng, 3, 14),
        fillet=between(rng, 0.0005, 0.005),
        lens=LensPlan(between(rng, 0.018, 0.032), between(rng, 0.012, 0.055), int(rng.integers(2, 5))),
        lens_y=height * between(rng, -0.14, 0.0),
        lens_z=width * between(rng, -0.08, 0.05),
        grip=0.0,
        hump=pick(rng, ((3, "plate"), (1, "none"))),
        knobs=int(rng.integers(2, 6)),
        folding=folding,
    )


def boxy(rng: np.random.Generator) -> CameraPlan:
    """Deep or cubic: box, instant and medium-format cameras."""
    height, width = between(rng, 0.075, 0.12), between(rng, 0.07, 0.12)
    return CameraPlan(
        depth=between(rng, 0.05, 0.13),
        height=height,
        width=width,
        exponent=between(rng, 6, 20),
        fillet=between(rng, 0.001, 0.012),
        lens=LensPlan(between(rng, 0.014, 0.036), between(rng, 0.003, 0.06), int(rng.integers(1, 4))),
        lens_y=height * between(rng, -0.15, 0.12),
        lens_z=width * between(rng, -0.12, 0.08),
        grip=pick(rng, ((3, 0.0), (1, between(rng, 0.006, 0.03)))),
        hump=pick(rng, ((3, "none"), (1.5, "box"), (1, "rounded"))),
        knobs=int(rng.integers(0, 4)),
        folding=False,
    )


def _system_lens(rng: np.random.Generator, radius: float, shortest: float) -> LensPlan:
    """Pancake, standard or tele; now and then only the mount."""
    kind = pick(rng, ((1, "pancake"), (5, "standard"), (2.5, "long"), (0.7, "tele"), (0.3, "mount")))
    ranges = {"pancake": (0.6, 1.0), "standard": (1.0, 2.6), "long": (2.4, 4.2), "mount": (0.1, 0.2)}
    length = radius * between(rng, 3.5, 5.5) if kind == "tele" else shortest * between(rng, *ranges[kind])
    wide = between(rng, 0.8, 1.12) if kind != "tele" else between(rng, 0.95, 1.25)
    return LensPlan(float(radius * wide), float(np.maximum(length, 0.003)), int(rng.integers(2, 6)))

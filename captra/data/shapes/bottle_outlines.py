"""Outlines of bottle bodies up to the mouth, one function a family; metres."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.curves import through
from captra.data.shapes.draws import between, chance, pick

CapKind = str


@dataclass(frozen=True)
class Outline:
    """What is below the cap."""

    radius: Float64[np.ndarray, " K"]
    """Outer radius at each height, from the bottom edge to the mouth."""
    y: Float64[np.ndarray, " K"]
    """Heights, increasing from 0."""
    bottom_fillet: float
    """Radius of the edge between bottom and body."""
    body_top: float
    """Height where the shoulder starts: squared sections fade out above it."""
    cap: CapKind
    """What closes it."""


def _assemble(
    rng: np.random.Generator,
    body: tuple[Float64[np.ndarray, " A"], Float64[np.ndarray, " A"]],
    shoulder: tuple[Float64[np.ndarray, " B"], Float64[np.ndarray, " B"]],
    neck: tuple[Float64[np.ndarray, " C"], Float64[np.ndarray, " C"]],
    cap: CapKind,
) -> Outline:
    radius = np.concatenate([body[0], shoulder[0], neck[0]])
    y = np.concatenate([body[1], shoulder[1], neck[1]])
    fillet = float(body[0][0]) * pick(rng, ((2, between(rng, 0.03, 0.15)), (1, between(rng, 0.15, 0.5))))
    return Outline(radius, y, min(fillet, 0.4 * float(body[1][-1])), float(body[1][-1]), cap)


def shoulder_curve(
    rng: np.random.Generator, low: float, high: float, start: float, end: float
) -> tuple[Float64[np.ndarray, " K"], Float64[np.ndarray, " K"]]:
    """(radius, y) from the body's radius `low` at height `start` to the neck's radius `high` at height `end`."""
    t = np.linspace(0, 1, 12)
    kind = pick(rng, ((3, "s"), (2, "dome"), (1.5, "cone"), (1.5, "flare")))
    if kind == "s":
        sharp = between(rng, 0.8, 1.8)
        bend = t**sharp / (t**sharp + (1 - t) ** sharp)
        bend = bend * bend * (3 - 2 * bend)
    elif kind == "dome":
        bend = 1 - np.sqrt(np.maximum(0, 1 - t ** between(rng, 1.6, 2.4)))
    elif kind == "cone":
        bend = t ** between(rng, 0.85, 1.2)
    else:
        bend = 1 - (1 - t) ** between(rng, 1.4, 2.4)
    return low + (high - low) * bend, start + (end - start) * t


def _cylinder(
    rng: np.random.Generator, radius: float, top: float, variation: float = 0.0, stations: int = 24
) -> tuple[Float64[np.ndarray, " K"], Float64[np.ndarray, " K"]]:
    t = np.linspace(0, 1, stations)
    r = np.ones(stations)
    if variation > 0:
        r = through(np.linspace(0, 1, 5), [*(1 - rng.uniform(0, variation, 4)), 1.0], t)
    elif chance(rng, 0.3):
        r = 1 - (1 - t) * between(rng, -0.06, 0.1)
    return radius * r, t * top


def _neck(
    rng: np.random.Generator, radius: float, start: float, end: float, lip: bool
) -> tuple[Float64[np.ndarray, " K"], Float64[np.ndarray, " K"]]:
    y = np.linspace(start + 1e-4, end, 10)
    r = radius * np.linspace(1, between(rng, 0.85, 1.02), 10)
    if lip:
        height = between(rng, 0.004, 0.02)
        r = np.where(y > end - height, r + between(rng, 0.0008, 0.003), r)
    return r, y


def wine(rng: np.random.Generator) -> Outline:
    """Bordeaux, Burgundy, hock, spirits."""
    height = between(rng, 0.2, 0.35)
    radius = height * between(rng, 0.1, 0.155)
    neck = between(rng, 0.012, 0.0165)
    start, end = height * between(rng, 0.38, 0.66), height * between(rng, 0.68, 0.8)
    return _assemble(
        rng,
        _cylinder(rng, radius, start),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=chance(rng, 0.7)),
        pick(rng, ((2, "foil"), (1, "cork"), (1, "screw"), (1.5, "open"))),
    )


def beer(rng: np.random.Generator) -> Outline:
    """Long necks, stubbies, soda bottles of glass."""
    height = between(rng, 0.15, 0.28)
    radius = between(rng, 0.025, 0.038)
    neck = between(rng, 0.011, 0.016)
    start = height * between(rng, 0.4, 0.62)
    end = min(height - 0.012, start + height * between(rng, 0.12, 0.38))
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.0, 0.12) if chance(rng, 0.25) else 0.0),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=chance(rng, 0.8)),
        pick(rng, ((3, "crown"), (1, "open"), (1, "screw"))),
    )


def water(rng: np.random.Generator) -> Outline:
    """PET bottles: ribs, waists, domed shoulders, a short neck with a collar."""
    height = between(rng, 0.14, 0.33)
    radius = np.clip(height * between(rng, 0.12, 0.19), 0.025, 0.055)
    neck = between(rng, 0.0105, 0.02)
    start, end = height * between(rng, 0.55, 0.8), height * between(rng, 0.85, 0.93)
    r, y = _cylinder(rng, radius, start, between(rng, 0.03, 0.22) if chance(rng, 0.6) else 0.0, stations=56)
    if chance(rng, 0.65):
        r = r * (1 - _ribs(rng, y / start))
    return _assemble(
        rng,
        (r, y),
        shoulder_curve(rng, float(r[-1]), neck, start, end),
        _neck(rng, neck, end, height, lip=False),
        pick(rng, ((5, "screw"), (1.5, "sport"), (0.7, "open"))),
    )


def _ribs(rng: np.random.Generator, t: Float64[np.ndarray, " K"]) -> Float64[np.ndarray, " K"]:
    depth, count = between(rng, 0.01, 0.06), int(rng.integers(2, 10))
    low, high = between(rng, 0.0, 0.4), between(rng, 0.6, 1.0)
    wave = 0.5 - 0.5 * np.cos(2 * np.pi * count * (t - low) / (high - low))
    if chance(rng, 0.5):
        wave = wave ** between(rng, 2, 5)
    return np.asarray(depth * wave * ((t > low) & (t < high)))


def care(rng: np.random.Generator) -> Outline:
    """Shampoo, gel, lotion, soap and cleaning bottles."""
    height = between(rng, 0.08, 0.24)
    radius = np.clip(height * between(rng, 0.15, 0.3), 0.016, 0.05)
    neck = radius * between(rng, 0.2, 0.85)
    start = height * between(rng, 0.6, 0.9)
    end = min(start + radius * between(rng, 0.1, 0.9), height - 0.004)
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.0, 0.15) if chance(rng, 0.4) else 0.0),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=False),
        pick(rng, ((2, "wide"), (2, "pump"), (1, "screw"), (0.8, "spout"), (0.5, "dome"))),
    )


def medicine(rng: np.random.Generator) -> Outline:
    """Pill and syrup bottles, droppers, jars."""
    height = between(rng, 0.05, 0.14)
    radius = height * between(rng, 0.18, 0.42)
    neck = radius * between(rng, 0.35, 0.9)
    start = height * between(rng, 0.55, 0.86)
    end = min(start + height * between(rng, 0.03, 0.25), height - 0.003)
    return _assemble(
        rng,
        _cylinder(rng, radius, start),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=False),
        pick(rng, ((3, "wide"), (1.5, "screw"), (1, "dropper"), (0.5, "open"))),
    )


def milk(rng: np.random.Generator) -> Outline:
    """Milk, yogurt and juice bottles with wide necks."""
    height = between(rng, 0.1, 0.26)
    radius = np.clip(height * between(rng, 0.14, 0.24), 0.02, 0.055)
    neck = radius * between(rng, 0.4, 0.85)
    start = height * between(rng, 0.35, 0.72)
    end = height * between(rng, 0.76, 0.92)
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.05, 0.25) if chance(rng, 0.5) else 0.0),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=chance(rng, 0.4)),
        pick(rng, ((3, "wide"), (1, "screw"), (1, "open"))),
    )


def tumbler(rng: np.random.Generator) -> Outline:
    """Thermos flasks, drinking and sports bottles, baby bottles."""
    height = between(rng, 0.11, 0.28)
    radius = between(rng, 0.023, 0.045)
    neck = radius * between(rng, 0.6, 0.97)
    start = height * between(rng, 0.7, 0.93)
    end = min(start + between(rng, 0.005, 0.03), height - 0.003)
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.0, 0.2) if chance(rng, 0.4) else 0.0),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=False),
        pick(rng, ((2, "wide"), (1.5, "sport"), (1.5, "nipple"), (1, "dome"))),
    )


def squeeze(rng: np.random.Generator) -> Outline:
    """Ketchup, mustard, glue: a pointed tip."""
    height = between(rng, 0.1, 0.22)
    radius = height * between(rng, 0.13, 0.23)
    neck = radius * between(rng, 0.3, 0.7)
    start = height * between(rng, 0.7, 0.9)
    end = min(start + height * between(rng, 0.03, 0.12), height - 0.003)
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.0, 0.12) if chance(rng, 0.4) else 0.0),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=False),
        pick(rng, ((3, "tip"), (1, "spout"))),
    )


def free(rng: np.random.Generator) -> Outline:
    """Vases, carafes, perfume: any smooth outline that narrows towards the mouth."""
    height = between(rng, 0.07, 0.32)
    radius = np.clip(height * between(rng, 0.14, 0.4), 0.02, 0.06)
    start = height * between(rng, 0.35, 0.75)
    neck = radius * between(rng, 0.2, 0.7)
    end = start + (height - start) * between(rng, 0.3, 0.9)
    return _assemble(
        rng,
        _cylinder(rng, radius, start, between(rng, 0.1, 0.45)),
        shoulder_curve(rng, radius, neck, start, end),
        _neck(rng, neck, end, height, lip=chance(rng, 0.5)),
        pick(rng, ((1, "open"), (1, "cork"), (1, "screw"), (1, "dome"))),
    )


FAMILIES: tuple[tuple[float, Callable[[np.random.Generator], Outline]], ...] = (
    (2.2, wine),
    (1.8, beer),
    (2.6, water),
    (1.8, care),
    (1.2, medicine),
    (1.1, milk),
    (1.2, tumbler),
    (0.7, squeeze),
    (0.8, free),
)

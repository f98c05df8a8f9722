"""Handles of mugs and jugs: a curve in the x-y plane and a cross-section that varies along it."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

from captra.data.shapes.curves import resampled, rounded_polyline, superellipse, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import sweep

STATIONS = 26
AROUND = 12


@dataclass(frozen=True)
class Attachment:
    """Where a handle meets the body: both ends, in the x-y plane."""

    top: tuple[float, float]
    """x, y of the upper end on the outer surface, metres."""
    bottom: tuple[float, float]
    """x, y of the lower end."""
    sink: float
    """How far the ends go into the wall."""


def make_handle(rng: np.random.Generator, at: Attachment, gap: float, thickness: float, width: float) -> Mesh:
    """A handle that leaves `gap` metres between the body and its bar.

    `thickness` is measured in the x-y plane, `width` across it.
    """
    curve = resampled(_curve(rng, at, gap + thickness / 2), STATIONS)
    section = _sections(rng, thickness, width)
    curve3 = np.column_stack([curve, np.zeros(len(curve))])
    return sweep(curve3, section, np.array([0.0, 0.0, 1.0]))


def _curve(rng: np.random.Generator, at: Attachment, reach: float) -> Float64[np.ndarray, "K 2"]:
    kind = pick(rng, ((4, "round"), (3, "polyline"), (3, "ear"), (1.2, "square"), (0.8, "slope"), (0.7, "hook")))
    (xt, yt), (xb, yb) = at.top, at.bottom
    height = yt - yb
    out = max(xt, xb) + reach
    if kind == "round":
        power = between(rng, 0.75, 1.15)
        angle = np.linspace(np.pi / 2, -np.pi / 2, 30)
        y = (yt + yb) / 2 + height / 2 * np.sign(np.sin(angle)) * np.abs(np.sin(angle)) ** power
        base = np.interp(y, [yb, yt], [xb, xt])
        inner = np.column_stack([base + (out - base) * np.abs(np.cos(angle)) ** power, y])
    elif kind == "ear":
        lift, drop = between(rng, -0.05, 0.3) * height, between(rng, 0, 0.35) * height
        bulge = between(rng, 0.1, 0.35)
        knots = np.array(
            [
                [xt, yt],
                [xt + 0.55 * reach, yt + lift],
                [out, yt - bulge * height],
                [out - between(rng, 0.0, 0.25) * reach, yt - 0.62 * height],
                [xb + between(rng, 0.25, 0.6) * reach, yb - drop * 0.3],
                [xb, yb],
            ]
        )
        inner = rounded_polyline(knots, 1.0, steps=7)
    else:
        radius = {"square": between(rng, 0.0, 0.25), "polyline": between(rng, 0.3, 1.0)}.get(
            kind, between(rng, 0.2, 0.6)
        )
        tilt_top, tilt_low = between(rng, -0.08, 0.12) * height, between(rng, -0.12, 0.12) * height
        lean = between(rng, -0.25, 0.25) * reach
        upper, lower = [out, yt + tilt_top], [out - abs(lean), yb + tilt_low]
        if kind == "slope":
            lower = [xb + between(rng, 0.15, 0.5) * reach, yb + between(rng, 0.1, 0.3) * height]
        if kind == "hook":
            lower = [out, yb]
            tail = [out - between(rng, 0.3, 0.75) * reach, yb - between(rng, -0.05, 0.1) * height]
            corners = np.array([[xt, yt], upper, lower, tail])
        else:
            corners = np.array([[xt, yt], upper, lower, [xb, yb]])
        inner = rounded_polyline(corners, radius * min(reach, height / 2) * 1.2, steps=7)
    if kind == "hook":
        return np.concatenate([[[xt - at.sink, yt]], inner])
    return np.concatenate([[[xt - at.sink, yt]], inner, [[xb - at.sink, yb]]])


def _sections(rng: np.random.Generator, thickness: float, width: float) -> Float[np.ndarray, "K S 2"]:
    exponent = pick(rng, ((4, 2.0), (2, between(rng, 2.2, 4.0)), (1, between(rng, 4.0, 8.0))))
    at = np.linspace(0, 1, STATIONS)
    thick, wide = np.ones(STATIONS), np.ones(STATIONS)
    if chance(rng, 0.5):
        middle = between(rng, 0.75, 1.15)
        thick = through((0, 0.5, 1), (between(rng, 0.9, 1.3), middle, between(rng, 0.7, 1.2)), at)
        wide = through((0, 0.5, 1), (between(rng, 0.9, 1.35), middle, between(rng, 0.7, 1.2)), at)
    scale = np.stack([thick * thickness / 2, wide * width / 2], -1)
    return np.asarray(superellipse(AROUND, exponent)[None] * scale[:, None])

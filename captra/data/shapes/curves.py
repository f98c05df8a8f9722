"""Planar curves that profiles, cross-sections and handles are made of."""

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float, Float64
from scipy.interpolate import PchipInterpolator


def rounded_polyline(
    points: Float[np.ndarray, "K D"], radius: Sequence[float] | float, steps: int = 5
) -> Float64[np.ndarray, "L D"]:
    """Replace each inner corner by a quadratic Bézier arc that starts `radius` before it and ends `radius` after it.

    Radii are cut to half of the adjoining edges, so neighbouring arcs never overlap.
    """
    points = np.asarray(points, np.float64)
    radii = np.broadcast_to(np.asarray(radius, np.float64), (len(points),))
    edges = np.linalg.norm(np.diff(points, axis=0), axis=1)
    out = [points[:1]]
    s = np.linspace(0, 1, steps)[:, None]
    for k in range(1, len(points) - 1):
        before, after = edges[k - 1], edges[k]
        cut = min(float(radii[k]), 0.5 * before, 0.5 * after)
        if cut < 1e-5:
            out.append(points[k : k + 1])
            continue
        start = points[k] + (points[k - 1] - points[k]) * cut / before
        end = points[k] + (points[k + 1] - points[k]) * cut / after
        out.append((1 - s) ** 2 * start + 2 * s * (1 - s) * points[k] + s**2 * end)
    out.append(points[-1:])
    curve = np.concatenate(out)
    keep = np.concatenate([[True], np.linalg.norm(np.diff(curve, axis=0), axis=1) > 1e-6])
    return np.asarray(curve[keep])


def through(
    knots: Sequence[float] | Float[np.ndarray, " J"],
    values: Sequence[float] | Float[np.ndarray, " J"],
    at: Float[np.ndarray, " K"],
) -> Float64[np.ndarray, " K"]:
    """Monotone-preserving cubic through (knot, value), which never overshoots its values."""
    return np.asarray(PchipInterpolator(knots, values)(at))


def resampled(curve: Float[np.ndarray, "K D"], count: int) -> Float64[np.ndarray, "count D"]:
    """Points at equal arc length along a polyline, both ends kept."""
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    at = np.linspace(0, lengths[-1], count)
    return np.asarray(np.stack([np.interp(at, lengths, curve[:, d]) for d in range(curve.shape[1])], axis=-1))


def superellipse(count: int, exponent: float, half: tuple[float, float] = (1.0, 1.0)) -> Float64[np.ndarray, "count 2"]:
    """Closed curve |x/a|^n + |y/b|^n = 1, counter-clockwise from +x: 2 is an ellipse, large exponents a rectangle."""
    angle = np.arange(count) * (2 * np.pi / count)
    circle = np.stack([np.cos(angle), np.sin(angle)], -1)
    return np.asarray(circle * superellipse_factor(angle, exponent)[:, None] * half)


def superellipse_factor(angle: Float[np.ndarray, " S"], exponent: float) -> Float64[np.ndarray, " S"]:
    """Radius of the unit superellipse in each direction; 1 along the axes."""
    norm = np.abs(np.cos(angle)) ** exponent + np.abs(np.sin(angle)) ** exponent
    return np.asarray(norm ** (-1 / exponent))


def polygon_factor(angle: Float[np.ndarray, " S"], sides: int, roundness: float) -> Float64[np.ndarray, " S"]:
    """Radius of a regular polygon with unit circumradius, blended with the circle by `roundness` in [0, 1]."""
    half = np.pi / sides
    sector = np.mod(angle, 2 * half) - half
    return np.asarray((1 - roundness) * np.cos(half) / np.cos(sector) + roundness)

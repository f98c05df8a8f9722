"""Measures of a cabinet and of the openings in its front."""

from dataclasses import dataclass

import numpy as np

from captra.data.shapes.draws import between, chance, pick

Cell = tuple[float, float, float, float]
"""An opening in the front plane: smallest x, smallest y, largest x, largest y, metres."""


@dataclass(frozen=True)
class CabinetPlan:
    """Metres; the floor is at y = 0 and x = z = 0 in the middle of the carcass."""

    width: float
    """Of the carcass."""
    height: float
    """With the top, without a backsplash."""
    depth: float
    """Of the carcass."""
    panel: float
    """Thickness of its boards."""
    foot: float
    """Height of what it stands on."""
    top: float
    """Thickness of the top."""
    rail: float
    """Height of the boards that show between drawers; 0 where fronts follow each other."""
    columns: int
    """Drawers side by side; those of a row slide together."""
    rows: tuple[tuple[Cell, ...], ...]
    """Openings of the lowest, middle and top drawers."""
    fixed: tuple[Cell, ...]
    """Openings closed by a front that does not move."""
    open_shelf: Cell | None
    """An opening that stays open."""


def draw_cabinet(rng: np.random.Generator) -> CabinetPlan:
    """Narrow to wide, low to high."""
    width, height, depth = _size(rng)
    panel = min(between(rng, 0.006, 0.03), 0.06 * min(width, height))
    foot = height * (between(rng, 0.03, 0.2) if chance(rng, 0.6) else between(rng, 0.0, 0.02))
    top = panel * between(rng, 0.8, 2.0)
    columns = pick(rng, ((1, 1), (1, 2), (0.3, 3))) if width > 0.85 else 1
    rail = between(rng, 0.008, 0.03) * min(1.0, height) if chance(rng, 0.5) else 0.0
    low, high = foot + panel, height - top
    extra = pick(rng, ((7, "none"), (1, "below"), (1, "above"), (0.6, "shelf above"), (0.6, "shelf below")))
    share = between(rng, 0.14, 0.42) * (high - low) if extra != "none" else 0.0
    band = (low, low + share) if extra.endswith("below") else (high - share, high)
    if extra.endswith("below"):
        low += share + rail
    elif extra != "none":
        high -= share + rail
    edges = _columns(width, panel, columns)
    rows = tuple(
        tuple((left, bottom, right, upper) for left, right in edges) for bottom, upper in _heights(rng, low, high, rail)
    )
    cells = tuple((left, band[0], right, band[1]) for left, right in edges)
    return CabinetPlan(
        width=width,
        height=height,
        depth=depth,
        panel=panel,
        foot=foot,
        top=top,
        rail=rail,
        columns=columns,
        rows=rows,
        fixed=cells if extra in {"below", "above"} else (),
        open_shelf=(edges[0][0], band[0], edges[-1][1], band[1]) if extra.startswith("shelf") else None,
    )


def _size(rng: np.random.Generator) -> tuple[float, float, float]:
    kind = pick(rng, ((4.5, "narrow"), (3, "medium"), (2.5, "wide"), (1.2, "desk"), (0.8, "tall")))
    if kind == "narrow":
        return between(rng, 0.3, 0.52), between(rng, 0.45, 0.95), between(rng, 0.35, 0.68)
    if kind == "medium":
        return between(rng, 0.5, 0.9), between(rng, 0.4, 1.0), between(rng, 0.35, 0.68)
    if kind == "wide":
        return between(rng, 0.85, 1.45), between(rng, 0.5, 0.95), between(rng, 0.36, 0.58)
    if kind == "desk":
        return between(rng, 0.16, 0.4), between(rng, 0.16, 0.45), between(rng, 0.18, 0.4)
    return between(rng, 0.35, 0.6), between(rng, 0.9, 1.3), between(rng, 0.35, 0.55)


def _columns(width: float, panel: float, count: int) -> list[tuple[float, float]]:
    inner = width - 2 * panel
    step = (inner + panel) / count
    left = -inner / 2
    return [(left + k * step, left + (k + 1) * step - panel) for k in range(count)]


def _heights(rng: np.random.Generator, low: float, high: float, rail: float) -> list[tuple[float, float]]:
    """Equal drawers, lower ones taller, or any."""
    kind = pick(rng, ((4, "equal"), (4, "graded"), (1.5, "any")))
    if kind == "equal":
        share = np.ones(3)
    elif kind == "graded":
        step = between(rng, 1.05, 1.6)
        share = np.array([step * between(rng, 1.0, 1.5), step if chance(rng, 0.5) else 1.0, 1.0])
    else:
        share = rng.uniform(0.5, 1.2, 3)
    free = high - low - 2 * rail
    tall = free * share / share.sum()
    bottom = low + np.concatenate([[0], np.cumsum(tall[:2] + rail)])
    return [(float(b), float(b + t)) for b, t in zip(bottom, tall, strict=True)]

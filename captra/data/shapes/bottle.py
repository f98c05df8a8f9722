"""Bottles: a body turned about y (squared or oval now and then), and what closes it."""

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.bottle_caps import CAPS, Opening
from captra.data.shapes.bottle_outlines import FAMILIES, Outline
from captra.data.shapes.curves import polygon_factor, rounded_polyline, superellipse_factor
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import SEGMENTS, revolve


def make_bottle(rng: np.random.Generator) -> Shape:
    """Draw a bottle: vial to wine bottle, tight box centred on the symmetry axis."""
    outline = pick(rng, FAMILIES)(rng)
    if chance(rng, 0.15):
        outline = _engraved(rng, outline)
    profile, height = _profile(rng, outline)
    body = revolve(profile, _section(rng, outline, profile[:, 1]))
    mouth, widest = float(outline.radius[-1]), float(outline.radius.max())
    cap = CAPS[outline.cap](rng, Opening(mouth, widest, height)).moved(translation=np.array([0, height, 0]))
    return rigid_shape("bottle", [body, cap])


def _profile(rng: np.random.Generator, outline: Outline) -> tuple[Float64[np.ndarray, "K 2"], float]:
    height = float(outline.y[-1])
    fillet = outline.bottom_fillet
    edge = np.array([[0, 0], [outline.radius[0], 0], [np.interp(fillet, outline.y, outline.radius), fillet]])
    low = rounded_polyline(edge, fillet, 6)
    above = outline.y > fillet
    parts = [low, np.column_stack([outline.radius, outline.y])[above]]
    if outline.cap == "open":
        inner = outline.radius[-1] - between(rng, 0.0015, 0.003)
        depth = between(rng, 0.02, max(0.021, height - outline.body_top))
        parts.append(np.array([[inner, height], [inner, height - depth], [0, height - depth]]))
    else:
        parts.append(np.array([[0.0, height]]))
    return np.concatenate(parts), height


def _engraved(rng: np.random.Generator, outline: Outline) -> Outline:
    """A raised or sunken band, as of a label or a grip."""
    low = between(rng, 0.05, 0.5) * outline.body_top
    high = low + between(rng, 0.1, 0.45) * outline.body_top
    depth = between(rng, -0.06, 0.04) * float(outline.radius.max())
    inside = (outline.y > low) & (outline.y < high)
    return Outline(outline.radius + depth * inside, outline.y, outline.bottom_fillet, outline.body_top, outline.cap)


def _section(
    rng: np.random.Generator, outline: Outline, y: Float64[np.ndarray, " K"]
) -> Float64[np.ndarray, "K S"] | None:
    """Departures from the circle that fade out towards the neck; point-symmetric, so the box stays centred."""
    if not chance(rng, 0.16):
        return None
    angle = np.arange(SEGMENTS) * (2 * np.pi / SEGMENTS) + between(rng, 0, np.pi)
    kind = pick(rng, ((2, "square"), (1.5, "oval"), (1.5, "facets"), (0.7, "flutes")))
    if kind == "square":
        factor = superellipse_factor(angle, between(rng, 2.3, 5.0)) * between(rng, 0.85, 1.0)
    elif kind == "oval":
        factor = 1 / np.hypot(np.cos(angle), np.sin(angle) / between(rng, 0.7, 0.92))
    elif kind == "facets":
        factor = polygon_factor(angle, 2 * int(rng.integers(2, 6)), between(rng, 0.0, 0.5))
    else:
        factor = 1 + between(rng, 0.01, 0.03) * np.cos(2 * int(rng.integers(3, 7)) * angle)
    faded = np.clip((outline.y[-1] - y) / max(outline.y[-1] - outline.body_top, 1e-4), 0, 1)[:, None]
    return np.asarray(1 + (factor - 1) * faded)

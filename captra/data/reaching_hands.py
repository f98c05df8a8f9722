"""Hands that reach for an object with straight fingers, palm and arm away from it. Object frame."""

import numpy as np
from jaxtyping import Float, Float64

from captra.data.hands import GripFrame, forearm
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import capsule, superellipsoid

CLEAREST_SIGHT = 0.7
"""Share of the object's height and width around its middle that fingers aim at."""


def reaching_hand(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Fingers side by side whose tips touch the object, more or less straight, from a palm that stays away."""
    frame = _reach(rng)
    size = between(rng, 0.75, 1.25)
    count = pick(rng, ((5, 4), (1.5, 3), (1.5, 2), (1, 5)))
    spacing = between(rng, 0.015, 0.026) * size
    length = between(rng, 0.05, 0.13) * size
    middle = _aim(rng, vertices @ frame.axis)
    aside = _aim(rng, vertices @ frame.across)
    fan = between(rng, -0.12, 0.2)
    knuckles, meshes = list[Float64[np.ndarray, " 3"]](), list[Mesh]()
    for k in range(count):
        offset = k - (count - 1) / 2
        radius = between(rng, 0.006, 0.0105) * size
        tip = _touched(vertices, frame, aside, middle + offset * spacing, radius) + between(rng, -0.004, 0.003)
        direction = frame.out - fan * offset * frame.axis + between(rng, -0.1, 0.1) * frame.across
        direction /= np.linalg.norm(direction)
        start = frame.raised(np.array([[aside, tip]]), float(middle + offset * spacing))[0] + radius * direction
        meshes.append(capsule(length, 0.85 * radius, radius).moved(_along(direction, frame.axis), start))
        knuckles.append(start + length * direction)
    centre = np.mean(knuckles, axis=0)
    thick = between(rng, 0.02, 0.034) * size
    palm = (thick, max(0.03, count * spacing * 1.05), between(rng, 0.04, 0.09) * size)
    meshes.append(
        superellipsoid(palm, between(rng, 2.0, 4), 16).moved(frame.matrix, centre + frame.out * palm[2] / 2.5)
    )
    if chance(rng, 0.6):
        meshes.append(forearm(rng, centre + frame.out * palm[2], frame, size))
    return merged(meshes)


def _reach(rng: np.random.Generator) -> GripFrame:
    """A hand from anywhere, its fingers side by side about any direction."""
    out = rng.standard_normal(3)
    out /= np.linalg.norm(out)
    axis = np.cross(out, rng.standard_normal(3))
    axis /= np.linalg.norm(axis)
    return GripFrame(axis, np.cross(axis, out), out)


def _aim(rng: np.random.Generator, along: Float[np.ndarray, " V"]) -> float:
    low, high = float(along.min()), float(along.max())
    return (low + high) / 2 + between(rng, -0.5, 0.5) * CLEAREST_SIGHT * (high - low)


def _touched(vertices: Float[np.ndarray, "V 3"], frame: GripFrame, aside: float, height: float, radius: float) -> float:
    """How far out the object reaches where a finger comes in; the nearest vertices tell where there are few."""
    away = np.hypot(vertices @ frame.across - aside, vertices @ frame.axis - height)
    near = away <= max(2 * radius, float(np.partition(away, 5)[5]))
    return float((vertices[near] @ frame.out).max())


def _along(direction: Float[np.ndarray, " 3"], side: Float[np.ndarray, " 3"]) -> Float64[np.ndarray, "3 3"]:
    """Rotation that carries y to `direction` and x near to `side`."""
    z = np.cross(side, direction)
    z /= np.linalg.norm(z)
    return np.stack([np.cross(direction, z), direction, z], -1)

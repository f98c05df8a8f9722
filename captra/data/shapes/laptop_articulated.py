"""Laptops that open: closed at rest, hinge along x at -z, front towards +z."""

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.laptop_parts import LaptopPlan, draw_plan, make_base, make_lid
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.shape import Shape, articulated_shape
from captra.data.shapes.surfaces import revolve
from captra.geometry import axis_angle

X, Y, Z = np.eye(3)
TO_FRONT = axis_angle(Y, -np.pi / 2)
"""Parts are made with their front towards +x."""
OPENING_DEG = (5.0, 150.0)
"""Angle between base and display, which is the joint's value."""


def make_laptop_articulated(rng: np.random.Generator) -> Shape:
    """Draw a laptop, closed at rest."""
    plan = draw_plan(rng)
    gap = pick(rng, ((4, between(rng, 0.0, 0.0015)), (1, between(rng, 0.0015, 0.006))))
    behind = pick(rng, ((4, between(rng, -0.004, 0.003)), (1, between(rng, -0.016, 0.008))))
    base = [mesh.moved(TO_FRONT) for mesh in make_base(rng, plan)]
    face_down = axis_angle(X, np.pi)
    display = [mesh.moved(face_down, np.array([behind, gap, 0.0])).moved(TO_FRONT) for mesh in make_lid(rng, plan)]
    pivot = np.array([0.0, _pivot_height(rng, plan, gap), between(rng, -0.004, 0.008) + min(behind, 0.0)])
    barrels = _barrels(rng, plan, pivot, gap)
    (base if chance(rng, 0.5) else display).extend(barrels)
    limits = np.radians(OPENING_DEG)
    return articulated_shape("laptop_articulated", (base, display), pivot[None], limits[None])


def _pivot_height(rng: np.random.Generator, plan: LaptopPlan, gap: float) -> float:
    """Between the two parts, at the middle of the display's edge, or sunk into the base."""
    return pick(
        rng,
        (
            (3, between(rng, 0.0, gap)),
            (3, gap + between(rng, 0.2, 0.8) * plan.lid_thickness),
            (2, -between(rng, 0.0, 0.5) * plan.base_thickness),
        ),
    )


def _barrels(rng: np.random.Generator, plan: LaptopPlan, pivot: Float64[np.ndarray, " 3"], gap: float) -> list[Mesh]:
    """Round hinges about the pivot, below the back of the display: one wide, two short, or hidden."""
    count = pick(rng, ((3, 0), (2, 1), (4, 2)))
    if count == 0:
        return []
    room = 0.9 * (gap + plan.lid_thickness - float(pivot[1]))
    radius = min(between(rng, 0.25, 0.5) * (0.5 * plan.base_thickness + plan.lid_thickness), max(room, 0.001))
    length = plan.width * (between(rng, 0.4, 0.9) if count == 1 else between(rng, 0.04, 0.14))
    barrel = revolve(np.array([[0, 0], [radius, 0], [radius, length], [0, length]]), segments=14)
    along = barrel.moved(axis_angle(Z, -np.pi / 2), np.array([-length / 2, 0, 0])).moved(translation=pivot)
    if count == 1:
        return [along]
    side = plan.width * between(rng, 0.2, 0.48) - length / 2
    return [along.moved(translation=np.array([sign * side, 0, 0])) for sign in (-1, 1)]

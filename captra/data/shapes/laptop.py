"""Laptops as rigid objects: opened at an angle that stays, keyboard to +x, the screen on the -x side, hinge along z."""

import numpy as np
from jaxtyping import Float64

from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.laptop_parts import LaptopPlan, draw_plan, make_base, make_lid
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import box, revolve
from captra.geometry import axis_angle

Z = np.array([0.0, 0, 1])


def make_laptop(rng: np.random.Generator) -> Shape:
    """Draw a laptop that stands open by 60° to 150°."""
    plan = draw_plan(rng)
    opening = np.radians(draw_opening_deg(rng))
    base = make_base(rng, plan)
    start = between(rng, -0.012, 0.006)
    forward = between(rng, -0.6, 0.3) * plan.lid_thickness
    flat = np.array([start, forward, 0])
    lid = [mesh.moved(translation=flat).moved(lid_rotation(float(opening))) for mesh in make_lid(rng, plan)]
    pivot = np.array([between(rng, 0.0, 0.008), between(rng, -0.25, 0.25) * plan.lid_thickness, 0])
    lid = [mesh.moved(translation=pivot) for mesh in lid]
    return rigid_shape("laptop", [*base, *lid, *_hinges(rng, plan, pivot), *_extras(rng, plan)])


def draw_opening_deg(rng: np.random.Generator) -> float:
    """Angle between keyboard and screen: mostly as people sit before it."""
    usual = float(np.clip(rng.normal(107, 13), 60, 150))
    return pick(rng, ((2, usual), (1, between(rng, 60, 150))))


def lid_rotation(opening: float) -> Float64[np.ndarray, "3 3"]:
    """Carries a lid that lies flat, its screen up and its far edge towards +x, to an opening angle in rad.

    Its far edge points along (cos, sin) of the angle and its screen faces the keyboard; z changes its sign.
    """
    far = np.array([np.cos(opening), np.sin(opening), 0])
    front = np.array([np.sin(opening), -np.cos(opening), 0])
    return np.stack([far, front, -Z], -1)


def _hinges(rng: np.random.Generator, plan: LaptopPlan, pivot: Float64[np.ndarray, " 3"]) -> list[Mesh]:
    """Barrels along the hinge: one wide one, two short ones, or hidden."""
    kind = pick(rng, ((3, "one"), (4, "two"), (2, "hidden")))
    if kind == "hidden":
        return []
    radius = between(rng, 0.5, 1.0) * min(plan.base_thickness, 0.014) * 0.6
    length = plan.width * (between(rng, 0.5, 0.9) if kind == "one" else between(rng, 0.05, 0.16))
    barrel = revolve(np.array([[0, 0], [radius, 0], [radius, length], [0, length]]), segments=14)
    along = barrel.moved(axis_angle(np.array([1.0, 0, 0]), np.pi / 2), np.array([0, 0, -length / 2]))
    along = along.moved(translation=pivot + [between(rng, -0.004, 0.004), -between(rng, 0.0, 0.5) * radius, 0])
    if kind == "one":
        return [along]
    side = plan.width * between(rng, 0.25, 0.5) - length / 2
    return [along.moved(translation=np.array([0, 0, sign * side])) for sign in (-1, 1)]


def _extras(rng: np.random.Generator, plan: LaptopPlan) -> list[Mesh]:
    """A battery that stands out at the rear, a plug or stick at a side."""
    meshes = []
    if chance(rng, 0.06):
        size = (between(rng, 0.01, 0.03), plan.base_thickness * between(rng, 0.6, 0.95), plan.width * 0.7)
        meshes.append(box(size).moved(translation=np.array([-size[0] / 2 + 0.002, -plan.base_thickness / 2, 0])))
    if chance(rng, 0.06):
        size = (between(rng, 0.008, 0.02), between(rng, 0.003, 0.008), between(rng, 0.008, 0.05))
        side = 1 if chance(rng, 0.5) else -1
        at = [plan.depth * between(rng, 0.1, 0.7), -plan.base_thickness / 2, side * (plan.width + size[2]) / 2]
        meshes.append(box(size).moved(translation=np.array(at)))
    return meshes

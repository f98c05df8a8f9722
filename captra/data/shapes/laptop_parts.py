"""What laptops are made of: a base with keyboard and touchpad, and a lid with a sunk screen.

Both lie flat with their upper side at y = 0: the base reaches from the hinge at x = 0 to x = depth, the lid from its
lower edge at x = 0 to x = depth with its screen up.
"""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float32

from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate, plate_with_well
from captra.data.shapes.surfaces import box, revolve


@dataclass(frozen=True)
class LaptopPlan:
    """Overall measures, metres."""

    width: float
    """Extent along the hinge."""
    depth: float
    """Of the base, from the hinge to the front."""
    lid: float
    """Extent of the lid across the hinge."""
    base_thickness: float
    """At the hinge."""
    front_thickness: float
    """Of the base at its front."""
    lid_thickness: float
    """Of the lid."""
    corner: float
    """Radius of the outer corners."""
    bevel: float
    """Of the outer edges."""


def draw_plan(rng: np.random.Generator) -> LaptopPlan:
    """From a ten-inch netbook to a seventeen-inch workstation, from thin to thick."""
    inches = pick(rng, ((5, between(rng, 13, 16)), (2, between(rng, 9.5, 13)), (1, between(rng, 15.5, 17.5))))
    aspect = pick(rng, ((5, 16 / 9), (4, 16 / 10), (1.3, 4 / 3), (1.3, 3 / 2)))
    screen = inches * 0.0254 * np.array([aspect, 1.0]) / np.hypot(aspect, 1)
    modern = chance(rng, 0.65)
    side, above = (between(rng, 0.003, 0.012), between(rng, 0.004, 0.02)) if modern else rng.uniform(0.01, 0.03, 2)
    width = float(screen[0] + 2 * side)
    lid = float(screen[1] + above + between(rng, 0.005, 0.04))
    thin, thick = between(rng, 0.006, 0.014), between(rng, 0.014, 0.036)
    base = thin if chance(rng, 0.6 if modern else 0.1) else thick
    return LaptopPlan(
        width=width,
        depth=lid * (between(rng, 0.95, 1.05) if chance(rng, 0.8) else between(rng, 0.9, 1.15)),
        lid=lid,
        base_thickness=base,
        front_thickness=base - min(between(rng, 0.3, 0.7) * base if chance(rng, 0.35) else 0.0, 0.009),
        lid_thickness=between(rng, 0.003, 0.008) if modern else between(rng, 0.006, 0.016),
        corner=between(rng, 0.001, 0.018),
        bevel=min(between(rng, 0.0003, 0.006), 0.4 * base),
    )


def make_base(rng: np.random.Generator, plan: LaptopPlan) -> list[Mesh]:
    """Body with a sunk keyboard and touchpad, keys, feet."""
    outline = Rectangle((0, -plan.width / 2), (plan.depth, plan.width / 2), plan.corner)
    rear = plan.depth * between(rng, 0.05, 0.2)
    front = plan.depth * between(rng, 0.52, 0.68)
    margin = between(rng, 0.008, 0.05) if plan.width > 0.27 else between(rng, 0.004, 0.02)
    well = Rectangle((rear, -plan.width / 2 + margin), (front, plan.width / 2 - margin), 0.003)
    sunk = min(between(rng, 0.0003, 0.004), 0.4 * plan.front_thickness)
    split = front + 0.004
    low = -plan.base_thickness
    rear_half = replace(outline, high=(split, outline.high[1]), square_end="high")
    front_half = replace(outline, low=(split - 5e-4, outline.low[1]), square_end="low")
    pad_sunk = min(between(rng, 0.0001, 0.0012), max(sunk, 0.0003))
    body = [
        plate_with_well(rear_half, low, 0.0, well, sunk, plan.bevel),
        plate_with_well(front_half, low, 0.0, _touchpad(rng, plan, split), pad_sunk, plan.bevel),
    ]
    slope = plan.front_thickness / plan.base_thickness
    body = [_wedge(mesh, slope, plan.depth) for mesh in body]
    return [*body, *_keys(rng, well, sunk), *_feet(rng, plan)]


def _touchpad(rng: np.random.Generator, plan: LaptopPlan, split: float) -> Rectangle:
    room = plan.depth - split
    size = room * between(rng, 0.5, 0.85), min(plan.width * between(rng, 0.18, 0.5), 0.16)
    middle_x, middle_z = split + room * 0.5, plan.width * (between(rng, -0.1, 0.1) if chance(rng, 0.4) else 0.0)
    return Rectangle.centred(*size, 0.004).moved(middle_x, middle_z)


def _wedge(mesh: Mesh, slope: float, depth: float) -> Mesh:
    """Thin the base towards its front; its upper side stays level."""
    vertices: Float32[np.ndarray, "V 3"] = mesh.vertices.copy()
    at = vertices[:, 0] / depth
    vertices[:, 1] *= 1 + (slope - 1) * at
    return Mesh(vertices, mesh.faces)


def _keys(rng: np.random.Generator, well: Rectangle, sunk: float) -> list[Mesh]:
    """Rows of keys, whole rows, or none; a space bar in the last row."""
    style = pick(rng, ((6, "keys"), (2, "rows"), (1, "none")))
    if style == "none":
        return []
    rows, columns = int(rng.integers(5, 7)), int(rng.integers(11, 16)) if style == "keys" else 1
    tall, gap = sunk + between(rng, -0.5, 1.0) * min(sunk, 0.0015), between(rng, 0.001, 0.0045)
    step_x = (well.high[0] - well.low[0]) / rows
    step_z = (well.high[1] - well.low[1]) / columns
    meshes = []
    for row in range(rows):
        for column in range(columns):
            space = style == "keys" and row == rows - 1 and 3 <= column < 8
            if space and column > 3:
                continue
            wide = 5 if space else 1
            at = np.array(
                [
                    well.low[0] + (row + 0.5) * step_x,
                    -sunk + tall / 2,
                    well.high[1] - (column + wide / 2) * step_z,
                ]
            )
            meshes.append(box((step_x - gap, tall, wide * step_z - gap)).moved(translation=at))
    return meshes


def _feet(rng: np.random.Generator, plan: LaptopPlan) -> list[Mesh]:
    """Round feet at the corners or two rails; level with each other below a wedge."""
    if chance(rng, 0.25):
        return []
    tall, inset = between(rng, 0.0008, 0.004), between(rng, 0.015, 0.04)
    low = -plan.base_thickness - tall
    radius = between(rng, 0.004, 0.01)
    rails = chance(rng, 0.4)
    meshes = []
    for x in (inset, plan.depth - inset):
        top = -plan.base_thickness + (plan.base_thickness - plan.front_thickness) * x / plan.depth + 0.001
        if rails:
            rail = Rectangle.centred(0.01, plan.width * between(rng, 0.5, 0.85), 0.004)
            meshes.append(plate(rail, low, top).moved(translation=np.array([x, 0, 0])))
            continue
        foot = revolve(np.array([[0, low], [radius, low], [radius * 1.1, top], [0, top]]), segments=12)
        side = plan.width / 2 - inset
        meshes += [foot.moved(translation=np.array([x, 0, z])) for z in (-side, side)]
    return meshes


def make_lid(rng: np.random.Generator, plan: LaptopPlan) -> list[Mesh]:
    """A plate with a sunk screen, bulged or embossed at its back now and then."""
    thick = plan.lid_thickness
    narrower = between(rng, 0.0, 0.004) if chance(rng, 0.3) else 0.0
    outline = Rectangle((0, -plan.width / 2 + narrower), (plan.lid, plan.width / 2 - narrower), plan.corner)
    side, above, below = between(rng, 0.003, 0.025), between(rng, 0.004, 0.03), between(rng, 0.005, 0.04)
    screen = outline.inset(below, above, side)
    sunk = min(pick(rng, ((2, 0.0001), (2, between(rng, 0.0003, 0.001)), (1, between(rng, 0.001, 0.003)))), 0.5 * thick)
    meshes = [plate_with_well(outline, -thick, 0.0, screen, sunk, min(plan.bevel, 0.4 * thick))]
    if chance(rng, 0.25):
        bulge = outline.inset(*(between(rng, 0.01, 0.06) for _ in range(3)))
        deep = between(rng, 0.0005, 0.006)
        meshes.append(plate(bulge, -thick - deep, -0.5 * thick, 0.9 * deep))
    if chance(rng, 0.25):
        logo = Rectangle.centred(between(rng, 0.01, 0.05), between(rng, 0.01, 0.08), 0.01)
        at = np.array([plan.lid * between(rng, 0.35, 0.65), 0, 0])
        meshes.append(plate(logo, -thick - between(rng, 0.0002, 0.001), -0.5 * thick).moved(translation=at))
    return meshes

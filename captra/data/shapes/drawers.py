"""Cabinets with three drawers above each other, closed at rest, y up, sliding towards +z."""

import numpy as np

from captra.data.shapes.cabinet_plan import draw_cabinet
from captra.data.shapes.cabinets import make_carcass
from captra.data.shapes.drawer_boxes import DrawerBuilder
from captra.data.shapes.shape import Shape, articulated_shape

OPEN_SHARE = 0.8
"""A drawer slides out by at most that share of the depth of its box."""
LARGEST_SCALE = 1.7
"""Diagonal of the largest carcass, metres: what a depth camera sees whole from two metres."""


def make_drawers(rng: np.random.Generator) -> Shape:
    """Draw a cabinet: desk organizer to dresser, inset or overlapping fronts, knobs, handles, cups, feet."""
    plan = draw_cabinet(rng)
    builder = DrawerBuilder.draw(rng, plan)
    drawers = [[mesh for cell in row for mesh in builder.drawer(cell)] for row in plan.rows]
    base = make_carcass(rng, plan)
    for cell in plan.fixed:
        base += builder.fixed_front(cell)
    size = np.array([plan.width, plan.height, plan.depth])
    shrink = min(1.0, LARGEST_SCALE / float(np.linalg.norm(size)))
    parts = [[mesh.stretched(shrink) for mesh in part] for part in (*drawers, base)]
    reach = OPEN_SHARE * builder.box_depth * shrink
    return articulated_shape("drawers", parts, np.zeros((3, 3)), np.tile([0.0, reach], (3, 1)))

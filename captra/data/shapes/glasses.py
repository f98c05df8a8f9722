"""Glasses: a front that faces +z and two temples that reach to -z, unfolded at rest; the wearer's right is -x.

Hinges turn about y, so folding inwards is negative for the right temple and positive for the left one.
"""

import numpy as np

from captra.data.shapes.draws import between
from captra.data.shapes.glasses_front import draw_front, make_front
from captra.data.shapes.glasses_temples import make_temple
from captra.data.shapes.loops import mirrored
from captra.data.shapes.shape import Shape, articulated_shape

FOLDED = np.radians(88.0)
"""Largest angle of a temple."""


def make_glasses(rng: np.random.Generator) -> Shape:
    """Draw glasses: round, oval, square, aviator, cat-eye, shield; full, half or no rim; wire to broad temples."""
    plan = draw_front(rng)
    front, hinge = make_front(rng, plan)
    temple = [mesh.moved(translation=hinge) for mesh in make_temple(rng, plan)]
    opposite = [mirrored(mesh, axis=0) for mesh in temple]
    size = between(rng, 0.86, 1.12)
    parts = [[mesh.stretched(size) for mesh in part] for part in (opposite, temple, front)]
    origins = np.array([hinge * [-1, 1, 1], hinge]) * size
    return articulated_shape("glasses", parts, origins, np.array([[0.0, FOLDED], [0.0, FOLDED]]))

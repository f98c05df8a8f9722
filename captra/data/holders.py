"""Which hands and grippers hold objects of which category."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from captra.data.edge_grips import laptop_grip, rim_grip
from captra.data.hands import gripper, hand, handle_grip, palm_below
from captra.data.reaching_hands import reaching_hand
from captra.data.shapes.draws import pick
from captra.data.shapes.mesh import Mesh

Holder = Callable[[np.random.Generator, Float[np.ndarray, "V 3"]], Mesh]

USUAL: tuple[tuple[float, Holder], ...] = ((4.0, hand), (3.0, reaching_hand), (2.0, gripper), (0.8, palm_below))

HOLDERS: Mapping[str, tuple[tuple[float, Holder], ...]] = MappingProxyType(
    {
        "mug": (*USUAL, (2.0, handle_grip)),
        "bowl": ((3.0, hand), (3.0, reaching_hand), (1.5, gripper), (2.0, palm_below), (3.0, rim_grip)),
        "laptop": ((2.5, hand), (0.8, gripper), (1.2, palm_below), (4.0, laptop_grip)),
    }
)
"""Others are held in the usual ways."""


def make_holder(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"], category: str) -> Mesh:
    """Something that holds an object of a category with these vertices, object frame."""
    return pick(rng, HOLDERS.get(category, USUAL))(rng, vertices)

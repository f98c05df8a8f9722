"""Which function makes instances of which category."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from captra.categories import UnknownCategoryError
from captra.data.shapes.bottle import make_bottle
from captra.data.shapes.bowl import make_bowl
from captra.data.shapes.camera import make_camera
from captra.data.shapes.can import make_can
from captra.data.shapes.drawers import make_drawers
from captra.data.shapes.glasses import make_glasses
from captra.data.shapes.laptop import make_laptop
from captra.data.shapes.laptop_articulated import make_laptop_articulated
from captra.data.shapes.mug import make_mug
from captra.data.shapes.scissors import make_scissors
from captra.data.shapes.shape import Shape

ShapeMaker = Callable[[np.random.Generator], Shape]

MAKERS: Mapping[str, ShapeMaker] = MappingProxyType(
    {
        "bottle": make_bottle,
        "bowl": make_bowl,
        "camera": make_camera,
        "can": make_can,
        "laptop": make_laptop,
        "mug": make_mug,
        "laptop_articulated": make_laptop_articulated,
        "scissors": make_scissors,
        "glasses": make_glasses,
        "drawers": make_drawers,
    }
)


def make_shape(category: str, rng: np.random.Generator) -> Shape:
    """Draw a new instance of a category.

    Raises:
        UnknownCategoryError: with the categories that have a generator.
    """
    maker = MAKERS.get(category)
    if maker is None:
        raise UnknownCategoryError(f"no shape generator for {category!r}: choose one of {', '.join(MAKERS)}")
    return maker(rng)

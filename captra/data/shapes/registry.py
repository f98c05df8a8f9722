"""Which function makes instances of which category."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from captra.categories import UnknownCategoryError
from captra.data.shapes.bottle import make_bottle
from captra.data.shapes.mug import make_mug
from captra.data.shapes.shape import Shape

ShapeMaker = Callable[[np.random.Generator], Shape]

MAKERS: Mapping[str, ShapeMaker] = MappingProxyType({"bottle": make_bottle, "mug": make_mug})


def make_shape(category: str, rng: np.random.Generator) -> Shape:
    """Draw a new instance of a category.

    Raises:
        UnknownCategoryError: with the categories that have a generator.
    """
    maker = MAKERS.get(category)
    if maker is None:
        raise UnknownCategoryError(f"no shape generator for {category!r}: choose one of {', '.join(MAKERS)}")
    return maker(rng)

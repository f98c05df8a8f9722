"""Objects that look the same in a mirror: CoordinateNet may be asked about the mirrored cloud as well.

Networks learn left and right from different samples and err differently on them; the mean of both answers errs less.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Protocol

import numpy as np
from jaxtyping import Float32

from captra.categories import Category

Answer = tuple[Float32[np.ndarray, "classes points"], Float32[np.ndarray, "parts points 3"]]
"""Class probabilities, and coordinates under every part's frame."""

Ask = Callable[[Float32[np.ndarray, "points 3"]], Answer]
"""CoordinateNet's answer to a canonical cloud; points keep their neighbours in a mirror."""

ACROSS = np.array([-1.0, 1.0, 1.0], np.float32)
"""What a mirror in the plane x = 0 does to coordinates, in the root's frame as in that of every part."""


class Mirror(Protocol):
    """Chooses what CoordinateNet is asked."""

    def __call__(self, ask: Ask, points_canonical: Float32[np.ndarray, "points 3"], category: Category) -> Answer:
        """The answer to go on with."""


class Unmirrored:
    """As the paper has it."""

    def __call__(
        self,
        ask: Ask,
        points_canonical: Float32[np.ndarray, "points 3"],
        category: Category,  # noqa: ARG002 - asked for by the protocol
    ) -> Answer:
        """CoordinateNet's answer to the cloud as it is."""
        return ask(points_canonical)


class LeftAndRight:
    """For objects whose right half is the image of their left one in the plane x = 0."""

    def __call__(self, ask: Ask, points_canonical: Float32[np.ndarray, "points 3"], category: Category) -> Answer:
        """The mean of the answers to the cloud and to its image."""
        segmentation, coordinates = ask(points_canonical)
        segmentation_mirrored, coordinates_mirrored = ask(points_canonical * ACROSS)
        images = list(images_of(category))
        classes = images + list(range(len(images), category.num_classes))
        return (
            (segmentation + segmentation_mirrored[classes]) / 2,
            (coordinates + coordinates_mirrored[images] * ACROSS) / 2,
        )


def images_of(category: Category) -> tuple[int, ...]:
    """Which part each part is the image of: what is called right of what is called left, others of themselves."""
    other_side = {"right": "left", "left": "right"}
    names = ("_".join(other_side.get(word, word) for word in part.split("_")) for part in category.parts)
    return tuple(category.parts.index(name) for name in names)


UNMIRRORED: Mirror = Unmirrored()

MIRRORS: Mapping[str, Mirror] = MappingProxyType({"none": UNMIRRORED, "left-and-right": LeftAndRight()})
"""By the names that manifests use."""

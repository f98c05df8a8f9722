"""Boxes of a middling object of every category at rest, for people who place one by hand.

Example: python -m captra.data.typical_boxes > web/src/typical_boxes.json
"""

import json
import sys

import numpy as np

from captra.data.shapes.registry import MAKERS, make_shape

INSTANCES = 41


def typical_boxes(category: str, seed: int = 0) -> list[dict[str, list[float]]]:
    """Median centre and extent of each part's box over procedural instances, object frame, metres."""
    shapes = [make_shape(category, np.random.default_rng([seed, index])) for index in range(INSTANCES)]
    centers = np.median([shape.centers for shape in shapes], axis=0)
    sizes = np.median([shape.sizes for shape in shapes], axis=0)
    return [
        {"translation": np.round(center, 4).tolist(), "size": np.round(size, 4).tolist()}
        for center, size in zip(centers.astype(float), sizes.astype(float), strict=True)
    ]


if __name__ == "__main__":
    json.dump({category: typical_boxes(category) for category in MAKERS}, sys.stdout, indent=1)
    sys.stdout.write("\n")

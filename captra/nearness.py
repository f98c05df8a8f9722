"""Points belong to parts that are near them: fronts of drawers look alike, but each stays in its own opening."""

from dataclasses import replace

import numpy as np
from jaxtyping import Float, Float32, Float64

from captra.categories import Category
from captra.geometry import Pose
from captra.solving import Prediction

EDGE = 0.012
"""How far beyond a box the odds are e to one against its part, in units of the root's scale: poses are a little off."""

MOST_DOUBT = 4.0
"""Logarithm of the odds against a part, at most: a pose that is wrong must not keep the networks from saying so."""


def told_apart(
    prediction: Prediction, points: Float32[np.ndarray, "points 3"], around: Pose, category: Category
) -> Prediction:
    """What the networks said, with what they call one part or another weighed by how far it is from either's box.

    Whether a point belongs to any of them is left to the networks: to any drawer, of a cabinet, or to any part of
    something that folds. `around` is the pose that was looked around.
    """
    rivals = _rivals(category)
    if not rivals:
        return prediction
    beyond = np.stack([_beyond(points, around, part, category) for part in rivals])
    further = (beyond - beyond.min(axis=0)) / (EDGE * around.scale[category.root])
    weights = np.exp(-np.minimum(further, MOST_DOUBT))
    segmentation = prediction.segmentation.copy()
    of_any = segmentation[rivals].sum(axis=0)
    weighed = segmentation[rivals] * weights
    segmentation[rivals] = of_any * weighed / np.maximum(weighed.sum(axis=0), np.finfo(np.float32).tiny)
    return replace(prediction, segmentation=segmentation, labels=segmentation.argmax(axis=0))


def _rivals(category: Category) -> list[int]:
    """Parts that are taken for each other: those on slides, or else all of them."""
    on_slides = [joint.child for joint in category.joints if joint.kind == "prismatic"]
    return on_slides or (list(range(category.num_parts)) if category.joints else [])


def _beyond(
    points: Float[np.ndarray, "points 3"], pose: Pose, part: int, category: Category
) -> Float64[np.ndarray, " points"]:
    """How far outside a part's box each point is, metres; a part on a slide may be anywhere along it."""
    rotation, half = pose.rotation[part], pose.size[part] / 2
    for joint in category.joints:
        if joint.child == part and joint.kind == "prismatic":
            rotation, half = pose.rotation[joint.parent], np.where(np.abs(joint.axis) > 0.5, np.inf, half)
    outside = np.abs((points - pose.translation[part]) @ rotation) - half
    return np.asarray(np.maximum(outside.max(axis=1), 0.0))

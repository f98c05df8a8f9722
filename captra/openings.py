"""Fronts of drawers look alike, but each stays in its own opening: points belong to the drawer whose they are in."""

from dataclasses import replace

import numpy as np
from jaxtyping import Float, Float32, Float64

from captra.categories import Category, Joint
from captra.geometry import Pose
from captra.solving import Prediction

EDGE = 0.012
"""How far beyond an opening the odds are e to one against its part, in units of the root's scale: poses are a little
off."""

MOST_DOUBT = 4.0
"""Logarithm of the odds against a part, at most: a pose that is wrong must not keep the networks from saying so."""


def told_apart(
    prediction: Prediction, points: Float32[np.ndarray, "points 3"], around: Pose, category: Category
) -> Prediction:
    """What the networks said, with what they call one part on a slide or another weighed by how far either opening is.

    Whether a point belongs to any of them is left to the networks; `around` is the pose that was looked around.
    """
    if not category.slides:
        return prediction
    parts = [slide.child for slide in category.slides]
    beyond = np.stack([_beyond(points, around, slide) for slide in category.slides])
    further = (beyond - beyond.min(axis=0)) / (EDGE * around.scale[category.root])
    weights = np.exp(-np.minimum(further, MOST_DOUBT))
    segmentation = prediction.segmentation.copy()
    of_any = segmentation[parts].sum(axis=0)
    weighed = segmentation[parts] * weights
    segmentation[parts] = of_any * weighed / np.maximum(weighed.sum(axis=0), np.finfo(np.float32).tiny)
    return replace(prediction, segmentation=segmentation, labels=segmentation.argmax(axis=0))


def _beyond(points: Float[np.ndarray, "points 3"], pose: Pose, slide: Joint) -> Float64[np.ndarray, " points"]:
    """How far outside the opening of a part on a slide each point is, metres; it may be anywhere along the slide."""
    across = np.abs(slide.axis) < 0.5
    own = (points - pose.translation[slide.child]) @ pose.rotation[slide.parent]
    outside = (np.abs(own) - pose.size[slide.child] / 2)[:, across]
    return np.asarray(np.maximum(outside.max(axis=1), 0.0))

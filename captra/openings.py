"""Which drawer a point belongs to is told by the opening it is in: fronts look alike, and never leave their slides."""

from dataclasses import replace

import numpy as np
from jaxtyping import Float32, Float64

from captra.categories import Category
from captra.geometry import Pose
from captra.solving import Prediction

ACROSS, UP = 0, 1
"""Axes of the parent that slides are at right angles to."""

EDGE = 0.012
"""How far beyond an opening's edge the odds are against it, e to one, in units of the parent's scale: poses are a
little off."""


def in_openings(
    prediction: Prediction, points: Float32[np.ndarray, "points 3"], around: Pose, category: Category
) -> Prediction:
    """What the networks said, with what they call one part on a slide or another called by the opening it is in.

    Whether a point belongs to any of them is left to the networks; `around` is the pose that was looked around.
    """
    segmentation = prediction.segmentation
    for parent in {joint.parent for joint in category.joints if joint.kind == "prismatic"}:
        children = [joint.child for joint in category.joints if joint.parent == parent and joint.kind == "prismatic"]
        beyond = _distances(points, around, parent, children)
        segmentation = segmentation.copy()
        of_any = segmentation[children].sum(axis=0)
        weighed = segmentation[children] * np.exp((beyond.min(axis=0) - beyond) / (EDGE * around.scale[parent]))
        segmentation[children] = of_any * weighed / np.maximum(weighed.sum(axis=0), np.finfo(np.float32).tiny)
    return replace(prediction, segmentation=segmentation, labels=segmentation.argmax(axis=0))


def _distances(
    points: Float32[np.ndarray, "points 3"], pose: Pose, parent: int, children: list[int]
) -> Float64[np.ndarray, "children points"]:
    """How far each point lies beyond the openings' edges; below zero inside, in metres."""
    points_parent = (points - pose.translation[parent]) @ pose.rotation[parent]
    middle = (pose.translation[children] - pose.translation[parent]) @ pose.rotation[parent]
    beyond = np.abs(points_parent[None] - middle[:, None]) - pose.size[children][:, None] / 2
    return np.asarray(beyond[..., [ACROSS, UP]].max(axis=-1))

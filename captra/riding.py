"""Parts that are hardly seen go with what they hang on: a drawer that nothing is seen of moves with its cabinet.

A pose that a handful of points tell is mostly noise, and a pose that is kept while the object moves on is wrong; that
a joint stands as it last stood is the better guess.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.evidence import Evidence, Ride
from captra.geometry import Pose, project_to_rotation, rotation_from_vector, rotation_vector

FEW_POINTS = 30
"""Of a part: found from so many, its joint is half way between where it stood and where it was found."""


def rides(evidence: Evidence, category: Category) -> Iterator[Ride]:
    """Which parts go with which, a part after the one that it goes with.

    The fewer points tell where a jointed part is, the more it goes with its parent; a root of which nothing is seen
    goes with the part that is seen best.
    """
    points = evidence.explained_points
    if points[category.root] == 0 and points.any():
        yield Ride(category.root, int(points.argmax()), 0.0)
    for joint in category.joints:
        yield Ride(joint.child, joint.parent, float(points[joint.child] / (points[joint.child] + FEW_POINTS)))


def ride_along(pose: Pose, evidence: Evidence, last: Pose) -> Pose:
    """The pose with every part that rides the nearer to where another takes it, the less of it was found."""
    rotation, translation = np.array(pose.rotation), np.array(pose.translation)
    for ride in evidence.rides:
        part, by = ride.part, ride.by
        moved = rotation[by] @ last.rotation[by].T
        expected = moved @ last.rotation[part]
        expected_centre = translation[by] + moved @ (last.translation[part] - last.translation[by])
        turn: Float64[np.ndarray, "3"] = rotation_vector(expected.T @ rotation[part])
        # Projected, since products of rounded rotations, each made from the one before, drift off ever faster.
        rotation[part] = project_to_rotation(expected @ rotation_from_vector(ride.found * turn))
        translation[part] = expected_centre + ride.found * (translation[part] - expected_centre)
    return replace(pose, rotation=rotation, translation=translation)

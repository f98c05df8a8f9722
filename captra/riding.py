"""Parts that are hardly seen go with what they hang on: a drawer that nothing is seen of moves with its cabinet.

A pose that a handful of points tell is mostly noise, and a pose that is kept while the object moves on is wrong; that
a joint stands as it last stood is the better guess.
"""

from dataclasses import replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category
from captra.evidence import Evidence
from captra.geometry import Pose, project_to_rotation, rotation_from_vector, rotation_vector

FEW_POINTS = 30
"""Of a part: found from so many, its joint is half way between where it stood and where it was found."""


def ride_along(pose: Pose, evidence: Evidence, last: Pose, category: Category) -> Pose:
    """The pose with every jointed part the nearer to where its parent takes it, the fewer points tell where it is.

    A root of which nothing is seen goes with the part that is seen best.
    """
    points = evidence.explained_points
    share = points / (points + FEW_POINTS)
    rotation, translation = np.array(pose.rotation), np.array(pose.translation)

    def carry(part: int, by: int, share_found: float) -> None:
        moved = rotation[by] @ last.rotation[by].T
        expected = moved @ last.rotation[part]
        expected_centre = translation[by] + moved @ (last.translation[part] - last.translation[by])
        turn: Float64[np.ndarray, "3"] = rotation_vector(expected.T @ rotation[part])
        # Projected, since products of rounded rotations, each made from the one before, drift off ever faster.
        rotation[part] = project_to_rotation(expected @ rotation_from_vector(share_found * turn))
        translation[part] = expected_centre + share_found * (translation[part] - expected_centre)

    if points[category.root] == 0 and points.any():
        carry(category.root, int(points.argmax()), 0.0)
    for joint in category.joints:
        carry(joint.child, joint.parent, float(share[joint.child]))
    return replace(pose, rotation=rotation, translation=translation)

"""Points of a segmented object that cannot be its own: flying pixels, and what a mask let through far behind."""

import numpy as np

from captra.geometry import Pose
from captra.observations import Crop

REACH = 5.0
"""Times the median distance from the middle of a cloud: within it any point may be the object's, as in training."""

REACH_PER_SCALE = 1.0
"""Times the diagonal of a part's last box, from its centre: within it as well, however few points there are."""


def without_strays(crop: Crop, last: Pose) -> Crop:
    """The points that are not far from both the bulk of the cloud and the last pose.

    Either alone would do harm: points of an object that is hidden but for one end are far from that end, and all of an
    object that has moved are far from where it was.
    """
    if len(crop) == 0:
        return crop
    points = crop.points
    distances = np.linalg.norm(points - np.median(points, axis=0), axis=1)
    far = np.flatnonzero(distances > REACH * np.median(distances))
    if len(far) == 0:
        return crop
    from_parts = np.linalg.norm(points[far, None] - last.translation.astype(np.float32), axis=2)
    stray = (from_parts > REACH_PER_SCALE * last.scale.astype(np.float32)).all(axis=1)
    kept = np.ones(len(crop), bool)
    kept[far[stray]] = False
    return crop.kept(kept) if stray.any() else crop

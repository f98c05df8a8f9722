"""Stray points: what a segmentation mask lets through beside the object.

They keep the label P ("no part"), as background does elsewhere. A pre-segmented category has no class for
it: such points belong to no part's mask, and a segmentation loss has to leave them out.
"""

import numpy as np
from jaxtyping import Float32, UInt8
from scipy.spatial import cKDTree

from captra.data.shapes.draws import chance, pick

FRINGE = 0.012
"""Tangent of the angle from the object within which a mask's edge lets points through."""
NEAR_M = 0.03
"""Distance within which things that touch the object are taken for it."""
FARTHEST_M = 3.2
"""Shards store coordinates up to 3.27 m."""
MOST_COMPARED = 1500


def keep_segment(
    points: Float32[np.ndarray, "N 3"],
    labels: UInt8[np.ndarray, " N"],
    parts: int,
    largest_share: float,
    rng: np.random.Generator,
) -> tuple[Float32[np.ndarray, "M 3"], UInt8[np.ndarray, " M"]]:
    """Keep the object's points, and in half of the views a share of up to `largest_share` of strays (label `parts`)."""
    own = labels < parts
    share = largest_share * rng.random() if largest_share > 0 and chance(rng, 0.5) else 0.0
    wanted = int(share / (1 - share) * own.sum())
    others = np.flatnonzero(~own & (np.abs(points) < FARTHEST_M).all(axis=1))
    chosen = np.flatnonzero(own)
    if wanted > 0 and len(others) > 0:
        others = others[_eligible(points[others], points[chosen], rng)]
        chosen = np.concatenate([chosen, rng.permutation(others)[:wanted]])
    return points[chosen], labels[chosen]


def _eligible(
    others: Float32[np.ndarray, "K 3"], own: Float32[np.ndarray, "L 3"], rng: np.random.Generator
) -> np.ndarray:
    """Along the object's outline in the image, close to it in space, or anywhere."""
    kind = pick(rng, ((5, "fringe"), (2, "near"), (2, "anywhere")))
    sample = own[rng.permutation(len(own))[:MOST_COMPARED]]
    if kind == "fringe":
        distance = cKDTree(sample[:, :2] / sample[:, 2:]).query(others[:, :2] / others[:, 2:])[0]
        return np.asarray(distance < FRINGE)
    if kind == "near":
        return np.asarray(cKDTree(sample).query(others)[0] < NEAR_M)
    return np.ones(len(others), bool)

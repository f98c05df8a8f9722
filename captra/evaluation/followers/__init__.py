"""Ways to follow an object through a sequence: the tracker as served, disturbed, or one of the baselines."""

from captra.evaluation.followers.follower import Follower, Track
from captra.evaluation.followers.icp import OracleIcp
from captra.evaluation.followers.ransac import CoordinatesWithRansac
from captra.evaluation.followers.served import FIXED_SCALE, ROBUSTNESS, Served

BASELINES: tuple[Follower, ...] = (
    OracleIcp(),
    OracleIcp("oracle ICP, told its points", told_points=True),
    CoordinatesWithRansac(),
    FIXED_SCALE,
)
"""What the method is compared with on the same sequences."""

__all__ = [
    "BASELINES",
    "FIXED_SCALE",
    "ROBUSTNESS",
    "CoordinatesWithRansac",
    "Follower",
    "OracleIcp",
    "Served",
    "Track",
]

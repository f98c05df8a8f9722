"""From a cloud to the points and index lists that the networks read; every kernel is compiled and releases the GIL."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from jaxtyping import Float, Float32, Int32, Int64

from captra.compiled import compiled_without_nan
from captra.farthest import farthest_order
from captra.geometry import Pose
from captra.observations import Crop, Observation
from captra.side_by_side import IN_TURN, SideBySide

RADII = ((0.05, 0.1, 0.2), (0.2, 0.4))
"""Radii of the groups of both set-abstraction levels, in canonical units (box diagonal = 1)."""

CROP_RADIUS_PER_SCALE = 0.6
MINIMUM_CROP_RADIUS_M = 0.05
MINIMUM_CROP_POINTS = 10
CROP_GROWTH = 1.1
CROP_ATTEMPTS = 10

LANES = 16
"""Distances that the processor compares at a time."""


@dataclass(frozen=True)
class Profile:
    """A sampling budget; the weights are the same for all of them."""

    name: str
    """As clients write it."""
    points: int
    """N: points given to the networks."""
    centroids: tuple[int, int]
    """Centroids of the two set-abstraction levels."""
    groups: tuple[tuple[int, int, int], tuple[int, int]]
    """Largest number of points in each group, per level and radius."""


PAPER = Profile("paper", 4096, (512, 128), ((32, 64, 128), (64, 128)))
REALTIME = Profile("realtime", 1024, (256, 64), ((16, 32, 64), (32, 64)))
PROFILES: Mapping[str, Profile] = MappingProxyType({profile.name: profile for profile in (PAPER, REALTIME)})


@dataclass(frozen=True)
class InputSampling:
    """How densely a network was trained to see the object and what surrounds it."""

    surroundings_weight: float = 1.0
    """Distances outside the last box count this much in farthest point sampling; 1 is the paper's uniform sampling."""
    margin: float = 0.1
    """What is added to the box on each side, in canonical units."""


@dataclass(frozen=True)
class Neighborhoods:
    """Who is near whom in a canonical cloud in farthest-point order: centroids are prefixes, so they need no index."""

    groups1: tuple[Int32[np.ndarray, "M1 k"], ...]
    """Per radius, the points around each of the first M1 points."""
    groups2: tuple[Int32[np.ndarray, "M2 k"], ...]
    """Per radius, the first-level centroids around each of the first M2."""
    nearest1: Int32[np.ndarray, "N 3"]
    """For each point, its three nearest first-level centroids."""
    nearest2: Int32[np.ndarray, "M1 3"]
    """For each first-level centroid, its three nearest second-level ones."""


class NoPointsError(ValueError):
    """The cloud has no point near the object."""


def crop_ball(observation: Observation, pose: Pose, root: int) -> Crop:
    """The points around the last centre (0.6 × scale, at least 5 cm, grown while nearly empty).

    Raises:
        NoPointsError: when even the largest ball holds fewer than ten points.
    """
    radius = max(MINIMUM_CROP_RADIUS_M, CROP_RADIUS_PER_SCALE * float(pose.scale[root]))
    for _ in range(CROP_ATTEMPTS + 1):
        crop = observation.near(pose.translation[root], radius)
        if len(crop) >= MINIMUM_CROP_POINTS:
            return crop
        radius *= CROP_GROWTH
    raise NoPointsError(
        f"fewer than {MINIMUM_CROP_POINTS} points within {radius / CROP_GROWTH:.2f} m of the last pose: "
        "check the cloud's frame and units (metres), or give a new pose"
    )


def sampling_weights(
    points_canonical: Float32[np.ndarray, "points 3"], aspect: Float[np.ndarray, "3"], sampling: InputSampling
) -> Float32[np.ndarray, " points"]:
    """Weight of each point's distances: 1 within the last box and its margin, less outside."""
    x, y, z = (np.abs(points_canonical) <= np.asarray(aspect, np.float32) / 2 + np.float32(sampling.margin)).T
    return np.where(x & y & z, np.float32(1), np.float32(sampling.surroundings_weight))


def farthest_points(
    points: Float32[np.ndarray, "points 3"], count: int, weights: Float32[np.ndarray, " points"] | None = None
) -> Int64[np.ndarray, " count"]:
    """Indices of `count` points in farthest-point order, starting at index 0; a shorter cloud is repeated.

    `weights` scale each point's distance to what is chosen already: smaller weights thin a region out.
    """
    if weights is None:
        weights = np.ones(len(points), np.float32)
    order = farthest_order(points, weights, min(count, len(points)))
    return np.resize(order, count)


@compiled_without_nan
def _ball_queries(
    points: Float32[np.ndarray, "points 3"],
    centroids: int,
    radii: Float32[np.ndarray, " radii"],
    sizes: Int64[np.ndarray, " radii"],
) -> Int32[np.ndarray, "centroids total"]:
    groups = np.zeros((centroids, sizes.sum()), np.int32)
    starts = np.cumsum(sizes) - sizes
    squared_radii = radii * radii
    x, y, z = points[:, 0].copy(), points[:, 1].copy(), points[:, 2].copy()
    squared = np.empty(len(points), np.float32)
    near = np.empty(len(points) + 1, np.int32)
    within = np.empty(len(points) + 1, np.int32)
    for c in range(centroids):
        # Distances first, then the few within reach of the widest radius, then of each, so that the processor
        # vectorizes the one and guesses no branch in the others.
        for i in range(len(points)):
            dx, dy, dz = x[i] - x[c], y[i] - y[c], z[i] - z[c]
            squared[i] = dx * dx + dy * dy + dz * dz
        count = 0
        for i in range(len(points)):
            near[count] = i
            count += squared[i] < squared_radii[-1]
        for r in range(len(radii)):
            found = 0
            for n in range(count):
                within[found] = near[n]
                found += squared[near[n]] < squared_radii[r]
            for n in range(min(found, sizes[r])):
                groups[c, starts[r] + n] = within[n]
            if 0 < found < sizes[r]:
                groups[c, starts[r] + found : starts[r] + sizes[r]] = within[0]
    return groups


def ball_queries(
    points: Float32[np.ndarray, "points 3"], centroids: int, radii: tuple[float, ...], sizes: tuple[int, ...]
) -> tuple[Int32[np.ndarray, "centroids k"], ...]:
    """Groups around the first `centroids` points, one array a radius (radii ascending).

    A group holds the first points in index order whose squared distance is below the squared radius; what is missing is
    filled with the first one found, and a group without any takes point 0 (as the authors' networks were trained).
    """
    groups = _ball_queries(points, centroids, np.array(radii, np.float32), np.array(sizes, np.int64))
    return tuple(np.ascontiguousarray(group) for group in np.split(groups, np.cumsum(sizes)[:-1], axis=1))


@compiled_without_nan
def _third_smallest_of_lanes(values: Float32[np.ndarray, " multiple_of_lanes"]) -> np.float32:
    """Third smallest of the minima of every `LANES`-th value: no less than the third smallest value of all."""
    lanes = np.full(LANES, np.float32(np.inf))
    for row in range(len(values) // LANES):
        for lane in range(LANES):
            lanes[lane] = min(lanes[lane], values[row * LANES + lane])
    first = second = third = np.float32(np.inf)
    for lane in range(LANES):
        value = lanes[lane]
        third = min(third, max(second, value))
        second = min(second, max(first, value))
        first = min(first, value)
    return third


@compiled_without_nan
def three_nearest(points: Float32[np.ndarray, "points 3"], references: int) -> Int32[np.ndarray, "points 3"]:
    """The three nearest of the first `references` points for each point, nearest first; equals go by index."""
    nearest = np.zeros((len(points), 3), np.int32)
    infinity = np.float32(np.inf)
    rows = (references + LANES - 1) // LANES
    x, y, z = np.zeros((3, rows * LANES), np.float32)
    x[:references], y[:references], z[:references] = (
        points[:references, 0],
        points[:references, 1],
        points[:references, 2],
    )
    squared = np.empty(rows * LANES, np.float32)
    for i in range(len(points)):
        px, py, pz = points[i, 0], points[i, 1], points[i, 2]
        for r in range(rows * LANES):
            dx, dy, dz = x[r] - px, y[r] - py, z[r] - pz
            squared[r] = dx * dx + dy * dy + dz * dz
        squared[references:] = infinity
        reach = _third_smallest_of_lanes(squared)
        first = second = third = infinity
        a = b = c = 0
        for row in range(rows):
            lowest = infinity
            for r in range(row * LANES, row * LANES + LANES):
                lowest = min(lowest, squared[r])
            if lowest > reach:  # as nearly all rows
                continue
            for r in range(row * LANES, row * LANES + LANES):
                if squared[r] < third:
                    if squared[r] < second:
                        third, c = second, b
                        if squared[r] < first:
                            second, b = first, a
                            first, a = squared[r], r
                        else:
                            second, b = squared[r], r
                    else:
                        third, c = squared[r], r
        nearest[i, 0], nearest[i, 1], nearest[i, 2] = a, b, c
    return nearest


_Groups = tuple[tuple[Int32[np.ndarray, "M1 k"], ...], tuple[Int32[np.ndarray, "M2 k"], ...]]


def build_neighborhoods(points_canonical: Float32[np.ndarray, "N 3"], profile: Profile) -> Neighborhoods:
    """Index inputs for one canonical cloud in farthest-point order."""
    return Neighborhoods(*_groups(points_canonical, profile), *_nearest(points_canonical, profile))


def part_neighborhoods(
    points_canonical: Float32[np.ndarray, "parts N 3"], profile: Profile, side_by_side: SideBySide = IN_TURN
) -> list[Neighborhoods]:
    """Index inputs for the canonical clouds of all parts of one object.

    The clouds are similar to each other: which points are nearest is the same in all, what is within a radius is not.
    """
    parts = len(points_canonical)

    def groups_of(clouds: Float32[np.ndarray, "some N 3"]) -> list[_Groups]:
        return [_groups(cloud, profile) for cloud in clouds]

    (nearest, some), others = side_by_side(
        lambda: (_nearest(points_canonical[0], profile), groups_of(points_canonical[: parts // 2])),
        lambda: groups_of(points_canonical[parts // 2 :]),
    )
    return [Neighborhoods(*groups, *nearest) for groups in some + others]


def _nearest(
    points_canonical: Float32[np.ndarray, "N 3"], profile: Profile
) -> tuple[Int32[np.ndarray, "N 3"], Int32[np.ndarray, "M1 3"]]:
    first, second = profile.centroids
    return three_nearest(points_canonical, first), three_nearest(points_canonical[:first], second)


def _groups(points_canonical: Float32[np.ndarray, "N 3"], profile: Profile) -> _Groups:
    first, second = profile.centroids
    return (
        ball_queries(points_canonical, first, RADII[0], profile.groups[0]),
        ball_queries(points_canonical[:first], second, RADII[1], profile.groups[1]),
    )


def warm_up() -> None:
    """Compile or load every kernel, so that no frame waits for it."""
    points = np.random.default_rng(0).random((128, 3), np.float32)
    build_neighborhoods(points[farthest_points(points, 128)], Profile("warm-up", 128, (16, 4), ((2, 2, 2), (2, 2))))

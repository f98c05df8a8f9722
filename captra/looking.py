"""One look at a cloud around a pose: crop, sample, canonicalize, ask both networks, fit."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Protocol

import numpy as np
from jaxtyping import Float32, UInt8

from captra import sampling
from captra.canonical import canonicalize
from captra.categories import Category
from captra.evidence import Evidence
from captra.geometry import Pose
from captra.joint_projection import JointProjection
from captra.observations import Crop, Observation
from captra.openings import told_apart
from captra.pose_memory import FoundError
from captra.rotation_fusion import RotationFusion
from captra.sampling import InputSampling, Neighborhoods, Profile, part_neighborhoods
from captra.segmentation import NOTHING_KNOWN, Segmentation, overrule, without_background
from captra.side_by_side import SideBySide
from captra.solving import Prediction, per_point_rotations, reject_leaps, solve
from captra.strays import without_strays
from captra.visibility import visible
from captra.walls import along_walls


class Networks(Protocol):
    """CoordinateNet and RotationNet of one category, in whatever framework."""

    @property
    def category(self) -> Category:
        """What the networks were trained on."""

    @property
    def profile(self) -> Profile:
        """Shapes of the inputs."""

    @property
    def input_sampling(self) -> InputSampling:
        """How the points were drawn in training."""

    @property
    def rotation_fusion(self) -> RotationFusion:
        """Whose word counts for rotations."""

    @property
    def joint_projection(self) -> JointProjection:
        """How rotations are kept on the joints."""

    @property
    def found_error(self) -> FoundError:
        """By how much the networks err on one object all the time."""

    @property
    def side_by_side(self) -> SideBySide:
        """How two pieces of work share the cores that the networks may use."""

    def coordinates(
        self, points_canonical: Float32[np.ndarray, "points 3"], neighborhoods: Neighborhoods
    ) -> tuple[Float32[np.ndarray, "classes points"], Float32[np.ndarray, "parts points 3"]]:
        """Class probabilities, and coordinates in [-0.5, 0.5] in each part's frame, from the root's canonical cloud."""

    def rotations(
        self, points_canonical: Float32[np.ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[np.ndarray, "parts rotated_points width"]:
        """Raw residual rotations of the first points: width 6, or 3 for symmetric objects; part j from cloud j."""


@dataclass(frozen=True)
class StepTiming:
    """Where the time of one step went, milliseconds."""

    sample_ms: float
    """Crop, farthest points, canonicalization, neighbourhoods."""
    infer_ms: float
    """Both networks."""
    solve_ms: float
    """Fits."""

    @property
    def total_ms(self) -> float:
        """All of it."""
        return self.sample_ms + self.infer_ms + self.solve_ms

    @staticmethod
    def sum(timings: "Iterable[StepTiming]") -> "StepTiming":
        """Of several looks in one step."""
        columns = zip(*((one.sample_ms, one.infer_ms, one.solve_ms) for one in timings), strict=True)
        return StepTiming(*(sum(column) for column in columns))


@dataclass(frozen=True)
class Sighting:
    """What one look around a pose found."""

    around: Pose
    """Where it looked."""
    pose: Pose
    """Where it found every part, as measured."""
    evidence: Evidence
    """How far to trust it."""
    timing: StepTiming
    """Milliseconds a stage."""


def look(
    networks: Networks,
    observation: Observation,
    around: Pose,
    segmentation: Segmentation = NOTHING_KNOWN,
    projection: JointProjection | None = None,
) -> Sighting:
    """Find the object in what a sensor saw near the pose `around`; joints allow what the networks say by default.

    Raises:
        NoPointsError: nothing was seen near the pose.
    """
    started = perf_counter()
    category = networks.category
    crop = choose_points(observation, around, category, networks.profile.points, networks.input_sampling, segmentation)
    points_canonical = canonicalize(crop.points, around)
    neighborhoods = part_neighborhoods(points_canonical, networks.profile, networks.side_by_side)
    sampled = perf_counter()
    prediction = predict(networks, points_canonical, neighborhoods, segmentation.labels(crop.indices))
    prediction = told_apart(prediction, crop.points, around, category)
    inferred = perf_counter()
    allowed = along_walls(projection or networks.joint_projection, crop.points, neighborhoods[category.root], category)
    pose, evidence = solve(crop.points, prediction, around, category, networks.rotation_fusion, allowed)
    pose, evidence = reject_leaps(pose, evidence, around)
    distinct_points = 1 + int(np.count_nonzero(np.diff(np.sort(crop.indices))))
    evidence = replace(evidence, distinct_points=distinct_points, visible=visible(evidence, crop))
    timing = StepTiming(*(1e3 * d for d in (sampled - started, inferred - sampled, perf_counter() - inferred)))
    return Sighting(around, pose, evidence, timing)


def choose_points(
    observation: Observation,
    last: Pose,
    category: Category,
    count: int,
    density: InputSampling,
    segmentation: Segmentation = NOTHING_KNOWN,
) -> Crop:
    """Crop around the last pose where there are surroundings, then pick `count` points in farthest-point order.

    Raises:
        NoPointsError: nothing was seen near the object.
    """
    if not category.background:
        whole = without_strays(without_background(observation.whole(), segmentation), last)
        if len(whole) < sampling.MINIMUM_CROP_POINTS:
            raise sampling.NoPointsError(f"the cloud has only {len(whole)} points: send the segmented object")
        return whole.chosen(sampling.farthest_points(whole.points, count))
    crop = sampling.crop_ball(observation, last, category.root)
    root = last.part(category.root)
    aspect = (root.size / root.scale[:, None])[0]
    weights = sampling.sampling_weights(canonicalize(crop.points, root)[0], aspect, density)
    return crop.chosen(sampling.farthest_points(crop.points, count, weights))


def predict(
    networks: Networks,
    points_canonical: Float32[np.ndarray, "parts points 3"],
    neighborhoods: Sequence[Neighborhoods],
    labels: UInt8[np.ndarray, " points"] | None = None,
) -> Prediction:
    """Run both networks on the canonical clouds; `labels` (see `captra.segmentation`) overrule CoordinateNet's."""
    root = networks.category.root
    (segmentation, coordinates), raw_rotations = networks.side_by_side(
        lambda: networks.coordinates(points_canonical[root], neighborhoods[root]),
        lambda: networks.rotations(points_canonical, neighborhoods),
    )
    if labels is not None:
        segmentation = overrule(segmentation, labels, networks.category)
    return Prediction(
        segmentation=segmentation,
        coordinates=coordinates,
        labels=segmentation.argmax(axis=0),
        delta_rotations=per_point_rotations(raw_rotations, networks.category),
    )

"""One step of the method: the last pose and a new cloud in, the new pose of every part out (paper, Fig. "pipeline")."""

from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Protocol

import numpy as np
from jaxtyping import Float, Float32, UInt8

from captra import sampling
from captra.canonical import canonicalize
from captra.categories import Category
from captra.geometry import Pose
from captra.health import Evidence, HealthMonitor, State
from captra.joints import JointValue, joint_values
from captra.observations import Crop, Observation, PointCloud
from captra.rotation_fusion import RotationFusion
from captra.sampling import InputSampling, Neighborhoods, Profile, part_neighborhoods
from captra.segmentation import NOTHING_KNOWN, Segmentation, overrule, without_background
from captra.side_by_side import side_by_side
from captra.size_memory import GIVEN_WEIGHT_FRAMES, SizeMemory
from captra.solving import Prediction, hold_gauge, per_point_rotations, reject_leaps, solve


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
    """Fits and health."""


@dataclass(frozen=True)
class TrackResult:
    """What one frame told."""

    pose: Pose
    """Pose of every part, in the frame of the cloud."""
    state: State
    """Whether the track holds."""
    confidence: float
    """Probability in [0, 1] that this pose is within 5° and 5 cm."""
    joints: tuple[JointValue, ...]
    """Joint states in the order of the category's joints."""
    evidence: Evidence
    """What the confidence was computed from."""
    timing: StepTiming
    """Milliseconds per stage."""


class Tracker:
    """Follows one object; not thread-safe: one tracker belongs to one stream."""

    def __init__(
        self,
        networks: Networks,
        pose: Pose,
        health: HealthMonitor | None = None,
        given_weight_frames: float = GIVEN_WEIGHT_FRAMES,
    ) -> None:
        self._networks = networks
        self._given_weight_frames = given_weight_frames
        self._category = networks.category
        self._health = health or HealthMonitor()
        self.reset(pose)

    @property
    def pose(self) -> Pose:
        """The last pose."""
        return self._pose

    def reset(self, pose: Pose) -> None:
        """Start again from `pose`.

        Raises:
            ValueError: when the pose has another number of parts than the category.
        """
        if pose.num_parts != self._category.num_parts:
            raise ValueError(
                f"{self._category.name} has {self._category.num_parts} parts ({', '.join(self._category.parts)}), "
                f"but the pose has {pose.num_parts}"
            )
        self._pose = pose
        self._size = SizeMemory.of(pose, self._given_weight_frames)
        self._health = self._health.restarted()

    def displace(self, pose: Pose) -> None:
        """Take `pose` for where the object was last, without forgetting its size or the track's health."""
        self._pose = pose

    def step(
        self, observed: Observation | Float[np.ndarray, "all 3"], segmentation: Segmentation = NOTHING_KNOWN
    ) -> TrackResult:
        """Find the object in what a sensor saw, given where it was.

        Args:
            observed: a cloud as an array, metres, or any other observation.
            segmentation: what is known beforehand of which points belong to the object; it overrules CoordinateNet.

        Raises:
            NoPointsError: nothing was seen near the object; the tracker stays as it was.
        """
        last, started = self._pose, perf_counter()
        networks = self._networks
        observation = PointCloud.of(observed) if isinstance(observed, np.ndarray) else observed
        crop = choose_points(
            observation, last, self._category, networks.profile.points, networks.input_sampling, segmentation
        )
        points, labels = crop.points, segmentation.labels(crop.indices)
        points_canonical = canonicalize(points, last)
        neighborhoods = part_neighborhoods(points_canonical, networks.profile)
        sampled = perf_counter()
        prediction = predict(networks, points_canonical, neighborhoods, labels)
        inferred = perf_counter()
        pose, evidence = solve(points, prediction, last, self._category, networks.rotation_fusion)
        self._health = self._health.updated(evidence)
        pose = hold_gauge(reject_leaps(pose, last), last, self._category)
        self._size = self._size.updated(pose)
        self._pose = self._size.apply(pose, evidence.centroid)
        timing = StepTiming(*(1e3 * d for d in (sampled - started, inferred - sampled, perf_counter() - inferred)))
        joints = joint_values(self._pose, self._category)
        return TrackResult(self._pose, self._health.state, self._health.confidence, joints, evidence, timing)


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
        whole = without_background(observation.whole(), segmentation)
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
    (segmentation, coordinates), raw_rotations = side_by_side(
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

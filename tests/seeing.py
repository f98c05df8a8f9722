"""Networks that see the truth in the cloud itself, whoever's it is: what is wrong with an answer came in on the way."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from captra.categories import Category
from captra.geometry import Pose, axis_angle
from captra.joint_projection import UNPROJECTED, JointProjection
from captra.pose_memory import USUAL_ERROR, FoundError
from captra.rotation_fusion import ROTATION_NET_ALONE, RotationFusion
from captra.sampling import InputSampling, Neighborhoods, Profile
from captra.side_by_side import IN_TURN, SideBySide

POINTS = 64
PROFILE = Profile("realtime", POINTS, (16, 4), ((2, 2, 2), (2, 2)))
SIZE = np.array([0.16, 0.10, 0.06])


def body() -> np.ndarray:
    """Points of an object, one opposite the other, spread along its axes as its size is; box diagonals.

    Whitened, so that its principal axes are exactly its own.
    """
    half = np.random.default_rng(0).uniform(-0.5, 0.5, (POINTS // 2, 3))
    points = np.concatenate([half, -half])
    white = points @ np.linalg.inv(np.linalg.cholesky(np.cov(points.T, bias=True)).T)
    points = white * SIZE
    return np.asarray(points / np.linalg.norm(np.ptp(points, axis=0)))


BODY = body()
SPREAD = np.sqrt(np.trace(np.cov(BODY.T, bias=True)))


@dataclass(frozen=True)
class Course:
    """Where one object is in every frame, and what a camera sees of it."""

    start: np.ndarray
    direction: np.ndarray
    scale: float

    @classmethod
    def of(cls, number: int) -> "Course":
        """Like no other's, but so near to some others' that their clouds could be taken for this one's."""
        rng = np.random.default_rng(number)
        start = np.array([0, 0, 0.8]) + 0.04 * np.array(np.unravel_index(number, (4, 4, 8)))
        direction = rng.standard_normal(3)
        return cls(start, direction / np.linalg.norm(direction), rng.uniform(0.17, 0.23))

    def pose(self, frame: int) -> Pose:
        """The truth."""
        rotation = axis_angle(self.direction, 0.05 * frame)
        translation = self.start + 0.004 * frame * self.direction
        size = self.scale * np.ptp(BODY, axis=0)
        return Pose.from_size(rotation[None], translation[None], size[None])

    def cloud(self, frame: int) -> np.ndarray:
        """What is seen: nothing but the object."""
        pose = self.pose(frame)
        seen = pose.scale[0] * BODY @ pose.rotation[0].T + pose.translation[0]
        return np.asarray(seen, np.float32)


@dataclass
class SeeingNetworks:
    """Answers from the points alone: middle, principal axes and spread of one rigid object."""

    category: Category
    profile: Profile = PROFILE
    input_sampling: InputSampling = field(default_factory=InputSampling)
    rotation_fusion: RotationFusion = ROTATION_NET_ALONE
    joint_projection: JointProjection = UNPROJECTED
    found_error: FoundError = USUAL_ERROR
    side_by_side: SideBySide = IN_TURN

    def coordinates(self, points_canonical: np.ndarray, neighborhoods: Neighborhoods) -> tuple[np.ndarray, np.ndarray]:
        """The object's own coordinates; every point is of the object."""
        middle, rotation, scale = seen(points_canonical)
        segmentation = np.zeros((self.category.num_classes, len(points_canonical)), np.float32)
        segmentation[0] = 1
        return segmentation, ((points_canonical - middle) @ rotation / scale)[None].astype(np.float32)

    def rotations(self, points_canonical: np.ndarray, neighborhoods: Sequence[Neighborhoods]) -> np.ndarray:
        """Two columns of the residual rotation, at every point."""
        _, rotation, _ = seen(points_canonical[0])
        return np.tile(rotation[:, :2].T.reshape(6).astype(np.float32), (*points_canonical.shape[:2], 1))


def seen(points: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
    """Middle, rotation and diagonal of the object in a cloud of it, turned by less than 45° from its last pose."""
    distinct = np.unique(points, axis=0).astype(np.float64)
    middle = distinct.mean(axis=0)
    covariance = np.cov((distinct - middle).T, bias=True)
    axes = np.linalg.eigh(covariance)[1][:, ::-1]  # longest first
    axes = axes * np.where(np.diag(axes) < 0, -1, 1)
    return middle, axes, float(np.sqrt(np.trace(covariance)) / SPREAD)

"""Networks that know the truth, for tests of everything around them."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from captra.canonical import canonicalize, decanonicalize
from captra.categories import Category, get_category
from captra.evidence import Evidence, PartEvidence
from captra.geometry import Pose, axis_angle
from captra.joint_projection import UNPROJECTED, JointProjection
from captra.pose_memory import USUAL_ERROR, FoundError
from captra.rotation_fusion import ROTATION_NET_ALONE, RotationFusion
from captra.sampling import REALTIME, InputSampling, Neighborhoods, Profile
from captra.side_by_side import IN_TURN, SideBySide


@dataclass
class OracleNetworks:
    """Answers from `truth` and from `last`, the pose that the tracker canonicalizes with."""

    category: Category
    truth: Pose
    last: Pose
    profile: Profile = REALTIME
    input_sampling: InputSampling = field(default_factory=InputSampling)
    rotation_fusion: RotationFusion = ROTATION_NET_ALONE
    joint_projection: JointProjection = UNPROJECTED
    found_error: FoundError = USUAL_ERROR
    side_by_side: SideBySide = IN_TURN

    def coordinates(self, points_canonical: np.ndarray, neighborhoods: Neighborhoods) -> tuple[np.ndarray, np.ndarray]:
        """Exact coordinates; a point belongs to the part in whose box it lies, or else to the background."""
        root = self.last.part(self.category.root)
        points = decanonicalize(points_canonical[None], root)[0].astype(np.float32)
        coordinates = canonicalize(points, self.truth)
        aspect = self.truth.size / self.truth.scale[:, None]
        inside = (np.abs(coordinates) <= aspect[:, None] / 2 + 1e-3).all(axis=-1)
        labels = np.where(inside.any(axis=0), inside.argmax(axis=0), self.category.num_classes - 1)
        return np.eye(self.category.num_classes, dtype=np.float32)[labels].T, coordinates

    def rotations(self, points_canonical: np.ndarray, neighborhoods: Sequence[Neighborhoods]) -> np.ndarray:
        """The exact residual rotation at every point."""
        residual = np.swapaxes(self.last.rotation, -1, -2) @ self.truth.rotation
        raw = residual[:, :, 1] if self.category.symmetric else np.moveaxis(residual[..., :2], -1, -2).reshape(-1, 6)
        return np.repeat(raw[:, None].astype(np.float32), points_canonical.shape[1], axis=1)


def box_surface(size: np.ndarray, count: int, rng: np.random.Generator) -> np.ndarray:
    """Random points on the surface of a centred box, metres."""
    points = rng.uniform(-0.5, 0.5, (count, 3))
    axis = rng.integers(3, size=count)
    points[np.arange(count), axis] = rng.choice([-0.5, 0.5], count)
    return np.asarray(points * size)


def surfaces(pose: Pose, count: int, rng: np.random.Generator) -> np.ndarray:
    """Random points on every part of an object of boxes, so many of each, in the camera's frame."""
    parts = zip(pose.rotation, pose.translation, pose.size, strict=True)
    return np.concatenate([box_surface(size, count, rng) @ R.T + t for R, t, size in parts]).astype(np.float32)


def elsewhere(pose: Pose) -> Pose:
    """An object that was moved and turned as one rigid thing."""
    turn = axis_angle(np.array([1.0, 2.0, 3.0]), 0.8)
    return replace(pose, rotation=turn @ pose.rotation, translation=pose.translation @ turn.T + [0.1, 0.2, 0.3])


def explaining(*points: int) -> Evidence:
    """Evidence of fits that explain so many points of every part, far apart in all directions."""
    nothing, spread = PartEvidence.missing(0, np.zeros(3)), 10 * np.concatenate([np.eye(3), -np.eye(3)])
    parts = (replace(nothing, explained=np.resize(spread, (count, 3))) for count in points)
    return Evidence(tuple(parts), 1.0, sum(points))


def scene(category_name: str, rng: np.random.Generator, count: int = 3000) -> tuple[Category, Pose, np.ndarray]:
    """A category, the pose of an object of box-shaped parts, and a cloud of it with some background."""
    category = get_category(category_name)
    parts = category.num_parts
    rotation = axis_angle(rng.standard_normal((parts, 3)), rng.uniform(0, 3, parts))
    translation = np.array([0.1, -0.05, 0.8]) + 0.3 * np.arange(parts)[:, None]
    size = rng.uniform(0.08, 0.2, (parts, 3))
    if category.symmetric:
        size[:, 2] = size[:, 0]
    pose = Pose.from_size(rotation, translation, size)
    points = [box_surface(size[part], count, rng) @ rotation[part].T + translation[part] for part in range(parts)]
    if category.background:
        far = rng.standard_normal((count // 4, 3))
        radius = pose.scale[0] * rng.uniform(0.55, 0.7, (len(far), 1))
        points.append(translation[0] + radius * far / np.linalg.norm(far, axis=1, keepdims=True))
    return category, pose, np.concatenate(points).astype(np.float32)

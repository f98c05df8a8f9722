"""From a rendered view to what the networks read and what they should answer."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Float32, Int, Int64
from torch import Tensor

from captra.canonical import canonicalize
from captra.categories import Category
from captra.data.view import View
from captra.geometry import Pose
from captra.learn.perturbation import PerturbationMix, perturb_for_training
from captra.learn.pointnet2 import TorchNeighborhoods
from captra.looking import choose_points
from captra.observations import PointCloud
from captra.sampling import InputSampling, Neighborhoods, Profile, build_neighborhoods

FEWEST_POINTS = 8
"""A part that shows fewer teaches RotationNet nothing."""


@dataclass(frozen=True)
class Sample:
    """One perturbed view, ready for both networks."""

    points: Float32[np.ndarray, "parts N 3"]
    """Canonical cloud of each part, in farthest-point order."""
    root_neighborhoods: Neighborhoods
    """Of the root's cloud, for CoordinateNet."""
    rotation_part: int
    """The part whose cloud RotationNet sees: one a sample, whatever the number of parts, so that all cost the same."""
    rotation_neighborhoods: Neighborhoods
    """Of that part's cloud."""
    labels: Int64[np.ndarray, " N"]
    """True class."""
    coordinates: Float32[np.ndarray, "parts N 3"]
    """True normalized coordinates of every point in every part's frame."""
    rotation: Float32[np.ndarray, "parts 3 3"]
    """True residual rotation."""
    translation: Float32[np.ndarray, "parts 3"]
    """True residual translation, in units of the last scale."""
    scale: Float32[np.ndarray, " parts"]
    """True scale over the last one."""
    aspect: Float32[np.ndarray, "parts 3"]
    """True box in normalized coordinates."""


class Batch(NamedTuple):
    """Samples stacked, as tensors; fields as in `Sample` with a leading batch axis."""

    points: Float[Tensor, "batch parts N 3"]
    root_neighborhoods: TorchNeighborhoods
    rotation_part: Int[Tensor, " batch"]
    rotation_neighborhoods: TorchNeighborhoods
    labels: Int[Tensor, "batch N"]
    coordinates: Float[Tensor, "batch parts N 3"]
    rotation: Float[Tensor, "batch parts 3 3"]
    translation: Float[Tensor, "batch parts 3"]
    scale: Float[Tensor, "batch parts"]
    aspect: Float[Tensor, "batch parts 3"]


@dataclass(frozen=True)
class SampleMaker:
    """Turns views into samples the way the tracker turns clouds into network inputs."""

    category: Category
    """Of the views."""
    density: InputSampling
    """How points are drawn; the tracker must draw them alike."""
    mix: PerturbationMix
    """Around the truth."""

    def __call__(self, view: View, profile: Profile, rng: np.random.Generator) -> Sample:
        """Perturb, crop, sample and canonicalize one view.

        Raises:
            NoPointsError: the perturbed crop is empty.
        """
        truth = Pose.from_size(view.rotation, view.translation, view.size)
        last = perturb_for_training(truth, self.category, self.mix, rng)
        cloud, labels = thin_out(view.points, view.labels, rng)
        crop = choose_points(PointCloud.of(cloud), last, self.category, profile.points, self.density)
        points = crop.points
        points_canonical = canonicalize(points, last)
        root, part = self.category.root, draw_part(labels[crop.indices], self.category.num_parts, rng)
        root_neighborhoods = build_neighborhoods(points_canonical[root], profile)
        inverse = np.swapaxes(last.rotation, -1, -2)
        return Sample(
            points=points_canonical,
            root_neighborhoods=root_neighborhoods,
            rotation_part=part,
            rotation_neighborhoods=(
                root_neighborhoods if part == root else build_neighborhoods(points_canonical[part], profile)
            ),
            labels=labels[crop.indices].astype(np.int64),
            coordinates=canonicalize(points, truth),
            rotation=(inverse @ truth.rotation).astype(np.float32),
            translation=(
                (inverse @ (truth.translation - last.translation)[..., None])[..., 0] / last.scale[:, None]
            ).astype(np.float32),
            scale=(truth.scale / last.scale).astype(np.float32),
            aspect=(truth.size / truth.scale[:, None]).astype(np.float32),
        )


def draw_part(labels: np.ndarray, num_parts: int, rng: np.random.Generator) -> int:
    """One of the parts that can be seen."""
    visible = np.flatnonzero(np.bincount(labels, minlength=num_parts)[:num_parts] >= FEWEST_POINTS)
    return int(rng.choice(visible)) if len(visible) else 0


def thin_out(
    points: Float32[np.ndarray, "all 3"], labels: np.ndarray, rng: np.random.Generator
) -> tuple[Float32[np.ndarray, "some 3"], np.ndarray]:
    """Shuffle, and keep between three fifths and all of the points: clouds come at every density."""
    kept = rng.permutation(len(points))[: max(64, int(len(points) * rng.uniform(0.6, 1.0)))]
    return points[kept], labels[kept]


def stack(samples: list[Sample]) -> Batch:
    """Make one batch of samples of the same profile."""

    def tensor(name: str) -> Tensor:
        return torch.from_numpy(np.stack([getattr(sample, name) for sample in samples]))

    return Batch(
        points=tensor("points"),
        root_neighborhoods=TorchNeighborhoods.stack([sample.root_neighborhoods for sample in samples]),
        rotation_part=torch.tensor([sample.rotation_part for sample in samples]),
        rotation_neighborhoods=TorchNeighborhoods.stack([sample.rotation_neighborhoods for sample in samples]),
        labels=tensor("labels"),
        coordinates=tensor("coordinates"),
        rotation=tensor("rotation"),
        translation=tensor("translation"),
        scale=tensor("scale"),
        aspect=tensor("aspect"),
    )

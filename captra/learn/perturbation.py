"""What poses networks are trained around: the paper's distribution, widened and narrowed."""

from dataclasses import dataclass

import numpy as np

from captra.categories import Category
from captra.geometry import Pose, axis_angle
from captra.perturbation import perturb, random_direction

FULL_TURN = 2 * np.pi


@dataclass(frozen=True)
class PerturbationMix:
    """How the paper's Gaussians are widened and narrowed.

    Narrow ones are what a track that holds looks like; wide ones bring it back, and give the small residual rotations,
    to which the networks' answers are nearly linear, a signal that stands out from what a single view leaves open.
    """

    spreads: tuple[float, ...] = (0.3, 1.0, 1.0, 1.6)
    """Factors on all three standard deviations; one is drawn per pose."""
    turn_deg: float = 12.0
    """Standard deviation of a further rotation about a random axis."""
    turn_share: float = 0.6
    """Share of poses that receive it."""
    weak_axis: tuple[float, float, float] | None = None
    """Object axis about which rotation is hard to see and is perturbed once more; None for none."""
    weak_deg: float = 15.0
    """Standard deviation about that axis."""
    weak_share: float = 0.6
    """Share of poses that receive it."""
    aspect: float = 0.05
    """Relative standard deviation of each side of the box: a tracked box is never exact."""

    @staticmethod
    def for_category(category: Category) -> "PerturbationMix":
        """Widened about y, which is learned last: few points tell it, and networks may settle on never turning."""
        return PerturbationMix(weak_axis=None if category.symmetric else (0.0, 1.0, 0.0))


def perturb_for_training(truth: Pose, category: Category, mix: PerturbationMix, rng: np.random.Generator) -> Pose:
    """A perturbed pose from the widened mixture; a symmetric object is also turned freely about its axis."""
    pose = perturb(truth, category, rng, spread=float(rng.choice(mix.spreads)))
    turn = np.eye(3)
    if rng.random() < mix.turn_share:
        turn = axis_angle(random_direction(rng), np.radians(rng.normal(0, mix.turn_deg)))
    if category.symmetric:
        turn = turn @ axis_angle(np.array([0.0, 1.0, 0.0]), rng.uniform(0, FULL_TURN))
    elif mix.weak_axis is not None and rng.random() < mix.weak_share:
        turn = turn @ axis_angle(np.array(mix.weak_axis), np.radians(rng.normal(0, mix.weak_deg)))
    size = pose.size * np.clip(1 + rng.normal(0, mix.aspect, pose.size.shape), 0.7, 1.4)
    return Pose(pose.rotation @ turn, pose.translation, pose.scale, size)


def rotation_fusion_for(category: Category) -> str:
    """Where a tracker should take rotations from, as validation sequences showed: a name of `ROTATION_FUSIONS`.

    RotationNet and the coordinates err for different reasons, so their mean is better than either; but a mug's turn
    about y, which its handle alone tells, is the coordinates' to say.
    """
    if category.symmetric:
        return "rotation-net"
    return "turn-about-y-from-coordinates" if category.name == "mug" else "mean"

import numpy as np

from captra.categories import CATEGORIES, get_category
from captra.geometry import Pose, rotation_angle
from captra.learn.perturbation import PerturbationMix, perturb_for_training, rotation_fusion_for
from captra.rotation_fusion import ROTATION_FUSIONS


def truth_of(parts: int) -> Pose:
    return Pose.from_size(np.stack([np.eye(3)] * parts), np.ones((parts, 3)), np.full((parts, 3), 0.1))


def test_a_mug_is_turned_further_about_y_than_about_the_other_axes() -> None:
    mug, rng = get_category("mug"), np.random.default_rng(1)
    mix = PerturbationMix.for_category(mug)
    poses = [perturb_for_training(truth_of(1), mug, mix, rng) for _ in range(500)]
    yaw = np.degrees([np.arctan2(pose.rotation[0, 0, 2], pose.rotation[0, 2, 2]) for pose in poses])
    tilt = np.degrees([np.arccos(np.clip(pose.rotation[0, 1, 1], -1, 1)) for pose in poses])
    assert yaw.std() > 1.2 * tilt.std()


def test_a_bottle_is_turned_freely_about_its_axis_but_hardly_tilted() -> None:
    bottle, rng = get_category("bottle"), np.random.default_rng(2)
    mix = PerturbationMix.for_category(bottle)
    poses = [perturb_for_training(truth_of(1), bottle, mix, rng) for _ in range(300)]
    assert np.degrees([rotation_angle(pose.rotation[0]) for pose in poses]).max() > 150
    assert np.degrees([np.arccos(np.clip(pose.rotation[0, 1, 1], -1, 1)) for pose in poses]).max() < 70


def test_every_category_is_tracked_by_a_fusion_that_exists() -> None:
    chosen = {name: rotation_fusion_for(category) for name, category in CATEGORIES.items()}
    assert set(chosen.values()) <= set(ROTATION_FUSIONS)
    assert chosen["bottle"] == "rotation-net"
    assert chosen["drawers"] == "mean"

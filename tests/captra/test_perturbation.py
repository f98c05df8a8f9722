import numpy as np
import pytest

from captra.categories import CATEGORIES, get_category
from captra.geometry import Pose, rotation_angle
from captra.perturbation import perturb


def truth_of(parts: int) -> Pose:
    return Pose.from_size(np.stack([np.eye(3)] * parts), np.ones((parts, 3)), np.full((parts, 3), 0.1))


@pytest.mark.parametrize("name", CATEGORIES)
def test_spread_is_that_of_the_paper(name: str) -> None:
    category, rng = get_category(name), np.random.default_rng(0)
    truth = truth_of(category.num_parts)
    poses = [perturb(truth, category, rng) for _ in range(3000 // category.num_parts)]
    angles = np.degrees([rotation_angle(pose.rotation) for pose in poses]).ravel()
    distances = np.linalg.norm([pose.translation - truth.translation for pose in poses], axis=-1).ravel()
    factors = np.ravel([pose.scale / truth.scale for pose in poses])
    assert np.sqrt(np.mean(angles**2)) == pytest.approx(category.perturbation.rotation_deg, rel=0.1)
    assert np.sqrt(np.mean(distances**2)) == pytest.approx(category.perturbation.translation_m, rel=0.1)
    assert np.std(factors) == pytest.approx(category.perturbation.scale, rel=0.1)

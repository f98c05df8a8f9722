from dataclasses import replace

import numpy as np
import pytest
import torch

from captra.categories import Category
from captra.data.view import View
from captra.geometry import axis_angle, rotation_from_6d
from captra.learn import losses
from captra.learn.perturbation import PerturbationMix
from captra.learn.samples import Batch, Sample, SampleMaker, stack
from captra.sampling import InputSampling, Profile
from tests.oracle import scene

TINY = Profile("tiny", 256, (32, 8), ((4, 4, 4), (4, 4)))


def samples(name: str, count: int = 3) -> tuple[Category, list[Sample]]:
    rng = np.random.default_rng(5)
    category, truth, cloud = scene(name, rng, count=800)
    labels = np.repeat(np.arange(category.num_classes), [800] * category.num_parts + [200] * category.background)
    view = View(
        points=cloud,
        labels=labels.astype(np.uint8),
        rotation=truth.rotation.astype(np.float32),
        translation=truth.translation.astype(np.float32),
        size=truth.size.astype(np.float32),
        joint_values=np.zeros(0, np.float32),
    )
    make = SampleMaker(category, InputSampling(), PerturbationMix.for_category(category))
    return category, [make(view, TINY, rng) for _ in range(count)]


def batch(name: str) -> tuple[Category, Batch, torch.Tensor]:
    category, made = samples(name)
    stacked = stack(made)
    return category, stacked, losses.part_masks(stacked.labels, category.num_parts)


@pytest.mark.parametrize("name", ["mug", "bottle", "laptop_articulated"])
def test_the_truth_costs_nothing(name: str) -> None:
    category, truth, mask = batch(name)
    for term in losses.pose_losses(truth.coordinates, truth, mask, category):
        assert term < 2e-3
    if category.symmetric:
        raw = truth.rotation[..., :, 1]
        assert losses.symmetric_coordinate_loss(truth.coordinates, truth.coordinates, mask) < 2e-3
        assert losses.pairwise_distance_loss(truth.coordinates, truth.coordinates, mask) < 1e-3
    else:
        raw = truth.rotation[..., :2].mT.flatten(-2)
        assert losses.coordinate_loss(truth.coordinates, truth.coordinates, mask) < 2e-3
    raw = raw[:, :, None].expand(-1, -1, 256, -1)
    for term in losses.rotation_losses(raw, truth, mask, category):
        assert term < 2e-3


@pytest.mark.parametrize("name", ["mug", "bottle"])
def test_wrong_coordinates_cost_scale_translation_and_corners(name: str) -> None:
    category, truth, mask = batch(name)
    scale, _, corners = losses.pose_losses(0.8 * truth.coordinates, truth, mask, category)
    assert scale == pytest.approx(0.25, abs=0.02)
    assert corners > 0.02
    shifted = truth.coordinates + torch.tensor([0.0, 0.1, 0.0])
    _, translation, _ = losses.pose_losses(shifted, truth, mask, category)
    assert translation == pytest.approx(0.1 * float(truth.scale.mean()), rel=0.2)


def test_turning_a_symmetric_object_about_its_axis_costs_nothing() -> None:
    category, truth, mask = batch("bottle")
    turn = torch.from_numpy(axis_angle(np.array([0.0, 1, 0]), 1.0)).float()
    turned = truth.coordinates @ turn.T
    assert losses.symmetric_coordinate_loss(turned, truth.coordinates, mask) < 2e-3
    assert losses.pairwise_distance_loss(turned, truth.coordinates, mask) < 1e-3
    for term in losses.pose_losses(turned, truth, mask, category):
        assert term < 3e-3
    assert losses.coordinate_loss(turned, truth.coordinates, mask) > 0.05


def test_rotation_loss_is_the_squared_frobenius_distance() -> None:
    category, truth, mask = batch("mug")
    raw = torch.tensor([1.0, 0, 0, 0, 1, 0]).expand(3, 1, 256, 6)
    rotation, _ = losses.rotation_losses(raw, truth, mask, category)
    expected = (torch.eye(3) - truth.rotation).square().sum((-1, -2)).mean()
    torch.testing.assert_close(rotation, expected, rtol=1e-3, atol=1e-4)


def test_segmentation_loss_falls_towards_the_right_mask() -> None:
    _, truth, _ = batch("mug")
    right = torch.nn.functional.one_hot(truth.labels, 2).movedim(-1, 1).float()
    values = [float(losses.segmentation_loss(factor * right, truth.labels)) for factor in (-5, 0, 2, 20)]
    assert values == sorted(values, reverse=True)
    assert values[-1] < 1e-3


def test_points_outside_the_mask_do_not_count() -> None:
    category, truth, mask = batch("mug")
    spoiled = torch.where(mask[..., None] > 0, truth.coordinates, torch.tensor(9.0))
    assert losses.coordinate_loss(spoiled, truth.coordinates, mask) < 2e-3
    assert max(losses.pose_losses(spoiled, truth, mask, category)) < 2e-3


def test_torch_and_numpy_agree_on_six_numbers() -> None:
    vectors = np.random.default_rng(0).standard_normal((20, 6))
    ours = losses.rotation_from_6d(torch.from_numpy(vectors)).numpy()
    np.testing.assert_allclose(ours, rotation_from_6d(vectors), atol=1e-6)


def test_a_sample_fits_its_own_truth() -> None:
    _, (sample, *_) = samples("camera")
    inside = sample.labels == 0
    mapped = sample.scale[0] * sample.coordinates[0] @ sample.rotation[0].T + sample.translation[0]
    np.testing.assert_allclose(mapped[inside], sample.points[0][inside], atol=1e-4)
    assert np.abs(sample.coordinates[0][inside]).max() < 0.5
    assert replace(sample).aspect[0] == pytest.approx(2 * np.abs(sample.coordinates[0][inside]).max(axis=0), abs=0.05)


def test_stray_points_of_no_class_do_not_count() -> None:
    _, truth, _ = batch("laptop_articulated")
    logits = torch.randn(3, 2, 256, generator=torch.Generator().manual_seed(0))
    labels = truth.labels.clone()
    labels[:, ::10] = 2
    spoiled = logits.clone()
    spoiled[:, :, ::10] = 7 * spoiled[:, :, ::10]
    torch.testing.assert_close(losses.segmentation_loss(logits, labels), losses.segmentation_loss(spoiled, labels))

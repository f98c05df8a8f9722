from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from captra import metrics
from captra.geometry import Pose, axis_angle
from captra.overlap import intersection_volume


def box(size: tuple[float, ...], centre: tuple[float, ...] = (0, 0, 0), rotation: np.ndarray | None = None) -> Pose:
    turn = np.eye(3) if rotation is None else rotation
    return Pose.from_size(turn[None], np.array([centre]), np.array([size]))


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 2**32 - 1))
def test_volume_of_the_intersection_agrees_with_counting_points(seed: int) -> None:
    rng = np.random.default_rng(seed)
    size_a, size_b = rng.uniform(0.5, 2, (2, 3))
    rotation, offset = axis_angle(rng.standard_normal(3), rng.uniform(0, 3)), 0.4 * rng.standard_normal(3)
    points = rng.uniform(-0.5, 0.5, (100_000, 3)) * size_a
    inside = (np.abs((points - offset) @ rotation) <= size_b / 2).all(axis=1).mean()
    volume = intersection_volume(size_a, size_b, rotation, offset)
    assert volume == pytest.approx(inside * size_a.prod(), abs=0.01 * size_a.prod())


def test_iou_of_equal_touching_nested_and_shifted_boxes() -> None:
    a = box((1, 2, 3))
    assert metrics.iou_oriented(a, a, symmetric=False) == pytest.approx(1, abs=1e-5)
    assert metrics.iou_oriented(a, box((1, 2, 3), (1, 0, 0)), symmetric=False) == pytest.approx(0, abs=1e-6)
    assert metrics.iou_oriented(a, box((0.5, 1, 1.5)), symmetric=False) == pytest.approx(1 / 8, abs=1e-5)
    assert metrics.iou_oriented(a, box((1, 2, 3), (0.5, 0, 0)), symmetric=False) == pytest.approx(1 / 3, abs=1e-5)
    assert metrics.iou_oriented(a, box((1, 2, 3), (50, 0, 0)), symmetric=False) == 0


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_iou_is_symmetric_in_its_arguments_and_bounded(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (
        box(tuple(rng.uniform(0.5, 2, 3)), tuple(0.3 * rng.standard_normal(3)), axis_angle(rng.standard_normal(3), 1))
        for _ in range(2)
    )
    forth, back = metrics.iou_oriented(a, b, symmetric=False), metrics.iou_oriented(b, a, symmetric=False)
    assert 0 <= forth <= 1
    assert forth == pytest.approx(back, abs=1e-5)


def test_a_turn_about_y_does_not_matter_to_symmetric_objects() -> None:
    truth = box((1, 2, 1))
    turned = box((1, 2, 1), rotation=axis_angle(np.array([0.0, 1, 0]), 2 * np.pi * 3 / 20))
    assert metrics.rotation_error_deg(turned.rotation, truth.rotation, symmetric=True)[0] == pytest.approx(0, abs=1e-6)
    assert metrics.rotation_error_deg(turned.rotation, truth.rotation, symmetric=False)[0] == pytest.approx(54)
    assert metrics.iou_oriented(turned, truth, symmetric=True) == pytest.approx(1, abs=1e-5)
    assert metrics.iou_oriented(turned, truth, symmetric=False) < 0.9
    assert metrics.iou_nocs(turned, truth, symmetric=True) == pytest.approx(1)


def test_nocs_form_compares_axis_aligned_bounds() -> None:
    turned = box((1, 1, 1), rotation=axis_angle(np.array([0.0, 0, 1]), np.pi / 4))
    assert metrics.iou_nocs(turned, box((1, 1, 1)), symmetric=False) == pytest.approx(0.5)
    assert metrics.iou_oriented(turned, box((1, 1, 1)), symmetric=False) > 0.6


def test_five_degrees_five_centimetres_needs_both() -> None:
    np.testing.assert_array_equal(
        metrics.within(np.array([4.9, 5.1, 4.9]), np.array([4.9, 4.9, 5.1])), [True, False, False]
    )


def test_translation_is_in_centimetres_and_scale_in_percent() -> None:
    a, b = box((0.1, 0.1, 0.1), (0, 0, 0.03)), box((0.2, 0.2, 0.2))
    np.testing.assert_allclose(metrics.translation_error_cm(a.translation, b.translation), [3])
    np.testing.assert_allclose(metrics.scale_error_percent(a, b), [50])


def test_average_distance_is_relative_to_the_part() -> None:
    truth, points = box((0.3, 0.4, 1.2)), np.random.default_rng(0).uniform(-0.5, 0.5, (50, 3))
    assert metrics.average_distance_accuracy(points, box((1, 1, 1), (0.12, 0, 0)), truth, symmetric=False)
    assert not metrics.average_distance_accuracy(points, box((1, 1, 1), (0.14, 0, 0)), truth, symmetric=False)


def test_average_distance_does_not_mind_the_turn_of_a_symmetric_object() -> None:
    truth, points = box((0.3, 0.4, 0.3)), np.random.default_rng(0).uniform(-0.5, 0.5, (50, 3))
    spun = replace(truth, rotation=truth.rotation @ axis_angle(np.array([0.0, 1, 0]), 2.0))
    assert metrics.average_distance_accuracy(points, spun, truth, symmetric=True)
    assert not metrics.average_distance_accuracy(points, spun, truth, symmetric=False)

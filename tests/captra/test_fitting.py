import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra import fitting, moments
from captra.geometry import axis_angle, is_rotation, rotation_angle, rotation_from_axis

SEEDS = st.integers(0, 2**32 - 1)


@pytest.fixture(scope="module", autouse=True)
def _kernels_are_there() -> None:
    """Compiled before the first example, whose time is limited."""
    moments.warm_up()


def turn(rng: np.random.Generator, most: float = 3.0) -> np.ndarray:
    return axis_angle(rng.standard_normal(3), rng.uniform(0, most))


@given(SEEDS)
def test_mean_of_rotations_around_one_rotation_is_that_rotation(seed: int) -> None:
    rng = np.random.default_rng(seed)
    centre, axes = turn(rng), rng.standard_normal((10, 3))
    spread = np.concatenate([axis_angle(axes, 0.2), axis_angle(axes, -0.2)])
    np.testing.assert_allclose(fitting.mean_rotation(centre @ spread), centre, atol=1e-9)


@given(SEEDS)
def test_mean_axis_is_the_mean_of_the_y_columns(seed: int) -> None:
    rng = np.random.default_rng(seed)
    axes = np.array([0, 1, 0]) + 0.3 * rng.standard_normal((20, 3))
    rotations = rotation_from_axis(axes)
    mean = rotations[:, :, 1].mean(axis=0)
    np.testing.assert_allclose(fitting.mean_axis_rotation(rotations)[:, 1], mean / np.linalg.norm(mean), atol=1e-9)


@given(SEEDS, st.floats(0.01, 10))
def test_scale_and_translation_are_recovered(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    rotated, translation = rng.uniform(-0.5, 0.5, (30, 3)), rng.standard_normal(3)
    s, t = fitting.scale_and_translation(rotated, scale * rotated + translation)
    np.testing.assert_allclose(s, scale)
    np.testing.assert_allclose(t, translation, atol=1e-9)


@given(SEEDS)
def test_scale_and_translation_minimize_the_squares(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rotated = rng.uniform(-0.5, 0.5, (30, 3))
    points = 0.2 * rotated + 0.02 * rng.standard_normal((30, 3))
    s, t = fitting.scale_and_translation(rotated, points)

    def cost(scale: float, translation: np.ndarray) -> float:
        return float(np.square(scale * rotated + translation - points).sum())

    for ds, dt in ((1e-3, 0.0), (-1e-3, 0.0), (0.0, 1e-3), (0.0, -1e-3)):
        assert cost(s, t) <= cost(s + ds, t + dt)


@given(SEEDS, st.floats(-3.1, 3.1))
def test_symmetric_alignment_finds_the_turn_about_y(seed: int, angle: float) -> None:
    rng = np.random.default_rng(seed)
    coordinates = rng.uniform(-0.5, 0.5, (30, 3))
    true_turn = axis_angle(np.array([0, 1, 0]), angle)
    points = 0.3 * coordinates @ true_turn.T + rng.standard_normal(3)
    np.testing.assert_allclose(fitting.symmetric_alignment(coordinates, points), true_turn, atol=1e-6)


@given(SEEDS, st.floats(0.01, 10))
def test_umeyama_recovers_a_similarity(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    rotation, translation, source = turn(rng), rng.standard_normal(3), rng.standard_normal((20, 3))
    found = fitting.umeyama(source, scale * source @ rotation.T + translation)
    np.testing.assert_allclose(found.scale, scale)
    np.testing.assert_allclose(found.rotation, rotation, atol=1e-9)
    np.testing.assert_allclose(found.translation, translation, atol=1e-9)


def test_ransac_ignores_outliers_that_spoil_the_plain_fit() -> None:
    rng = np.random.default_rng(0)
    rotation, source = turn(rng), rng.uniform(-0.5, 0.5, (200, 3))
    target = 0.2 * source @ rotation.T
    target[:60] = rng.uniform(-1, 1, (60, 3))
    robust = fitting.umeyama_ransac(source, target, tolerance=0.005, rng=rng)
    assert np.degrees(rotation_angle(robust.rotation.T @ rotation)) < 0.1
    assert np.degrees(rotation_angle(fitting.umeyama(source, target).rotation.T @ rotation)) > 1


def test_ransac_without_any_agreement_falls_back_to_all_points() -> None:
    rng = np.random.default_rng(1)
    source, target = rng.standard_normal((2, 30, 3))
    robust = fitting.umeyama_ransac(source, target, tolerance=1e-9, rng=rng)
    np.testing.assert_allclose(robust.rotation, fitting.umeyama(source, target).rotation)


@given(SEEDS)
def test_closest_gauge_keeps_the_axis_and_turns_least(seed: int) -> None:
    rng = np.random.default_rng(seed)
    reference, rotation = turn(rng), turn(rng)
    held = fitting.closest_gauge(rotation, reference)
    assert is_rotation(held, 1e-9)
    np.testing.assert_allclose(held[:, 1], rotation[:, 1], atol=1e-9)
    about_y = axis_angle(np.tile([0.0, 1.0, 0.0], (60, 1)), np.linspace(0, 6.28, 60))
    assert rotation_angle(reference.T @ held) <= rotation_angle(reference.T @ rotation @ about_y).min() + 1e-6


def test_closest_gauge_does_not_spin_over_a_long_track() -> None:
    rng, held = np.random.default_rng(2), np.eye(3)
    for _ in range(300):
        seen = axis_angle(rng.standard_normal(3), 0.02) @ axis_angle(np.array([0.0, 1.0, 0.0]), rng.uniform(0, 6))
        held = fitting.closest_gauge(seen, held)
    assert np.degrees(rotation_angle(held)) < 5


@given(SEEDS, st.floats(-3.1, 3.1))
def test_angle_about_axis_is_signed(seed: int, angle: float) -> None:
    axis = np.random.default_rng(seed).standard_normal(3)
    np.testing.assert_allclose(fitting.angle_about_axis(axis_angle(axis, angle), axis), angle, atol=1e-6)


@given(SEEDS)
def test_rotation_about_axis_is_a_projection(seed: int) -> None:
    rng = np.random.default_rng(seed)
    axis, rotation = rng.standard_normal(3), turn(rng, 1.0)
    once = fitting.rotation_about_axis(rotation, axis)
    np.testing.assert_allclose(fitting.rotation_about_axis(once, axis), once, atol=1e-9)
    nearby = once @ axis_angle(axis, 0.01)
    assert np.linalg.norm(once - rotation) <= np.linalg.norm(nearby - rotation) + 1e-9

from collections.abc import Callable

import numpy as np
import pytest

from captra.data.shapes import Shape, make_shape
from captra.data.shapes.camera_details import grip
from captra.data.shapes.camera_lenses import LensPlan, make_lens
from captra.data.shapes.camera_plans import (
    CameraPlan,
    boxy,
    compact,
    draw_plan,
    film_reflex,
    mirrorless,
    rangefinder,
    reflex,
)
from captra.data.shapes.mesh import merged

SEEDS = range(14)


def draw(seed: int) -> Shape:
    return make_shape("camera", np.random.default_rng([17, seed]))


@pytest.mark.parametrize("seed", SEEDS)
def test_the_lens_points_to_plus_x_and_the_body_lies_behind_it(seed: int) -> None:
    plan = draw_plan(np.random.default_rng([17, seed]))
    vertices = draw(seed).parts[0].vertices
    rear = vertices[vertices[:, 0] < vertices[:, 0].min() + 0.5 * plan.depth + 0.02]
    assert np.ptp(rear[:, 2]) > 0.4 * plan.width, "the body lies towards -x"
    if plan.lens.length > plan.grip + 0.03:
        front = vertices[vertices[:, 0] > vertices[:, 0].max() - 0.004]
        extent = np.ptp(front, axis=0)[1:]
        assert extent.max() < 3.0 * plan.lens.radius, "what reaches furthest to +x is a lens or its hood"
        assert np.linalg.norm(extent) < 0.9 * np.hypot(plan.width, plan.height)


@pytest.mark.parametrize("kind", [compact, mirrorless, reflex, film_reflex, rangefinder, boxy])
def test_kinds_have_plausible_measures(kind: Callable[[np.random.Generator], CameraPlan]) -> None:
    for seed in range(30):
        plan = kind(np.random.default_rng(seed))
        assert 0.012 < plan.depth < 0.14
        assert 0.045 < plan.height < 0.16
        assert 0.065 < plan.width < 0.17
        assert plan.lens.radius < 0.9 * plan.height
        assert plan.lens.length < 0.28


def test_cameras_vary_from_pocket_to_tele() -> None:
    sizes = np.array([draw(seed).sizes[0] for seed in range(80)])
    assert np.quantile(sizes[:, 0], 0.05) < 0.05
    assert np.quantile(sizes[:, 0], 0.95) > 0.14
    assert sizes[:, 2].min() > 0.065
    scales = np.linalg.norm(sizes, axis=1)
    assert np.quantile(scales, 0.05) > 0.1
    assert scales.max() < 0.4


def test_grips_are_for_the_right_hand() -> None:
    """With x forward and y up, the right hand is at +z; it finds a handle in front of the body."""
    for seed in range(60):
        rng = np.random.default_rng(seed)
        plan = reflex(rng)
        low, high = merged(grip(rng, plan)).bounds()
        assert high[0] == pytest.approx(plan.grip, abs=1e-3)
        assert high[2] == pytest.approx(plan.width / 2, abs=0.0045)
        assert low[2] > plan.lens_z


def test_lenses_have_the_length_that_was_asked_for() -> None:
    for seed in range(30):
        plan = LensPlan(0.03, 0.05, 3)
        mesh = merged(make_lens(np.random.default_rng(seed), plan))
        low, high = mesh.bounds()
        assert low[0] < 0
        assert 0.049 < high[0] < 0.12, "a hood may reach further"

"""What the generators of all articulated categories promise."""

import numpy as np
import pytest
import trimesh

from captra.categories import get_category
from captra.data.shapes import Shape, make_shape
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.mesh import Mesh, merged

SCALES = {
    "drawers": (0.3, 1.85, 0.2),
    "glasses": (0.14, 0.26, 0.008),
    "laptop_articulated": (0.25, 0.52, 0.02),
    "scissors": (0.08, 0.33, 0.03),
}
"""Smallest and largest diagonal, metres, and least standard deviation."""
CATEGORIES = sorted(SCALES)


def draw(category: str, seed: int) -> Shape:
    return make_shape(category, np.random.default_rng([23, seed]))


def posed(shape: Shape, values: np.ndarray) -> list[Mesh]:
    rotation, translation = part_motions(shape, values)
    return [part.moved(r, t) for part, r, t in zip(shape.parts, rotation, translation, strict=True)]


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(12))
def test_parts_are_closed_and_together_centred(category: str, seed: int) -> None:
    shape = draw(category, seed)
    kinematics = get_category(category)
    assert len(shape.parts) == kinematics.num_parts
    assert shape.joint_origins.shape == (len(kinematics.joints), 3)
    assert (shape.joint_limits[:, 0] < shape.joint_limits[:, 1]).all()
    for part in shape.parts:
        solid = trimesh.Trimesh(part.vertices, part.faces, process=False)
        assert np.isfinite(part.vertices).all()
        assert solid.is_watertight
        assert solid.volume > 0, "faces are wound outwards"
    np.testing.assert_allclose(merged(shape.parts).bounds().mean(0), 0, atol=1e-6)


@pytest.mark.parametrize("category", CATEGORIES)
def test_the_same_seed_makes_the_same_instance(category: str) -> None:
    first, again, other = draw(category, 1), draw(category, 1), draw(category, 2)
    for a, b in zip(first.parts, again.parts, strict=True):
        np.testing.assert_array_equal(a.vertices, b.vertices)
    np.testing.assert_array_equal(first.joint_origins, again.joint_origins)
    assert not np.allclose(first.sizes, other.sizes)


@pytest.mark.parametrize("category", CATEGORIES)
def test_sizes_are_those_of_real_objects_and_vary(category: str) -> None:
    scales = np.array([draw(category, seed).scale for seed in range(60)])
    low, high, spread = SCALES[category]
    assert low < scales.min()
    assert scales.max() < high
    assert scales.std() > spread


@pytest.mark.parametrize("category", CATEGORIES)
def test_at_rest_parts_stay_where_they_are(category: str) -> None:
    shape = draw(category, 3)
    for part, moved in zip(shape.parts, posed(shape, np.zeros(len(shape.joint_limits))), strict=True):
        np.testing.assert_allclose(moved.vertices, part.vertices, atol=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_temples_fold_behind_the_lenses(seed: int) -> None:
    shape = draw("glasses", seed)
    right, left, base = (part.bounds() for part in shape.parts)
    assert right[1, 0] < 0 < left[0, 0], "the wearer's right is -x"
    assert right[0, 2] < base[0, 2], "temples reach further to -z than the front does"
    assert base[1, 2] > max(right[1, 2], left[1, 2]) - 0.003
    np.testing.assert_allclose(shape.joint_origins[0] * [-1, 1, 1], shape.joint_origins[1], atol=1e-6)
    folded = posed(shape, np.array([np.pi / 2, np.pi / 2]))
    assert folded[0].bounds()[1, 0] > 0, "the right temple folds towards +x"
    assert folded[1].bounds()[0, 0] < 0
    assert folded[0].bounds()[1, 2] < base[1, 2] + 0.02
    assert folded[0].bounds()[0, 2] > shape.joint_origins[0, 2] - 0.06


@pytest.mark.parametrize("seed", range(8))
def test_scissors_open_about_their_pivot(seed: int) -> None:
    shape = draw("scissors", seed)
    right, left = shape.parts
    origin = shape.joint_origins[0]
    ring = right.vertices[right.vertices[:, 2] < right.bounds()[0, 2] + 0.004]
    assert (ring[:, 0] > origin[0]).all(), "the right half has its ring at +x"
    for part in shape.parts:
        assert part.bounds()[0, 2] < origin[2] < part.bounds()[1, 2]
    opened = posed(shape, np.array([np.radians(60)]))[1]
    tip = left.vertices[:, 2].argmax()
    assert opened.vertices[tip, 0] > left.vertices[tip, 0] + 0.01, "the left blade turns towards +x"
    np.testing.assert_allclose(
        np.linalg.norm(opened.vertices - origin, axis=1), np.linalg.norm(left.vertices - origin, axis=1), atol=1e-5
    )


@pytest.mark.parametrize("seed", range(8))
def test_laptops_open_upwards_at_the_rear(seed: int) -> None:
    shape = draw("laptop_articulated", seed)
    base, display = (part.bounds() for part in shape.parts)
    thickness = base[1, 1] - base[0, 1]
    assert display[0, 1] > base[0, 1]
    assert display[1, 1] > base[1, 1]
    assert shape.joint_origins[0, 2] < base[0, 2] + 0.05 * (base[1, 2] - base[0, 2]) + 0.01, "hinge at -z"
    upright = posed(shape, np.array([np.pi / 2]))[1].bounds()
    assert upright[1, 1] - upright[0, 1] > 3 * thickness
    assert upright[1, 1] > base[1, 1] + 0.1
    assert upright[1, 2] < base.mean(0)[2], "the display stands at the rear"
    np.testing.assert_allclose(np.degrees(shape.joint_limits), [[5, 150]], atol=1e-4)


@pytest.mark.parametrize("seed", range(8))
def test_drawers_are_stacked_slide_forwards_and_are_open_above(seed: int) -> None:
    shape = draw("drawers", seed)
    lowest, middle, top, base = (part.bounds() for part in shape.parts)
    assert lowest[:, 1].mean() < middle[:, 1].mean() < top[:, 1].mean()
    opened = posed(shape, shape.joint_limits[:, 1])
    for part, moved, limit in zip(shape.parts, opened, shape.joint_limits[:, 1], strict=False):
        inside = (part.bounds()[:, :2] >= base[0, :2] - 0.005).all()
        assert inside
        np.testing.assert_allclose(
            moved.vertices - part.vertices, np.tile([0, 0, limit], (len(part.vertices), 1)), atol=1e-6
        )
        assert 0.3 * (base[1, 2] - base[0, 2]) < limit < base[1, 2] - base[0, 2]
        assert moved.bounds()[0, 2] < base[1, 2], "a drawer never leaves the cabinet"
        solid = trimesh.Trimesh(part.vertices, part.faces, process=False)
        inner = part.bounds().mean(0)
        low, high = part.bounds()[:, 1]
        start = np.array([[inner[0] + 0.23 * shape.sizes[0, 0], high + 0.1, inner[2]]])
        hit = solid.ray.intersects_location(start, [[0, -1.0, 0]])[0]
        assert len(hit) > 0
        assert hit[:, 1].max() < low + 0.4 * (high - low), "seen from above, the floor of the box is deep down"

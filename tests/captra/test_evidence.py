import numpy as np
import pytest

from captra.evidence import agreement, inside_box, share_outside, thickness
from captra.geometry import Pose, axis_angle


def test_thickness_is_that_of_the_thinnest_direction_whichever_way_it_points() -> None:
    rng = np.random.default_rng(0)
    slab = rng.standard_normal((20_000, 3)) * [1.0, 0.5, 0.02]
    turned = slab @ axis_angle(np.array([1.0, 2.0, 3.0]), 0.7).T + [0.1, 0.2, 0.5]
    assert thickness(turned) == pytest.approx(0.02, rel=0.05)
    assert thickness(slab * [1.0, 1.0, 0.0]) == pytest.approx(0.0, abs=1e-6)


def test_what_lies_beyond_a_box_and_its_margin_is_outside() -> None:
    size = np.array([0.2, 0.1, 0.1])
    points = np.array([[0.0, 0.0, 0.0], [0.1, 0.05, -0.05], [0.119, 0.0, 0.0], [0.13, 0.0, 0.0], [0.0, -0.07, 0.0]])
    assert share_outside(points, size) == pytest.approx(2 / 5)


def test_agreement_is_the_rms_distance_and_what_is_near() -> None:
    points = np.random.default_rng(1).standard_normal((4, 3)).astype(np.float32)
    off = np.array([[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.4, 0.3], [0.0, 0.0, -0.29]])
    rms, near = agreement(points + off, points, 0.3)
    assert rms == pytest.approx(np.sqrt((0.09 + 0.25 + 0.29**2) / 4), rel=1e-6)
    np.testing.assert_array_equal(near, [True, False, False, True])


def test_a_few_strays_do_not_spoil_the_agreement_of_the_others() -> None:
    rng = np.random.default_rng(3)
    points, noise = rng.standard_normal((1000, 3)), 0.02 * rng.standard_normal((1000, 3))
    rms, _ = agreement(points + noise, points, 0.1)
    assert rms == pytest.approx(0.02 * np.sqrt(3), rel=0.05)
    noise[:40] += [1.0, 0.0, 0.0]
    with_strays, near = agreement(points + noise, points, 0.1)
    assert with_strays == pytest.approx(rms, rel=0.15)
    assert np.count_nonzero(~near) == 40
    noise[:200] += [1.0, 0.0, 0.0]
    assert agreement(points + noise, points, 0.1)[0] > 10 * rms


def test_the_box_of_a_pose_is_turned_and_moved_with_it() -> None:
    rng = np.random.default_rng(2)
    rotation, centre, size = axis_angle(np.array([1.0, 2.0, 3.0]), 0.7), np.array([0.1, 0.2, 0.5]), np.array([1, 2, 3])
    own = rng.uniform(-2, 2, (500, 3))
    box = Pose.from_size(rotation[None], centre[None], size[None])
    inside = inside_box((own @ rotation.T + centre).astype(np.float32), box)
    np.testing.assert_array_equal(inside, (np.abs(own) <= size / 2).all(axis=1))

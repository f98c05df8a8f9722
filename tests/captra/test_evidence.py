import numpy as np
import pytest

from captra.evidence import share_outside, thickness
from captra.geometry import axis_angle


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

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.geometry import Pose
from captra.observations import Crop
from captra.strays import without_strays

LAST = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.array([[0.1, 0.1, 0.1]]))


def crop_of(points: np.ndarray) -> Crop:
    return Crop(points.astype(np.float32), np.arange(len(points)))


def blob(centre: tuple[float, float, float] = (0, 0, 0.5), count: int = 500, seed: int = 0) -> np.ndarray:
    return np.asarray(np.random.default_rng(seed).uniform(-0.05, 0.05, (count, 3)) + centre)


@given(st.integers(1, 50), st.floats(0.5, 3.0), st.integers(0, 100))
def test_points_far_behind_the_object_are_left_out(count: int, behind_m: float, seed: int) -> None:
    strays = blob((0, 0, 0.5 + behind_m), count, seed)
    kept = without_strays(crop_of(np.r_[strays, blob()]), LAST)
    np.testing.assert_array_equal(kept.indices, np.arange(count, count + 500))
    assert kept.total == 500


@pytest.mark.parametrize("beside", [(0.1, 0, 0.5), (0, 0.12, 0.55)])
def test_what_is_near_the_object_stays(beside: tuple[float, float, float]) -> None:
    crop = crop_of(np.r_[blob(), blob(beside, 20)])
    assert without_strays(crop, LAST) is crop


def test_an_object_that_has_jumped_stays_whole() -> None:
    crop = crop_of(blob((1.0, 0, 2.0)))
    assert without_strays(crop, LAST) is crop


def test_what_little_is_seen_of_the_far_end_stays_where_the_object_was() -> None:
    """Nearly all points are at one end of the last box, so close together that the other end is far from them."""
    near_end = np.random.default_rng(0).uniform(-0.002, 0.002, (500, 3)) + (0.05, 0, 0.5)
    crop = crop_of(np.r_[near_end, [[-0.05, 0, 0.5]]])
    assert without_strays(crop, LAST) is crop


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.zeros((1, 3)), np.zeros((20, 3))])
def test_clouds_without_extent_stay_as_they_are(points: np.ndarray) -> None:
    crop = crop_of(points)
    assert without_strays(crop, LAST) is crop


def test_each_part_keeps_what_is_near_it() -> None:
    parts = Pose.from_size(
        np.stack([np.eye(3)] * 2), np.array([[0.0, 0.0, 0.5], [0.4, 0.0, 0.5]]), np.full((2, 3), 0.1)
    )
    crop = crop_of(np.r_[blob(), blob((0.4, 0, 0.5), 5), blob((0.2, 0, 0.9), 5)])
    np.testing.assert_array_equal(without_strays(crop, parts).indices, np.arange(505))

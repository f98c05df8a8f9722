import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from captra import sampling
from captra.geometry import Pose, axis_angle
from captra.observations import PointCloud
from captra.sampling import PROFILES, RADII, REALTIME, InputSampling
from captra.side_by_side import WhileCoresAreFree


def cloud(seed: int, count: int, spread: float = 0.3) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, spread, (count, 3)).astype(np.float32)


def pose_at(centre: tuple[float, float, float], size: float) -> Pose:
    return Pose.from_size(np.eye(3)[None], np.array([centre]), np.full((1, 3), size))


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_farthest_points_of_farthest_points_are_their_prefix(seed: int) -> None:
    points = cloud(seed, 300)
    ordered = points[sampling.farthest_points(points, 200)]
    np.testing.assert_array_equal(sampling.farthest_points(ordered, 64), np.arange(64))


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.1, 10))
def test_farthest_points_do_not_change_under_a_similarity(seed: int, scale: float) -> None:
    rng = np.random.default_rng(seed)
    points = cloud(seed, 200)
    moved = scale * points @ axis_angle(rng.standard_normal(3), 1.0).T + rng.standard_normal(3)
    chosen = sampling.farthest_points(points, 32)
    np.testing.assert_array_equal(sampling.farthest_points(moved.astype(np.float32), 32)[:8], chosen[:8])


def test_short_cloud_is_repeated() -> None:
    chosen = sampling.farthest_points(cloud(0, 30), 70)
    assert len(chosen) == 70
    assert sorted(chosen[:30]) == list(range(30))
    np.testing.assert_array_equal(chosen[30:60], chosen[:30])


def test_groups_hold_the_first_points_inside_the_ball_in_index_order() -> None:
    points = cloud(1, 400)
    groups = sampling.ball_queries(points, 50, RADII[0], (8, 16, 32))
    for radius, group, size in zip(RADII[0], groups, (8, 16, 32), strict=True):
        assert group.shape == (50, size)
        for centre in range(50):
            squared = np.square(points - points[centre]).sum(axis=1)
            inside = np.flatnonzero(squared < np.float32(radius) ** 2)[:size]
            expected = np.r_[inside, np.repeat(inside[0], size - len(inside))]
            np.testing.assert_array_equal(group[centre], expected)


def test_group_without_points_takes_point_zero() -> None:
    empty_radius = (0.0, 0.1, 0.2)
    groups = sampling.ball_queries(cloud(2, 20), 4, empty_radius, (2, 2, 2))
    np.testing.assert_array_equal(groups[0], 0)


def test_three_nearest_are_sorted_by_distance() -> None:
    points = cloud(3, 200)
    nearest = sampling.three_nearest(points, 40)
    distance = np.linalg.norm(points[:, None] - points[None, :40], axis=-1)
    np.testing.assert_array_equal(nearest, np.argsort(distance, axis=1)[:, :3])
    np.testing.assert_array_equal(nearest[:40, 0], np.arange(40))


@pytest.mark.parametrize("parts", [1, 2, 3, 4])
def test_neighborhoods_of_parts_are_those_of_each_cloud_however_the_work_is_shared(parts: int) -> None:
    clouds = np.stack([scale * cloud(5, REALTIME.points) for scale in (1, 2, 0.5, 0.25)[:parts]])
    for found, one in zip(sampling.part_neighborhoods(clouds, REALTIME, WhileCoresAreFree(2)), clouds, strict=True):
        expected = sampling.build_neighborhoods(one, REALTIME)
        for name in ("groups1", "groups2", "nearest1", "nearest2"):
            for mine, theirs in zip(getattr(found, name), getattr(expected, name), strict=True):
                np.testing.assert_array_equal(mine, theirs)


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES.keys())
def test_neighborhoods_have_the_shapes_of_the_profile(profile: sampling.Profile) -> None:
    found = sampling.build_neighborhoods(cloud(4, profile.points), profile)
    first, second = profile.centroids
    assert [g.shape for g in found.groups1] == [(first, k) for k in profile.groups[0]]
    assert [g.shape for g in found.groups2] == [(second, k) for k in profile.groups[1]]
    assert found.nearest1.shape == (profile.points, 3)
    assert found.nearest2.shape == (first, 3)
    assert all(g.dtype == np.int32 and g.max() < profile.points for g in found.groups1)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 2**32 - 1))
def test_parts_share_who_is_nearest_but_not_who_is_within_reach(seed: int) -> None:
    rng = np.random.default_rng(seed)
    profile = sampling.Profile("few", 128, (32, 8), ((4, 8, 16), (4, 8)))
    one = cloud(seed, profile.points)
    parts = np.stack([one, (1.7 * one @ axis_angle(rng.standard_normal(3), 1.0).T + 0.1).astype(np.float32)])
    for found, part in zip(sampling.part_neighborhoods(parts, profile), parts, strict=True):
        alone = sampling.build_neighborhoods(part, profile)
        for level in ("groups1", "groups2"):
            for group, expected in zip(getattr(found, level), getattr(alone, level), strict=True):
                np.testing.assert_array_equal(group, expected)
        for name in ("nearest1", "nearest2"):
            assert np.mean(getattr(found, name) == getattr(alone, name)) > 0.99  # the rest are ties but for rounding


def test_crop_keeps_what_is_within_six_tenths_of_the_scale() -> None:
    points = cloud(5, 5000)
    pose = pose_at((0.1, 0, 0), 0.3)
    inside = sampling.crop_ball(PointCloud.of(points), pose, 0)
    np.testing.assert_array_equal(
        inside.indices, np.flatnonzero(np.linalg.norm(points - [0.1, 0, 0], axis=1) < 0.6 * pose.scale[0])
    )


def test_crop_is_never_smaller_than_five_centimetres() -> None:
    points = cloud(6, 20000, spread=0.05)
    inside = sampling.crop_ball(PointCloud.of(points), pose_at((0, 0, 0), 0.01), 0)
    assert 0.045 < np.linalg.norm(inside.points, axis=1).max() < 0.05


def test_crop_grows_until_it_holds_ten_points() -> None:
    ring = 0.12 * np.array([[np.cos(a), np.sin(a), 0] for a in np.linspace(0, 6, 12)])
    assert len(sampling.crop_ball(PointCloud.of(ring), pose_at((0, 0, 0), 0.05), 0)) == 12


def test_no_points_near_the_object_is_an_error_that_says_what_to_do() -> None:
    with pytest.raises(sampling.NoPointsError, match="metres"):
        sampling.crop_ball(PointCloud.of(cloud(7, 100) + 10), pose_at((0, 0, 0), 0.1), 0)


def test_weights_fall_outside_the_box_and_its_margin() -> None:
    points = np.array([[0, 0, 0], [0.34, 0, 0], [0.36, 0, 0], [0, 0.29, 0]], np.float32)
    weights = sampling.sampling_weights(points, np.array([0.5, 0.4, 0.5]), InputSampling(0.4, 0.1))
    np.testing.assert_allclose(weights, [1, 1, 0.4, 1])


def test_warm_up_runs() -> None:
    sampling.warm_up()

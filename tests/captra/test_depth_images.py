import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from jaxtyping import Float32

from captra.depth_images import DepthImage, Intrinsics, warm_up
from captra.observations import PointCloud

ROWS, COLUMNS = 24, 32
CAMERA = Intrinsics(fx=30.0, fy=28.0, cx=15.3, cy=12.1)
WITHOUT_DEPTH = (0.0, -1.0, np.nan, np.inf, -np.inf)


def unprojected(depth_m: Float32[np.ndarray, "rows columns"]) -> Float32[np.ndarray, "rows columns 3"]:
    v, u = np.mgrid[:ROWS, :COLUMNS].astype(np.float32)
    x, y = (u - CAMERA.cx) / CAMERA.fx * depth_m, (v - CAMERA.cy) / CAMERA.fy * depth_m
    return np.stack([x, y, depth_m], axis=-1).astype(np.float32)


def drawn(seed: int) -> Float32[np.ndarray, "rows columns"]:
    rng = np.random.default_rng(seed)
    depth_m = rng.uniform(0.3, 1.5, (ROWS, COLUMNS)).astype(np.float32)
    lost = rng.random((ROWS, COLUMNS)) < 0.2
    depth_m[lost] = rng.choice(WITHOUT_DEPTH, lost.sum())
    return depth_m


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 1000),
    centre=st.tuples(st.floats(-1, 1), st.floats(-1, 1), st.floats(-0.2, 2)),
    radius_m=st.floats(0.05, 1.0),
)
def test_window_holds_every_pixel_of_the_ball(seed: int, centre: tuple[float, float, float], radius_m: float) -> None:
    depth_m = drawn(seed)
    crop = DepthImage(depth_m, 1.0, CAMERA).near(np.array(centre), radius_m)
    points = unprojected(depth_m).reshape(-1, 3)
    distance = np.linalg.norm(points - np.array(centre), axis=1)
    seen = np.isfinite(points).all(axis=1) & (points[:, 2] > 0)
    surely, possibly = (np.flatnonzero(seen & (distance < radius_m + slack)) for slack in (-1e-5, 1e-5))
    assert set(surely) <= set(crop.indices) <= set(possibly)
    assert (np.diff(crop.indices) > 0).all()
    np.testing.assert_allclose(crop.points, points[crop.indices], atol=1e-6)


def test_sixteen_bits_and_floats_are_the_same_points() -> None:
    depth_mm = np.nan_to_num(1e3 * drawn(1), nan=0, posinf=0, neginf=0).clip(0).astype(np.uint16)
    centre = np.array([0, 0, 0.8])
    whole = DepthImage(depth_mm, 1e-3, CAMERA).near(centre, 0.4)
    floats = DepthImage(depth_mm.astype(np.float32) * np.float32(1e-3), 1.0, CAMERA).near(centre, 0.4)
    assert len(whole) > 50
    np.testing.assert_array_equal(whole.indices, floats.indices)
    np.testing.assert_array_equal(whole.points, floats.points)


def test_whole_image_is_every_pixel_with_depth() -> None:
    depth_m = drawn(2)
    crop = DepthImage(depth_m, 1.0, CAMERA).whole()
    np.testing.assert_array_equal(crop.indices, np.flatnonzero(np.isfinite(depth_m) & (depth_m > 0)))


def test_object_behind_the_camera_is_not_seen() -> None:
    assert len(DepthImage(drawn(3), 1.0, CAMERA).near(np.array([0, 0, -1.0]), 0.5)) == 0


@pytest.mark.parametrize("writeable", [True, False])
def test_image_and_its_points_as_a_cloud_give_the_same_crop(writeable: bool) -> None:
    depth_m = drawn(4)
    depth_m.setflags(write=writeable)
    centre = np.array([0.1, -0.1, 0.9])
    image = DepthImage(depth_m, 1.0, CAMERA)
    x, y, z = np.moveaxis(unprojected(np.where(depth_m > 0, depth_m, np.nan)), -1, 0)
    cloud = PointCloud(x, y, z)
    np.testing.assert_array_equal(image.near(centre, 0.3).indices, cloud.near(centre, 0.3).indices)
    np.testing.assert_array_equal(image.whole().indices, cloud.whole().indices)


def test_warm_up_runs() -> None:
    warm_up()

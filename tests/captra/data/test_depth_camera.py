import numpy as np
import pytest
from scipy.spatial import cKDTree

from captra.data.depth_camera import MIXED, DepthNoise, draw_noise, observe
from captra.data.rendering import NOTHING, Camera, DepthPatch, ball_region, cast
from captra.data.shapes.surfaces import box, superellipsoid

CAMERA = Camera(focal_px=600.0)


def plane(z: float, size: int = 200) -> DepthPatch:
    shape = (size, size)
    return DepthPatch(
        CAMERA,
        (200, 100),
        1,
        np.full(shape, z, np.float32),
        np.zeros(shape, np.int16),
        np.ones(shape, np.float32),
    )


def step(near: float = 0.5, far: float = 0.8) -> DepthPatch:
    """A surface in the middle third of the columns, in front of another one."""
    patch = plane(far)
    middle = slice(70, 130)
    patch.depth[:, middle] = near
    patch.body[:, middle] = 1
    return patch


def rng() -> np.random.Generator:
    return np.random.default_rng(3)


def test_a_perfect_camera_reports_the_truth() -> None:
    seen = observe(step(), DepthNoise(), rng())
    np.testing.assert_array_equal(seen.depth, step().depth)
    np.testing.assert_array_equal(seen.body, step().body)


def test_the_truth_is_left_as_it_was() -> None:
    patch = step()
    observe(patch, draw_noise(rng()), rng())
    np.testing.assert_array_equal(patch.depth, step().depth)


@pytest.mark.parametrize("z", [0.4, 0.8, 1.6])
def test_axial_noise_grows_with_the_square_of_the_distance(z: float) -> None:
    seen = observe(plane(z), DepthNoise(axial_m=0.0005, axial_per_m=0.002), rng())
    assert seen.depth.mean() == pytest.approx(z, abs=2e-4)
    assert seen.depth.std() == pytest.approx(0.0005 + 0.002 * z * z, rel=0.05)


@pytest.mark.parametrize("extent", [20.0, 60.0])
def test_warps_are_shared_by_neighbours_and_have_the_given_strength(extent: float) -> None:
    error = observe(plane(1.0), DepthNoise(warp_m=0.004, warp_px=extent), rng()).depth - 1
    assert error.std() == pytest.approx(0.004, rel=0.05)
    assert np.abs(np.diff(error, axis=1)).mean() < 0.2 * error.std()


def test_grain_is_shared_by_adjacent_pixels_only() -> None:
    error = observe(plane(1.0), DepthNoise(grain_m=0.003, grain_px=3.0), rng()).depth - 1
    adjacent = np.corrcoef(error[:, :-1].ravel(), error[:, 1:].ravel())[0, 1]
    distant = np.corrcoef(error[:, :-30].ravel(), error[:, 30:].ravel())[0, 1]
    assert adjacent > 0.3
    assert abs(distant) < 0.1


def test_disparity_comes_in_steps() -> None:
    noise = DepthNoise(axial_m=0.002, disparity_step_px=1 / 8, baseline_m=0.06)
    depth = observe(plane(0.9), noise, rng()).depth
    steps = 600.0 * 0.06 / depth * 8
    np.testing.assert_allclose(steps, np.rint(steps), atol=2e-3)
    assert len(np.unique(depth)) < 10


def test_depth_comes_in_millimetres() -> None:
    depth = observe(plane(0.9), DepthNoise(axial_m=0.002, depth_step_m=0.001), rng()).depth
    np.testing.assert_allclose(depth * 1000, np.rint(depth * 1000), atol=1e-3)


def test_lateral_noise_frays_edges_and_leaves_surfaces_alone() -> None:
    seen = observe(step(), DepthNoise(lateral_px=1.0), rng())
    assert set(np.unique(seen.depth)) == set(np.unique(step().depth))
    changed = (seen.body != step().body).any(axis=0).nonzero()[0]
    assert 5 < len(changed) < 30
    assert (np.abs(changed - 70).min() < 3) & (np.abs(changed - 129).min() < 3)


def test_windows_make_foregrounds_grow() -> None:
    counts = [(observe(step(), DepthNoise(window_px=w), rng()).body == 1).sum() for w in (0, 2, 4)]
    assert counts[0] < counts[1] < counts[2]


def test_mixed_pixels_lie_between_both_sides_and_belong_to_neither() -> None:
    seen = observe(step(), DepthNoise(mixing=0.5), rng())
    mixed = seen.body == MIXED
    assert mixed.sum() > 50
    assert ((seen.depth[mixed] > 0.5) & (seen.depth[mixed] < 0.8)).all()
    assert np.isin(np.nonzero(mixed.any(axis=0))[0], [*range(67, 74), *range(127, 134)]).all()


def test_edges_lose_pixels() -> None:
    lost = observe(step(), DepthNoise(edge_loss=0.5), rng()).depth == 0
    columns = np.nonzero(lost.any(axis=0))[0]
    assert lost.sum() > 100
    assert np.isin(columns, [*range(67, 74), *range(127, 134)]).all()


@pytest.mark.parametrize(("side", "columns"), [(1, range(40, 70)), (-1, range(130, 160))])
def test_shadows_fall_beside_what_hides_the_background(side: int, columns: range) -> None:
    noise = DepthNoise(shadow=side, baseline_m=0.05)
    lost = observe(step(), noise, rng()).depth == 0
    found = np.nonzero(lost.any(axis=0))[0]
    width = 600 * 0.05 * (1 / 0.5 - 1 / 0.8)
    assert len(found) == pytest.approx(width, abs=2)
    assert set(found) <= set(columns)


def test_grazing_surfaces_are_lost() -> None:
    patch = plane(0.7)
    patch.cosine[:100] = 0.05
    lost = observe(patch, DepthNoise(grazing_cosine=0.2), rng()).depth == 0
    assert lost[:100].all()
    assert not lost[100:].any()


def test_patches_strike_whole_regions_in_the_given_share() -> None:
    lost = observe(plane(0.7), DepthNoise(patch_loss=0.4, struck=1.0), rng()).depth == 0
    assert lost.mean() == pytest.approx(0.4, abs=0.01)
    assert (lost[:, 1:] != lost[:, :-1]).mean() < 0.15
    assert not (observe(plane(0.7), DepthNoise(patch_loss=0.4, struck=0.0), rng()).depth == 0).any()


def test_drawn_cameras_range_from_none_to_strong() -> None:
    errors = []
    for seed in range(120):
        generator = np.random.default_rng(seed)
        seen = observe(plane(0.8), draw_noise(generator), generator)
        errors.append(np.abs(seen.depth[seen.depth > 0] - 0.8).mean())
    assert np.quantile(errors, 0.05) < 0.0004
    assert 0.0005 < np.median(errors) < 0.003
    assert 0.003 < np.quantile(errors, 0.98) < 0.015


def test_cast_points_lie_on_the_surface() -> None:
    ball = superellipsoid((0.1, 0.1, 0.1), 2.0, 200).moved(translation=np.array([0.02, -0.03, 0.7]))
    wall = box((2.0, 2.0, 0.02)).moved(translation=np.array([0, 0, 1.01]))
    patch = cast([ball, wall], CAMERA, np.array([0.02, -0.03, 0.7]), 0.1, 100_000)
    points = patch.directions() * patch.depth[..., None]
    on_ball = points[patch.body == 0]
    np.testing.assert_allclose(np.linalg.norm(on_ball - [0.02, -0.03, 0.7], axis=1), 0.05, atol=2e-4)
    np.testing.assert_allclose(patch.depth[patch.body == 1], 1.0, atol=1e-5)
    assert (patch.body != NOTHING).all()
    assert patch.cosine[patch.body == 1].min() > 0.95


def test_rays_are_limited_by_striding() -> None:
    wall = box((2.0, 2.0, 0.02)).moved(translation=np.array([0, 0, 0.7]))
    center = np.array([0, 0, 0.7])
    fine, coarse = (cast([wall], CAMERA, center, 0.2, rays) for rays in (10**6, 5_000))
    assert fine.stride == 1
    assert coarse.depth.size < 6_000
    both = [(patch.directions() * patch.depth[..., None]).reshape(-1, 3) for patch in (fine, coarse)]
    assert cKDTree(both[0]).query(both[1])[0].max() < 1e-6


def test_the_region_of_a_ball_stays_in_the_image() -> None:
    left, right, top, bottom = ball_region(CAMERA, np.array([0.4, 0, 0.8]), 0.2)
    assert 0 <= left < right == CAMERA.width
    assert 0 <= top < bottom <= CAMERA.height

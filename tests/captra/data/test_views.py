from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from captra.data.depth_camera import DepthNoise
from captra.data.habits import Habits
from captra.data.holders import make_holder
from captra.data.rendering import Camera
from captra.data.scenes import held_scene, make_scene, resting_rotation, table_scene
from captra.data.shapes import make_shape
from captra.data.shapes.mesh import merged
from captra.data.view import View, ball_radius
from captra.data.views import HiddenObjectError, ViewOptions, draw_orbit, make_view, photograph
from captra.geometry import is_rotation

CATEGORIES = ("bottle", "bowl", "camera", "can", "laptop", "mug")


def draw_view(category: str, seed: int) -> View:
    rng = np.random.default_rng([5, seed])
    return make_view(make_shape(category, rng), rng)


def outside_box(view: View) -> np.ndarray:
    """How far each labelled point lies outside the true box, metres."""
    own = (view.points[view.labels == 0] - view.translation[0]) @ view.rotation[0]
    return np.asarray(np.linalg.norm(np.maximum(np.abs(own) - view.size[0] / 2, 0), axis=1))


@pytest.mark.parametrize("category", CATEGORIES)
def test_a_view_depends_on_its_seed_only(category: str) -> None:
    first, again, other = draw_view(category, 1), draw_view(category, 1), draw_view(category, 2)
    np.testing.assert_array_equal(first.points, again.points)
    np.testing.assert_array_equal(first.labels, again.labels)
    assert len(first.points) != len(other.points) or not np.array_equal(first.points, other.points)


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(6))
def test_labels_and_pose_agree_up_to_the_noise(category: str, seed: int) -> None:
    view = draw_view(category, seed)
    assert view.points.dtype == np.float32
    assert view.labels.dtype == np.uint8
    assert set(np.unique(view.labels)) <= {0, 1}
    assert (view.labels == 0).sum() >= 60
    assert is_rotation(view.rotation)
    assert np.quantile(outside_box(view), 0.9) < 0.012
    radius = ball_radius(float(view.pose.scale[0]))
    assert np.linalg.norm(view.points - view.translation[0], axis=1).max() <= radius + 1e-4


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(4))
def test_without_noise_labelled_points_lie_on_the_posed_object(category: str, seed: int) -> None:
    rng = np.random.default_rng([6, seed])
    shape = make_shape(category, rng)
    scene, camera = make_scene(shape, rng), Camera(600.0)
    view = photograph(scene, camera, draw_orbit(scene, camera, rng), DepthNoise(), rng, ViewOptions())
    assert outside_box(view).max(initial=0) < 1e-4
    own = (view.points[view.labels == 0] - view.translation[0]) @ view.rotation[0]
    mesh = trimesh.Trimesh(*shape.parts[0], process=False)
    surface = trimesh.sample.sample_surface(mesh, 40_000, seed=seed)[0]
    if len(own):
        assert np.median(cKDTree(surface).query(own)[0]) < 0.004


def test_views_vary_in_distance_elevation_and_share_of_the_object() -> None:
    views = [draw_view("mug", seed) for seed in range(40)]
    distance = np.array([view.translation[0, 2] for view in views])
    up = np.array([view.rotation[0][:, 1] for view in views])
    share = np.array([(view.labels == 0).mean() for view in views])
    assert distance.min() < 0.5
    assert distance.max() > 1.0
    assert (up[:, 1] > 0).any(), "some stand on their heads"
    assert np.median(up[:, 1]) < -0.3, "most stand upright"
    assert share.min() < 0.1
    assert share.max() > 0.3


def test_what_cannot_be_seen_is_reported() -> None:
    rng = np.random.default_rng(0)
    options = ViewOptions(least_object_points=10**6, attempts=2)
    with pytest.raises(HiddenObjectError, match="mug"):
        make_view(make_shape("mug", rng), rng, options)


@pytest.mark.parametrize("seed", range(8))
def test_resting_objects_stand_on_the_plane(seed: int) -> None:
    rng = np.random.default_rng(seed)
    scene = table_scene(make_shape("mug", rng), np.zeros(0), rng)
    lowest = (scene.shape.parts[0].vertices @ scene.rotation.T)[:, 1].min()
    support = scene.surroundings[0].bounds()
    assert support[1, 1] == pytest.approx(lowest, abs=1e-5)


def test_lying_objects_rest_on_their_convex_hull() -> None:
    rng = np.random.default_rng(2)
    vertices = make_shape("bottle", rng).parts[0].vertices
    lying = 0
    for _ in range(60):
        rotation = resting_rotation(rng, vertices, Habits())
        assert is_rotation(rotation)
        lying += abs(rotation[1, 1]) < 0.5
    assert lying > 3


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(8))
def test_hands_touch_what_they_hold(category: str, seed: int) -> None:
    rng = np.random.default_rng([7, seed])
    vertices = make_shape(category, rng).parts[0].vertices
    holder = make_holder(rng, vertices, category)
    assert np.isfinite(holder.vertices).all()
    assert cKDTree(holder.vertices).query(vertices)[0].min() < 0.02


def test_a_held_object_leaves_room_to_move() -> None:
    rng = np.random.default_rng(4)
    shape = make_shape("mug", rng)
    for _ in range(5):
        scene = held_scene(shape, np.zeros(0), rng, clearance=0.5)
        own = merged([shape.parts[0].moved(scene.rotation)]).vertices
        if scene.surroundings:
            others = merged(scene.surroundings).vertices
            assert cKDTree(others).query(own)[0].min() > 0.05


def test_a_view_of_fewer_points_is_a_subset_in_the_same_ball() -> None:
    rng = np.random.default_rng(9)
    scene, camera = make_scene(make_shape("mug", rng), rng), Camera(600.0)
    orbit = draw_orbit(scene, camera, rng)
    options = replace(ViewOptions(), points=(1000, 1000))
    few = photograph(scene, camera, orbit, DepthNoise(), rng, options)
    many = photograph(scene, camera, orbit, DepthNoise(), rng, ViewOptions(points=(10**6, 10**6)))
    assert len(few.points) <= 1000
    assert cKDTree(many.points).query(few.points)[0].max() == 0

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from captra.canonical import canonicalize
from captra.categories import CATEGORIES, get_category
from captra.farthest import farthest_order
from captra.geometry import Pose, axis_angle, rotation_angle, rotation_from_vector
from captra.joint_projection import ALONG_AXES, UNPROJECTED
from captra.looking import look
from captra.observations import PointCloud
from captra.sampling import REALTIME, build_neighborhoods
from captra.walls import AlongWalls, Patches, along_walls, square
from tests.oracle import OracleNetworks, box_surface, surfaces

DRAWERS = get_category("drawers")
SIZE = np.array([0.6, 0.9, 0.45])


def cabinet(seed: int) -> Pose:
    """Four boxes, turned alike, beside each other."""
    rng = np.random.default_rng(seed)
    rotation = axis_angle(rng.standard_normal(3), rng.uniform(0, 3))
    translation = np.array([0.0, 0.0, 1.5]) + np.arange(-1.5, 2)[:, None] * [0.45, 0, 0] @ rotation.T
    return Pose.from_size(np.tile(rotation, (4, 1, 1)), translation, np.tile([0.4, 0.9, 0.5], (4, 1)))


def patches(points: np.ndarray, rotation: np.ndarray, seed: int = 0) -> Patches:
    """Of a cloud as the tracker would pick it from a box's surface, in the camera's frame."""
    chosen = points[farthest_order(points.astype(np.float32), np.ones(len(points), np.float32), REALTIME.points)]
    own = Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), SIZE[None])
    neighborhoods = build_neighborhoods(canonicalize(chosen.astype(np.float32), own)[0], REALTIME)
    return Patches.of((chosen @ rotation.T).astype(np.float32), neighborhoods.groups1[1])


def off_by(rotation: np.ndarray, vector_deg: np.ndarray) -> np.ndarray:
    return np.asarray(rotation @ rotation_from_vector(np.radians(vector_deg)))


def apart_deg(rotation: np.ndarray, other: np.ndarray) -> np.ndarray:
    return np.asarray(np.degrees(rotation_angle(np.swapaxes(other, -1, -2) @ rotation)))


errors_deg = st.tuples(*[st.floats(-4, 4)] * 3).map(np.array)


@settings(deadline=None)
@given(errors_deg, st.integers(0, 9))
def test_walls_tell_how_a_box_is_turned(error_deg: np.ndarray, seed: int) -> None:
    rng = np.random.default_rng(seed)
    truth = axis_angle(rng.standard_normal(3), rng.uniform(0, 3))
    seen = patches(box_surface(SIZE, 3000, rng) + rng.normal(0, 0.003, (3000, 3)), truth)
    assert apart_deg(square(off_by(truth, error_deg), seen), truth) < 0.25 + 0.1 * np.linalg.norm(error_deg)


def test_one_wall_tells_nothing_of_the_turn_about_what_it_faces() -> None:
    rng = np.random.default_rng(0)
    front = box_surface(SIZE, 20000, rng)
    seen = patches(front[front[:, 2] > 0.2249], np.eye(3))
    about_z, across = np.array([0.0, 0.0, 3.0]), np.array([2.0, -2.0, 0.0])
    np.testing.assert_allclose(square(off_by(np.eye(3), about_z), seen), off_by(np.eye(3), about_z), atol=1e-3)
    assert apart_deg(square(off_by(np.eye(3), across), seen), np.eye(3)) < 0.3


def test_what_is_no_wall_has_no_say() -> None:
    rng = np.random.default_rng(1)
    blob = rng.normal(0, 0.1, (3000, 3))
    start = off_by(np.eye(3), np.array([3.0, -2.0, 1.0]))
    assert apart_deg(square(start, patches(blob, np.eye(3))), start) < 0.3
    slanted = patches(box_surface(SIZE, 3000, rng), axis_angle(np.array([1.0, 1.0, 1.0]), 0.6))
    np.testing.assert_allclose(square(start, slanted), start, atol=1e-6)


def test_a_group_that_is_filled_up_counts_its_first_point_once() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0.5, 0.5, 0.01]], np.float32)
    short, padded = np.array([[0, 1, 2, 3, 4]], np.int32), np.array([[0, 1, 2, 3, 4, 0, 0, 0]], np.int32)
    np.testing.assert_allclose(
        np.abs(Patches.of(corners, padded).normal), np.abs(Patches.of(corners, short).normal), atol=1e-9
    )
    assert Patches.of(corners, padded).flatness == pytest.approx(Patches.of(corners, short).flatness)
    assert Patches.of(corners, np.array([[0, 1, 2, 0, 0, 0]], np.int32)).flatness == 0, "any three points are flat"


@pytest.mark.parametrize("name", sorted(CATEGORIES))
def test_only_cabinets_have_walls(name: str) -> None:
    cloud = np.random.default_rng(0).random((REALTIME.points, 3), np.float32)
    projection = along_walls(UNPROJECTED, cloud, build_neighborhoods(cloud, REALTIME), get_category(name))
    assert isinstance(projection, AlongWalls) == (name == "drawers")


def test_rotations_stay_rotations_however_often_they_are_turned() -> None:
    rng = np.random.default_rng(2)
    seen = patches(box_surface(SIZE, 3000, rng), np.eye(3))
    along = AlongWalls(ALONG_AXES, seen)
    rotation = np.tile(off_by(np.eye(3), np.array([1.0, 2.0, 0.5])), (4, 1, 1)) * (1 + 1e-7)
    for _ in range(200):
        rotation = along(rotation, np.ones(4, int), DRAWERS)
    np.testing.assert_allclose(rotation @ np.swapaxes(rotation, -1, -2), np.tile(np.eye(3), (4, 1, 1)), atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_a_look_at_a_cabinet_is_turned_along_its_walls(seed: int) -> None:
    truth = cabinet(seed)
    off = replace(truth, rotation=off_by(truth.rotation, np.array([1.5, -1.0, 2.0])))
    networks = OracleNetworks(DRAWERS, off, truth)
    found = look(networks, PointCloud.of(surfaces(truth, 2000, np.random.default_rng(seed))), truth)
    assert apart_deg(off.rotation, truth.rotation).min() > 2.5
    assert apart_deg(found.pose.rotation, truth.rotation).max() < 0.5

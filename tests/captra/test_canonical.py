import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from captra.canonical import canonicalize, compose, decanonicalize
from captra.geometry import Pose, axis_angle, box_corners


def random_pose(rng: np.random.Generator, parts: int) -> Pose:
    rotation = axis_angle(rng.standard_normal((parts, 3)), rng.uniform(0, 3, parts))
    return Pose.from_size(rotation, rng.uniform(-1, 1, (parts, 3)), rng.uniform(0.05, 0.5, (parts, 3)))


@given(st.integers(0, 2**32 - 1), st.integers(1, 4))
def test_round_trip(seed: int, parts: int) -> None:
    rng = np.random.default_rng(seed)
    pose, points = random_pose(rng, parts), rng.uniform(-1, 1, (20, 3))
    back = decanonicalize(canonicalize(points, pose), pose)
    np.testing.assert_allclose(back, np.broadcast_to(points, back.shape), atol=1e-5)


def test_box_corners_become_corners_of_the_unit_diagonal_box() -> None:
    pose = random_pose(np.random.default_rng(0), 1)
    corners = box_corners(pose.size)[0] @ pose.rotation[0].T + pose.translation[0]
    np.testing.assert_allclose(np.linalg.norm(canonicalize(corners, pose)[0], axis=1), 0.5, atol=1e-5)


@given(st.integers(0, 2**32 - 1))
def test_residual_composes_to_the_new_pose(seed: int) -> None:
    rng = np.random.default_rng(seed)
    last, residual = random_pose(rng, 2), random_pose(rng, 2)
    new = compose(last, residual)
    in_part = rng.uniform(-0.5, 0.5, (2, 5, 3))
    direct = decanonicalize(in_part, new)
    np.testing.assert_allclose(decanonicalize(decanonicalize(in_part, residual), last), direct, atol=1e-9)

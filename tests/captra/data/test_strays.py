import numpy as np
import pytest
from scipy.spatial import cKDTree

from captra.data.strays import FARTHEST_M, keep_segment


@pytest.fixture
def scene() -> tuple[np.ndarray, np.ndarray]:
    """A square object of two parts half a metre away, and a wall behind it."""
    rng = np.random.default_rng(0)
    own = np.column_stack([rng.uniform(-0.1, 0.1, (2000, 2)), np.full(2000, 0.5)])
    wall = np.column_stack([rng.uniform(-0.6, 0.6, (3000, 2)), np.full(3000, 1.0)])
    far = np.array([[0.0, 0.0, FARTHEST_M + 0.1]])
    points = np.concatenate([own, wall, far]).astype(np.float32)
    labels = np.concatenate([np.arange(2000) % 2, np.full(3001, 2)]).astype(np.uint8)
    return points, labels


def test_without_strays_the_object_alone_is_kept(scene: tuple[np.ndarray, np.ndarray]) -> None:
    points, labels = keep_segment(*scene, 2, 0.0, np.random.default_rng(0))
    np.testing.assert_array_equal(points, scene[0][:2000])
    np.testing.assert_array_equal(labels, scene[1][:2000])


def test_half_of_the_views_have_up_to_the_given_share_of_points_of_no_part(
    scene: tuple[np.ndarray, np.ndarray],
) -> None:
    shares, angles = [], []
    for seed in range(120):
        points, labels = keep_segment(*scene, 2, 0.05, np.random.default_rng(seed))
        stray = labels == 2
        assert (labels[~stray] < 2).all()
        assert (~stray).sum() == 2000, "no point of the object is lost"
        assert points[:, 2].max() < FARTHEST_M
        shares.append(stray.mean())
        if stray.any():
            own, others = (p[:, :2] / p[:, 2:] for p in (points[~stray], points[stray]))
            angles.append(float(cKDTree(own).query(others)[0].max()))
    assert max(shares) <= 0.05
    assert max(shares) > 0.035
    assert 0.3 < np.mean(np.array(shares) == 0) < 0.7
    assert min(angles) < 0.02, "some lie along the outline"
    assert max(angles) > 0.1, "some lie anywhere"

import numpy as np
import pytest
import trimesh

from captra.data.reaching_hands import reaching_hand
from captra.data.shapes.registry import make_shape


@pytest.mark.parametrize("category", ["bottle", "bowl", "camera", "can", "mug"])
@pytest.mark.parametrize("seed", range(4))
def test_fingers_touch_the_object_and_the_hand_stays_outside(category: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    vertices = make_shape(category, rng).parts[0].vertices
    hand = reaching_hand(rng, vertices)
    apart = np.linalg.norm(hand.vertices[:, None] - vertices[None], axis=-1).min(axis=1)
    assert apart.min() < 0.03
    hull = trimesh.PointCloud(vertices).convex_hull
    assert np.mean(hull.contains(hand.vertices)) < 0.4


def test_it_comes_from_every_side() -> None:
    rng = np.random.default_rng(0)
    vertices = make_shape("can", rng).parts[0].vertices
    middles = np.stack([reaching_hand(rng, vertices).vertices.mean(axis=0) for _ in range(40)])
    assert (middles.min(axis=0) < -0.05).all()
    assert (middles.max(axis=0) > 0.05).all()

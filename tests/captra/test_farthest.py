import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from captra.farthest import BLOCK, farthest_order


def plain(points: np.ndarray, weights: np.ndarray, count: int) -> np.ndarray:
    distance = np.full(len(points), np.inf, np.float32)
    order = [0]
    for _ in range(count - 1):
        d = points - points[order[-1]]
        squared = ((d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1]) + d[:, 2] * d[:, 2]) * (weights * weights)
        distance = np.minimum(distance, squared)
        order.append(int(distance.argmax()))
    return np.array(order)


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 5 * BLOCK), st.booleans(), st.booleans())
def test_same_as_the_plain_algorithm(seed: int, total: int, weighted: bool, on_grid: bool) -> None:
    rng = np.random.default_rng(seed)
    points = rng.standard_normal((total, 3)).astype(np.float32)
    if on_grid:  # ties and repeated points
        points = np.round(points).astype(np.float32)
    weights = rng.choice([1.0, 0.4], total).astype(np.float32) if weighted else np.ones(total, np.float32)
    np.testing.assert_array_equal(farthest_order(points, weights, total), plain(points, weights, total))


def test_lighter_points_are_chosen_more_sparsely() -> None:
    rng = np.random.default_rng(0)
    points = np.c_[rng.uniform(-1, 1, (4000, 2)), np.zeros(4000)].astype(np.float32)
    light = points[:, 0] < 0
    weights = np.where(light, 0.5, 1).astype(np.float32)
    chosen = light[farthest_order(points, weights, 500)]
    assert 0.15 < chosen.mean() < 0.25  # half the distance weight, a quarter of the density

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from captra.moments import Moments


@settings(deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 40))
def test_sums_are_those_of_the_definition(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    source, target = rng.standard_normal((2, count, 3)).astype(np.float32) + 5
    found = Moments.of(source, target)
    x, y = source.astype(np.float64), target.astype(np.float64)
    x_centred, y_centred = x - x.mean(axis=0), y - y.mean(axis=0)
    np.testing.assert_allclose(found.source_mean, x.mean(axis=0))
    np.testing.assert_allclose(found.target_mean, y.mean(axis=0))
    np.testing.assert_allclose(found.products, y_centred.T @ x_centred, atol=1e-9)
    np.testing.assert_allclose(found.source_square, np.sum(x_centred**2), atol=1e-9)


def test_columns_of_a_larger_array_are_read_as_they_are() -> None:
    wide = np.random.default_rng(1).standard_normal((7, 6))
    assert Moments.of(wide[:, ::2], wide[:, 1::2]).target_mean.tolist() == wide[:, 1::2].mean(axis=0).tolist()


def test_without_points_nothing_is_known() -> None:
    assert np.isnan(Moments.of(np.zeros((0, 3)), np.zeros((0, 3))).source_mean).all()

import hypothesis.strategies as st
import numpy as np
from hypothesis import given, settings
from onnx import numpy_helper

from export.onnx_export import coordinate_model
from export.rounding import NEAREST, Compensated
from tests.made_up import networks_of


def products_apart(inputs: np.ndarray, matrix: np.ndarray, whole: np.ndarray, scale: np.ndarray) -> float:
    return float(np.square(inputs @ (whole * scale - matrix)).mean())


@settings(max_examples=30)
@given(seed=st.integers(0, 10_000), shared=st.integers(1, 8), largest=st.sampled_from([7, 15, 31]))
def test_products_of_inputs_that_go_together_change_less_than_with_the_nearest_numbers(
    seed: int, shared: int, largest: int
) -> None:
    rng = np.random.default_rng(seed)
    causes = rng.normal(size=(400, shared)) @ rng.normal(size=(shared, 40))
    inputs, matrix = np.maximum(causes + 0.1 * rng.normal(size=causes.shape), 0), rng.normal(size=(40, 20))
    rounded = Compensated({"w": inputs.T @ inputs})("w", matrix, largest)
    nearest = NEAREST("w", matrix, largest)
    assert rounded.whole.dtype == np.int8
    assert np.abs(rounded.whole).max() <= 2 * largest
    apart = products_apart(inputs, matrix, rounded.whole, rounded.scale)
    assert apart < 0.7 * products_apart(inputs, matrix, nearest.whole, nearest.scale)


def test_inputs_that_have_nothing_to_do_with_each_other_make_up_for_nothing() -> None:
    matrix = np.random.default_rng(0).normal(size=(30, 10))
    rounded = Compensated({"w": np.eye(30)})("w", matrix, 15)
    assert (np.abs(rounded.whole * rounded.scale - matrix) <= 0.501 * rounded.scale)[np.abs(rounded.whole) < 15].all()


def test_a_matrix_of_which_no_inputs_were_seen_gets_the_nearest_numbers() -> None:
    matrix = np.random.default_rng(1).normal(size=(30, 10))
    rounded, nearest = Compensated({})("w", matrix, 7), NEAREST("w", matrix, 7)
    np.testing.assert_array_equal(rounded.whole, nearest.whole)
    np.testing.assert_array_equal(rounded.scale, nearest.scale)


def test_inputs_that_are_always_zero_do_no_harm() -> None:
    rng = np.random.default_rng(2)
    inputs = rng.normal(size=(100, 20)) * (np.arange(20) < 12)
    rounded = Compensated({"w": inputs.T @ inputs})("w", rng.normal(size=(20, 5)), 7)
    assert np.isfinite(rounded.scale).all()


def test_columns_of_nothing_stay_nothing() -> None:
    rounded = Compensated({"w": np.eye(20)})("w", np.zeros((20, 3)), 7)
    assert not (rounded.whole * rounded.scale).any()


def test_a_coarser_matrix_takes_larger_steps_and_a_finer_one_smaller_ones() -> None:
    matrix = np.random.default_rng(3).normal(size=(30, 10))
    peak = np.abs(matrix).max(axis=0)
    for coarseness, largest in ((1.0, 7.0), (0.5, 14.0), (0.01, 127.0), (3.0, 7 / 3), (50.0, 1.0)):
        rounded = Compensated({"w": np.eye(30)}, {"w": coarseness})("w", matrix, 7)
        np.testing.assert_allclose(rounded.scale, peak / largest)
        assert np.abs(rounded.whole).max() == round(largest)


def test_matrices_of_few_inputs_keep_eight_bits() -> None:
    constants = {
        c.name: numpy_helper.to_array(c) for c in coordinate_model(networks_of("mug")[0], "int4").graph.initializer
    }
    assert np.abs(constants["level1.0.0.weight"]).max() == 127
    assert np.abs(constants["hidden.weight"]).max() == 7

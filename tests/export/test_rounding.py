import hypothesis.strategies as st
import numpy as np
import onnx
import onnxruntime
import pytest
from hypothesis import given, settings
from onnx import TensorProto, numpy_helper

from captra.sampling import REALTIME, build_neighborhoods
from export.graph import GraphWriter, tensor
from export.inputs import made_up_clouds
from export.onnx_export import coordinate_model
from export.rounding import NEAREST, Compensated, closest_scale, second_moments
from tests.made_up import networks_of


def single(values: list[object]) -> np.ndarray:
    return np.array(values, np.float32)


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
    assert np.abs(rounded.whole).max() <= largest
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


def test_the_closest_scale_cuts_a_weight_off_rather_than_all_others_short() -> None:
    matrix = np.concatenate([np.random.default_rng(3).uniform(-1, 1, (200, 1)), [[2.0]]])
    assert 0.5 * 2.0 / 7 <= closest_scale(matrix, 7)[0] < 0.8 * 2.0 / 7


def test_second_moments_are_those_of_every_input_of_a_product() -> None:
    g = GraphWriter("float32")
    first, second = single([[1, 2], [0, 1], [1, 0]]), single([[1], [3]])
    hidden = g("Gemm", "x", g.matrix("first", first), g.vector("bias", single([1, -5])))
    g("MatMul", g("Relu", hidden), g.matrix("second", second), name="y")
    model = g.model("two", [tensor("x", TensorProto.FLOAT, "N", 3)], [tensor("y", TensorProto.FLOAT, "N", 1)])
    feeds = [{"x": single([[1, 2, 3]])}, {"x": single([[0, 1, 0], [1, 1, 1]])}]
    moments = second_moments(model, feeds)
    rows = np.concatenate([feed["x"] for feed in feeds]).astype(float)
    activated = np.maximum(rows @ first + [1, -5], 0)
    np.testing.assert_allclose(moments["first"], rows.T @ rows)
    np.testing.assert_allclose(moments["second"], activated.T @ activated)


@pytest.fixture(scope="module")
def clouds() -> list[dict[str, np.ndarray]]:
    from captra.runtime.onnx_networks import feed

    made_up = [made_up_clouds(1, REALTIME, seed) for seed in range(12)]
    return [feed(cloud, [build_neighborhoods(cloud[0], REALTIME)]) for cloud in made_up]


def test_a_whole_network_answers_nearer_to_itself(clouds: list[dict[str, np.ndarray]]) -> None:
    network = networks_of("mug")[0]
    exact = coordinate_model(network, "float32")
    compensated = Compensated(second_moments(exact, clouds[:8]))
    models = [exact, coordinate_model(network, "int4", compensated), coordinate_model(network, "int4")]
    answers = [answers_of(model, clouds[8:]) for model in models]
    near, far = (np.sqrt(np.square(other - answers[0]).mean()) for other in answers[1:])
    assert 0 < near < 0.6 * far


def answers_of(model: onnx.ModelProto, clouds: list[dict[str, np.ndarray]]) -> np.ndarray:
    session = onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])
    return np.concatenate([session.run(["coordinates"], cloud)[0] for cloud in clouds])


def test_matrices_of_few_inputs_keep_eight_bits() -> None:
    constants = {
        c.name: numpy_helper.to_array(c) for c in coordinate_model(networks_of("mug")[0], "int4").graph.initializer
    }
    assert np.abs(constants["level1.0.0.weight"]).max() == 127
    assert np.abs(constants["hidden.weight"]).max() == 7

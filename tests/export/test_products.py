import numpy as np
import onnx
import onnxruntime
import pytest
from onnx import TensorProto

from captra.runtime.onnx_networks import feed
from captra.sampling import REALTIME, build_neighborhoods
from export.graph import GraphWriter, tensor
from export.inputs import made_up_clouds
from export.onnx_export import coordinate_model
from export.products import coarseness, second_moments
from export.rounding import Compensated
from tests.made_up import networks_of


def single(values: list[object]) -> np.ndarray:
    return np.array(values, np.float32)


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
    made_up = [made_up_clouds(1, REALTIME, seed) for seed in range(12)]
    return [feed(cloud, [build_neighborhoods(cloud[0], REALTIME)]) for cloud in made_up]


def test_a_whole_network_answers_nearer_to_itself_and_nearest_with_bits_where_they_count(
    clouds: list[dict[str, np.ndarray]],
) -> None:
    network = networks_of("mug")[0]
    exact = coordinate_model(network, "float32")
    moments = second_moments(exact, clouds[:8])
    factors = coarseness(exact, moments, clouds[:3])
    roundings = [Compensated(moments, factors), Compensated(moments)]
    models = [exact, *(coordinate_model(network, "int4", rounding) for rounding in roundings)]
    shared_out, compensated, nearest = (
        np.sqrt(np.square(answers_of(model, clouds[8:]) - answers_of(exact, clouds[8:])).mean())
        for model in (*models[1:], coordinate_model(network, "int4"))
    )
    assert 0 < shared_out < 0.8 * compensated < 0.8 * 0.8 * nearest


def test_factors_are_one_in_the_mean_over_all_weights(clouds: list[dict[str, np.ndarray]]) -> None:
    exact = coordinate_model(networks_of("mug")[0], "float32")
    factors = coarseness(exact, second_moments(exact, clouds[:3]), clouds[:2])
    sizes = {constant.name: np.prod(constant.dims) for constant in exact.graph.initializer}
    mean = np.average(np.log(list(factors.values())), weights=[sizes[name] for name in factors])
    assert mean == pytest.approx(0, abs=1e-9)
    assert factors["level3.2.weight"] > 1 > factors["level1.0.1.weight"]


def answers_of(model: onnx.ModelProto, clouds: list[dict[str, np.ndarray]]) -> np.ndarray:
    session = onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])
    return np.concatenate([session.run(["coordinates"], cloud)[0] for cloud in clouds])

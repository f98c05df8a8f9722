"""What a frame needs, against what ONNX Runtime computes on the exported graphs."""

import numpy as np
import onnx
import onnxruntime
import pytest

from captra.bench.work import multiply_adds
from captra.categories import get_category
from captra.runtime.onnx_networks import feed
from captra.sampling import build_neighborhoods
from export.inputs import made_up_clouds
from export.onnx_export import coordinate_model, rotation_model
from tests.made_up import TINY, networks_of


def counted(model: onnx.ModelProto, inputs: dict[str, np.ndarray]) -> int:
    """Multiply-adds of every matrix product of a graph, by the shapes of what it is run on."""
    products = [node for node in model.graph.node if node.op_type in ("MatMul", "Gemm")]
    names = {name for node in products for name in (node.input[1], node.output[0])}
    known = {tensor.name: tuple(tensor.dims) for tensor in model.graph.initializer if tensor.name in names}
    del model.graph.output[:]
    model.graph.output.extend(onnx.ValueInfoProto(name=name) for name in sorted(names - set(known)))
    session = onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])
    answers = zip([output.name for output in session.get_outputs()], session.run(None, inputs), strict=True)
    shapes = known | {name: answer.shape for name, answer in answers}
    return sum(int(np.prod(shapes[node.output[0]])) * shapes[node.input[1]][0] for node in products)


@pytest.mark.parametrize("category_name", ["bottle", "glasses"])
def test_every_product_is_counted(category_name: str) -> None:
    category, rotated = get_category(category_name), TINY.points // 4
    coordinate_net, rotation_net = networks_of(category_name)
    clouds = made_up_clouds(category.num_parts, TINY)
    inputs = feed(clouds, [build_neighborhoods(cloud, TINY) for cloud in clouds])
    inputs["nearest1"] = inputs["nearest1"][:, :rotated]
    found = counted(rotation_model(rotation_net, "float32"), inputs)
    (cloud, *_) = clouds
    found += counted(coordinate_model(coordinate_net, "float32"), feed(cloud[None], [build_neighborhoods(cloud, TINY)]))
    assert multiply_adds(category, TINY, rotated) == found

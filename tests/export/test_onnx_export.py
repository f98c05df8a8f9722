import zlib
from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import onnx
import onnxruntime
import pytest
import torch
from hypothesis import given
from hypothesis.extra.numpy import arrays
from onnx import TensorProto, numpy_helper

from captra.categories import get_category
from captra.learn.networks import TorchNetworks
from captra.learn.pointnet2 import NormalizedLinear
from captra.runtime.onnx_networks import OnnxNetworks, feed
from captra.sampling import PAPER, REALTIME, Profile, build_neighborhoods
from export.graph import OPSET, GraphWriter, PrecisionError, tensor
from export.inputs import made_up_clouds
from export.layers import fold
from export.onnx_export import coordinate_model, rotation_model
from export.parity import compare
from tests.made_up import TINY, networks_of, write_bundle

ALLOWED = {
    "Add", "Cast", "Concat", "Div", "Expand", "Gather", "Gemm", "MatMul", "Mul", "ReduceMax", "ReduceMean", "ReduceSum",
    "Relu", "Reshape", "Shape", "Sigmoid", "Slice", "Softmax", "Sqrt", "Split", "Sub", "Transpose", "Unsqueeze",
}  # fmt: skip


@pytest.mark.parametrize("profile", [PAPER, REALTIME, TINY], ids=lambda profile: profile.name)
@pytest.mark.parametrize("category", ["bottle", "mug", "glasses"])
def test_onnx_runtime_computes_what_pytorch_does(category: str, profile: Profile, tmp_path: Path) -> None:
    exported = OnnxNetworks.load(write_bundle(category, tmp_path / category, "float32"), profile, "cpu", threads=1)
    difference = compare(TorchNetworks(get_category(category), profile, *networks_of(category)), exported)
    assert difference.segmentation < 1e-5
    assert difference.coordinates < 1e-5
    assert difference.point_rotation < 1e-3
    assert difference.mean_rotation_deg < 1e-2


@pytest.mark.parametrize("profile", [REALTIME, TINY], ids=lambda profile: profile.name)
@pytest.mark.parametrize("category", ["bottle", "glasses"])
def test_rotations_of_the_first_points_alone(category: str, profile: Profile, tmp_path: Path) -> None:
    bundle = write_bundle(category, tmp_path / category, "float32", rotation_share=0.25)
    exported = OnnxNetworks.load(bundle, profile, "cpu", threads=1)
    torch_networks = TorchNetworks(get_category(category), profile, *networks_of(category), rotation_share=0.25)
    clouds = made_up_clouds(exported.category.num_parts, profile)
    neighborhoods = [build_neighborhoods(cloud, profile) for cloud in clouds]
    assert exported.rotations(clouds, neighborhoods).shape[:2] == (len(clouds), profile.points // 4)
    difference = compare(torch_networks, exported)
    assert difference.point_rotation < 1e-3
    assert difference.mean_rotation_deg < 1e-2


def test_one_graph_takes_any_profile() -> None:
    model = rotation_model(networks_of("scissors")[1], "float32")
    session = onnxruntime.InferenceSession(model.SerializeToString(), providers=["CPUExecutionProvider"])
    for profile in (TINY, Profile("odd", 131, (40, 11), ((3, 4, 9), (2, 7)))):
        clouds = made_up_clouds(2, profile)
        (raw,) = session.run(None, feed(clouds, [build_neighborhoods(cloud, profile) for cloud in clouds]))
        assert raw.shape == (2, profile.points, 6)


def test_inputs_and_outputs_have_the_agreed_names_and_types() -> None:
    coordinate_net, rotation_net = networks_of("laptop_articulated")
    names = ["points", "group1_0", "group1_1", "group1_2", "group2_0", "group2_1", "nearest1", "nearest2"]
    for model, parts in (
        (coordinate_model(coordinate_net, "float16"), 1),
        (rotation_model(rotation_net, "float16"), 2),
    ):
        inputs = {entry.name: entry.type.tensor_type for entry in model.graph.input}
        assert list(inputs) == names
        assert inputs.pop("points").elem_type == TensorProto.FLOAT
        assert {entry.elem_type for entry in inputs.values()} == {TensorProto.INT32}
        assert {entry.shape.dim[0].dim_value for entry in inputs.values()} == {parts}
        assert model.opset_import[0].version == OPSET
        assert {node.op_type for node in model.graph.node} <= ALLOWED
    assert [entry.name for entry in coordinate_model(coordinate_net, "float32").graph.output] == [
        "segmentation",
        "coordinates",
    ]
    assert [entry.name for entry in rotation_model(rotation_net, "float32").graph.output] == ["rotation"]


def test_float16_weights_take_half_the_room_and_are_cast_back() -> None:
    network = networks_of("mug")[0]
    halves, singles = (coordinate_model(network, precision) for precision in ("float16", "float32"))
    matrices = [entry for entry in halves.graph.initializer if entry.name.endswith("weight")]
    assert matrices
    assert {entry.data_type for entry in matrices} == {TensorProto.FLOAT16}
    assert all(entry.data_type != TensorProto.FLOAT16 for entry in singles.graph.initializer)
    assert halves.ByteSize() < 0.55 * singles.ByteSize()


def test_float16_weights_answer_nearly_the_same(tmp_path: Path) -> None:
    exported = OnnxNetworks.load(write_bundle("mug", tmp_path / "mug", "float16"), REALTIME, "cpu", threads=1)
    difference = compare(TorchNetworks(get_category("mug"), REALTIME, *networks_of("mug")), exported)
    assert 0 < difference.coordinates < 5e-3
    assert difference.segmentation < 5e-3
    assert difference.mean_rotation_deg < 0.5


def test_int8_weights_take_a_quarter_of_the_room_and_answer_nearly_the_same(tmp_path: Path) -> None:
    eighths, singles = (rotation_model(networks_of("mug")[1], precision) for precision in ("int8", "float32"))
    assert eighths.ByteSize() < 0.3 * singles.ByteSize()
    exported = OnnxNetworks.load(write_bundle("mug", tmp_path / "mug", "int8"), REALTIME, "cpu", threads=1)
    difference = compare(TorchNetworks(get_category("mug"), REALTIME, *networks_of("mug")), exported)
    assert 0 < difference.coordinates < 2e-2
    assert difference.mean_rotation_deg < 1.0


def test_fewer_bits_take_less_room_once_they_are_compressed() -> None:
    packed = [
        len(zlib.compress(coordinate_model(networks_of("mug")[0], precision).SerializeToString()))
        for precision in ("int8", "int6", "int5", "int4", "int3")
    ]
    assert packed[1] < 0.85 * packed[0]
    assert packed[2] < 0.75 * packed[0]
    assert packed[3] < 0.65 * packed[0]
    assert packed[4] < 0.5 * packed[0]


@pytest.mark.parametrize(
    ("precision", "largest"), [("int8", 127), ("int6", 31), ("int5", 15), ("int4", 7), ("int3", 3)]
)
@given(values=arrays(np.float32, (16, 3), elements=st.floats(-100, 100, width=32)))
def test_whole_columns_keep_their_largest_weight_and_miss_the_others_by_half_a_step(
    precision: str, largest: int, values: np.ndarray
) -> None:
    writer = GraphWriter(precision)
    writer("MatMul", "x", writer.matrix("w", values), name="y")
    shapes = tensor("x", TensorProto.FLOAT, 1, 16), tensor("y", TensorProto.FLOAT, 1, 3)
    constants = {
        c.name: numpy_helper.to_array(c) for c in writer.model("one", shapes[:1], shapes[1:]).graph.initializer
    }
    assert constants["w"].dtype == np.int8
    assert np.abs(constants["w"]).max() <= largest
    step = np.abs(values.astype(float)).max(axis=0) / largest
    assert (np.abs(constants["w"] * constants["w.scale"].astype(float) - values) <= 0.501 * step + 1e-30).all()


def test_weights_too_large_for_float16_are_refused() -> None:
    network = networks_of("mug")[0]
    with torch.no_grad():
        network.segmentation.weight[0, 0] = 1e5
    with pytest.raises(PrecisionError, match=r"segmentation\.weight does not fit into float16.*--precision float32"):
        coordinate_model(network, "float16")


def test_an_unknown_precision_is_refused() -> None:
    with pytest.raises(
        PrecisionError, match="unknown precision 'int2': choose one of float32, float16, int8, int6, int5, int4, int3"
    ):
        coordinate_model(networks_of("mug")[0], "int2")


def test_folding_keeps_what_a_layer_computes() -> None:
    torch.manual_seed(0)
    layer = NormalizedLinear(5, 4).eval()
    assert layer.norm.running_mean is not None
    assert layer.norm.running_var is not None
    layer.norm.running_mean.normal_()
    layer.norm.running_var.uniform_(0.5, 2)
    rows = torch.randn(7, 5)
    matrix, bias = fold(layer)
    with torch.inference_mode():
        expected = layer(rows).numpy()
    np.testing.assert_allclose(np.maximum(rows.numpy() @ matrix + bias, 0), expected, atol=1e-5)


def test_constants_are_stored_once() -> None:
    model = rotation_model(networks_of("drawers")[1], "float16")
    names = [entry.name for entry in model.graph.initializer]
    assert len(names) == len(set(names))
    sizes = [numpy_helper.to_array(entry).size for entry in model.graph.initializer]
    parameters = sum(p.numel() for p in networks_of("drawers")[1].parameters())
    assert sum(sizes) < 1.05 * parameters
    onnx.checker.check_model(model, full_check=True)

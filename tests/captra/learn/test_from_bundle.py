from pathlib import Path

import pytest
import torch
from torch import nn

from captra.categories import get_category
from captra.learn.checkpoint import CheckpointError
from captra.learn.from_bundle import ROW_NORM, coordinate_net_of_graph, restore_norms, rotation_net_of_graph
from captra.learn.pointnet2 import NormalizedLinear
from tests.made_up import batch_of_clouds, networks_of, write_bundle

CATEGORIES = ["bottle", "mug", "laptop_articulated"]


def answers(network: nn.Module, category: str) -> list[torch.Tensor]:
    parts = get_category(category).num_parts
    points, neighborhoods = batch_of_clouds(4 * parts, 1)
    with torch.no_grad():
        if "heads.0.output.bias" in network.state_dict():
            return [network(points.unflatten(0, (4, parts)), neighborhoods)]
        return list(network(points, neighborhoods))


def both(bundle: Path, category: str) -> list[nn.Module]:
    chosen = get_category(category)
    return [
        coordinate_net_of_graph(bundle / "coordinate.onnx", chosen),
        rotation_net_of_graph(bundle / "rotation.onnx", chosen),
    ]


@pytest.mark.parametrize("category", CATEGORIES)
def test_networks_of_a_bundle_answer_like_those_that_were_exported(category: str, tmp_path: Path) -> None:
    bundle = write_bundle(category, tmp_path / category, "float32")
    for original, read in zip(networks_of(category), both(bundle, category), strict=True):
        torch.testing.assert_close(answers(read, category), answers(original, category), rtol=1e-3, atol=1e-4)


def test_weights_of_8_bits_are_read_with_their_scales(tmp_path: Path) -> None:
    whole, half = (both(write_bundle("mug", tmp_path / name, name), "mug") for name in ("int8", "float16"))
    for read, expected in zip(whole, half, strict=True):
        for name, values in read.state_dict().items():
            step = expected.state_dict()[name].abs().max() / 127
            torch.testing.assert_close(values, expected.state_dict()[name], rtol=0, atol=float(step) + 1e-6, msg=name)


@pytest.mark.parametrize("category", CATEGORIES)
def test_restored_norms_change_no_answer_before_or_during_training(category: str, tmp_path: Path) -> None:
    bundle = write_bundle(category, tmp_path / category, "float32")
    for network in both(bundle, category):
        before = answers(network, category)
        restore_norms(network, lambda network=network: answers(network, category))  # type: ignore[misc]
        torch.testing.assert_close(answers(network, category), before, rtol=1e-3, atol=1e-3)
        torch.testing.assert_close(answers(network.train(), category), before, rtol=1e-2, atol=1e-2)
        for layer in network.modules():
            if isinstance(layer, NormalizedLinear):
                torch.testing.assert_close(layer.weight.norm(dim=1), torch.full((len(layer.weight),), ROW_NORM))


def test_a_bundle_of_another_category_is_refused_with_a_way_out(tmp_path: Path) -> None:
    bundle = write_bundle("laptop_articulated", tmp_path / "mug")
    with pytest.raises(CheckpointError, match="not the CoordinateNet of mug: give the bundle"):
        coordinate_net_of_graph(bundle / "coordinate.onnx", get_category("mug"))
    with pytest.raises(CheckpointError, match="not the RotationNet of bottle: give the bundle"):
        rotation_net_of_graph(bundle / "rotation.onnx", get_category("bottle"))


def test_what_is_no_graph_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CheckpointError, match="does not exist"):
        coordinate_net_of_graph(tmp_path / "coordinate.onnx", get_category("mug"))
    (tmp_path / "rotation.onnx").write_bytes(b"no graph")
    with pytest.raises(CheckpointError, match="no readable graph"):
        rotation_net_of_graph(tmp_path / "rotation.onnx", get_category("mug"))

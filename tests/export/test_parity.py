from dataclasses import replace
from pathlib import Path

import pytest
import torch

from captra.categories import get_category
from captra.learn.networks import TorchNetworks
from captra.runtime.onnx_networks import OnnxNetworks
from export.parity import TOLERANCES, ParityError, compare, require_parity
from tests.made_up import TINY, networks_of, write_bundle

MUG = get_category("mug")


def test_equal_networks_do_not_differ() -> None:
    networks = TorchNetworks(MUG, TINY, *networks_of("mug"))
    difference = compare(networks, networks)
    assert difference == replace(difference, segmentation=0.0, coordinates=0.0, point_rotation=0.0)
    assert difference.mean_rotation_deg < 1e-5


def test_a_graph_of_other_weights_is_caught(tmp_path: Path) -> None:
    exported = OnnxNetworks.load(write_bundle("mug", tmp_path / "mug", "float32"), TINY, "cpu", threads=1)
    coordinate_net, rotation_net = networks_of("mug")
    networks = TorchNetworks(MUG, TINY, coordinate_net, rotation_net)
    require_parity(networks, exported, "float32")
    with torch.no_grad():
        coordinate_net.backbone.last.weight[:, 3] += 0.1
    with pytest.raises(ParityError, match="disagree at profile tiny"):
        require_parity(networks, exported, "float32")


def test_tolerances_grow_with_rounding() -> None:
    assert TOLERANCES["float32"].within(TOLERANCES["float16"])
    assert not TOLERANCES["float16"].within(TOLERANCES["float32"])

"""Trainable networks from the graphs of a bundle: what ships is also what further training starts from.

An exported layer is one matrix and one bias; its batch norm was folded into them. Statistics measured anew on training
batches give the norm back such that the layer computes what it did, in training as well as after.
"""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import cast

import numpy as np
import torch
from torch import Tensor, nn

from captra.categories import Category
from captra.learn.checkpoint import CheckpointError
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.pointnet2 import Backbone, FeaturePropagation, NormalizedLinear, PointwiseMlp, SetAbstraction
from captra.learn.rotation_net import RotationHead, RotationNet

ROW_NORM = 0.6
"""Length of the weights of one channel, as in networks trained from nothing: with a norm after it, any computes the
same, but steps of the optimizers have a size of their own."""

SCALE = ".scale"
"""Ends the name of what whole numbers are multiplied by, column by column."""

Weights = Mapping[str, Tensor]
"""Constants of a graph by name; matrices are (inputs, outputs)."""


def coordinate_net_of_graph(path: Path, category: Category) -> CoordinateNet:
    """CoordinateNet with the weights of an exported graph, in evaluation mode; its norms only add the biases.

    Raises:
        CheckpointError: the graph is not the CoordinateNet of the category.
    """
    network = CoordinateNet(category.num_parts, category.num_classes)
    weights = _weights_of(path)
    try:
        _fill_backbone(network.backbone, weights)
        _fill_linear(network.segmentation, weights, "segmentation")
        _fill_normalized(network.hidden, weights, "hidden")
        _fill_linear(network.coordinates, weights, "coordinates")
    except (KeyError, RuntimeError) as error:
        raise _misfit(path, f"the CoordinateNet of {category.name}") from error
    return network.eval()


def rotation_net_of_graph(path: Path, category: Category) -> RotationNet:
    """RotationNet with the weights of an exported graph, in evaluation mode; its norms only add the biases.

    Raises:
        CheckpointError: the graph is not the RotationNet of the category.
    """
    network = RotationNet(category.num_parts, category.symmetric)
    weights = _weights_of(path)
    try:
        _fill_backbone(network.backbone, weights)
        for part, head in enumerate(cast("Iterable[RotationHead]", network.heads)):
            for i, (layer, norm) in enumerate(head.blocks):
                _fill_linear(layer, weights, f"heads.{part}.{i}")
                _copy(norm.weight, weights[f"heads.{part}.{i}.norm.weight"][0])
                _copy(norm.bias, weights[f"heads.{part}.{i}.norm.bias"][0])
            _fill_linear(head.output, weights, f"heads.{part}.output")
    except (KeyError, RuntimeError) as error:
        raise _misfit(path, f"the RotationNet of {category.name}") from error
    return network.eval()


@torch.no_grad()
def restore_norms(network: nn.Module, run: Callable[[], object]) -> None:
    """Give the norms of a network that came from a graph the statistics of what `run` shows them.

    With mean m and variance v of a channel, √(v + ε) as its weight and its bias plus m compute what the bias alone
    did. The channel's row of weights then takes the length that rows have in training.

    Args:
        network: in evaluation mode; answers the same afterwards.
        run: calls it on batches that are like those to come.
    """
    layers = [module for module in network.modules() if isinstance(module, NormalizedLinear)]
    moments = {layer.norm: _Moments(layer.norm.num_features) for layer in layers}
    hooks = [norm.register_forward_pre_hook(lambda norm, inputs: moments[norm].add(inputs[0])) for norm in moments]
    try:
        run()
    finally:
        for hook in hooks:
            hook.remove()
    for layer in layers:
        length = layer.weight.norm(dim=1).clamp(min=1e-6) / ROW_NORM
        mean, variance = moments[layer.norm].mean_and_variance()
        layer.weight.div_(length[:, None])
        norm = layer.norm
        _copy(cast("Tensor", norm.running_mean), mean / length)
        _copy(cast("Tensor", norm.running_var), variance / length.square())
        _copy(norm.bias, norm.bias + mean)
        _copy(norm.weight, length * (cast("Tensor", norm.running_var) + norm.eps).sqrt())


class _Moments:
    """Sums over rows, from which mean and variance follow."""

    def __init__(self, channels: int) -> None:
        self._count = 0
        self._sum = torch.zeros(channels, dtype=torch.float64)
        self._sum_squared = torch.zeros(channels, dtype=torch.float64)

    def add(self, rows: Tensor) -> None:
        self._count += len(rows)
        self._sum += rows.double().sum(dim=0)
        self._sum_squared += rows.double().square().sum(dim=0)

    def mean_and_variance(self) -> tuple[Tensor, Tensor]:
        mean = self._sum / self._count
        return mean.float(), (self._sum_squared / self._count - mean.square()).clamp(min=0).float()


def _weights_of(path: Path) -> Weights:
    import onnx
    from google.protobuf.message import DecodeError

    try:
        graph = onnx.load(path).graph
    except FileNotFoundError:
        raise CheckpointError(f"{path} does not exist: give the folder of a bundle, e.g. models/mug") from None
    except DecodeError as error:
        raise CheckpointError(f"{path} is no readable graph: export the bundle again, or copy it again") from error
    weights = {
        constant.name: torch.from_numpy(onnx.numpy_helper.to_array(constant).astype(np.float32))
        for constant in graph.initializer
    }
    return {name: values * weights.get(f"{name}{SCALE}", 1.0) for name, values in weights.items()}


def _misfit(path: Path, wanted: str) -> CheckpointError:
    return CheckpointError(f"{path} is not {wanted}: give the bundle of the category that its folder is named after")


def _fill_backbone(backbone: Backbone, weights: Weights) -> None:
    for level in ("level1", "level2"):
        abstraction = cast("SetAbstraction", getattr(backbone, level))
        for scale, mlp in enumerate(cast("Iterable[PointwiseMlp]", abstraction.scales)):
            _fill_mlp(mlp, weights, f"{level}.{scale}")
    _fill_mlp(backbone.level3.layers, weights, "level3")
    for name in ("up3", "up2", "up1"):
        _fill_mlp(cast("FeaturePropagation", getattr(backbone, name)).layers, weights, name)
    _fill_normalized(backbone.last, weights, "last")


def _fill_mlp(mlp: PointwiseMlp, weights: Weights, name: str) -> None:
    """First layers that the graph computes in two products are put together again."""
    halves = (f"{name}.0.features", f"{name}.0.relative"), (f"{name}.0.weight", f"{name}.coarse")
    joined = {f"{name}.0.weight": torch.cat([weights[a], weights[b]]) for a, b in halves if b in weights}
    for i, layer in enumerate(mlp.layers):
        _fill_normalized(layer, {**weights, **joined}, f"{name}.{i}")


@torch.no_grad()
def _fill_normalized(layer: NormalizedLinear, weights: Weights, name: str) -> None:
    _copy(layer.weight, weights[f"{name}.weight"].T)
    _copy(layer.norm.bias, weights[f"{name}.bias"])
    layer.norm.weight.fill_(1.0)
    cast("Tensor", layer.norm.running_mean).zero_()
    cast("Tensor", layer.norm.running_var).fill_(1.0 - layer.norm.eps)


def _fill_linear(layer: nn.Linear, weights: Weights, name: str) -> None:
    _copy(layer.weight, weights[f"{name}.weight"].T)
    _copy(layer.bias, weights[f"{name}.bias"])


@torch.no_grad()
def _copy(target: Tensor, source: Tensor) -> None:
    if target.shape != source.shape:
        raise RuntimeError(f"{tuple(source.shape)} instead of {tuple(target.shape)}")
    target.copy_(source)

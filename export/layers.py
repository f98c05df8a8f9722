"""PyTorch layers as nodes: batch norm folded into the product before it, rows of channels throughout."""

import numpy as np
from jaxtyping import Float64
from torch import Tensor, nn

from captra.learn.pointnet2 import NormalizedLinear
from captra.learn.rotation_net import CHANNELS_PER_GROUP, CloudNorm
from export.graph import GraphWriter

Matrix = Float64[np.ndarray, "inputs outputs"]
Vector = Float64[np.ndarray, " outputs"]


def array(parameter: Tensor) -> np.ndarray:
    """A parameter as float64."""
    return parameter.detach().double().numpy()


def fold(layer: NormalizedLinear) -> tuple[Matrix, Vector]:
    """Matrix (inputs, outputs) and bias that compute the layer's product and norm with its running statistics."""
    norm = layer.norm
    assert norm.running_mean is not None
    assert norm.running_var is not None
    scale = array(norm.weight) / np.sqrt(array(norm.running_var) + norm.eps)
    return (array(layer.weight) * scale[:, None]).T, array(norm.bias) - array(norm.running_mean) * scale


def affine(g: GraphWriter, rows: str, matrix: Matrix, bias: Vector, name: str) -> str:
    """Product and bias."""
    return g("Gemm", rows, g.matrix(f"{name}.weight", matrix), g.vector(f"{name}.bias", bias))


def linear(g: GraphWriter, rows: str, layer: nn.Linear, name: str) -> str:
    """A layer without norm or activation."""
    return affine(g, rows, array(layer.weight).T, array(layer.bias), name)


def normalized(g: GraphWriter, rows: str, layer: NormalizedLinear, name: str) -> str:
    """Product, norm, ReLU."""
    return g("Relu", affine(g, rows, *fold(layer), name))


def normalized_maximum(g: GraphWriter, rows: str, layer: NormalizedLinear, size: str, name: str) -> str:
    """Product, norm, ReLU and the maximum of each `size` rows; bias and ReLU follow the maximum, on fewer rows."""
    matrix, bias = fold(layer)
    product = g("MatMul", rows, g.matrix(f"{name}.weight", matrix))
    groups = g("Reshape", product, g("Concat", g.integers(-1), size, g.integers(len(bias)), axis=0))
    largest = g("ReduceMax", groups, axes=[1], keepdims=0)
    return g("Relu", g("Add", largest, g.vector(f"{name}.bias", bias)))


def cloud_norm(g: GraphWriter, rows: str, norm: CloudNorm, name: str) -> str:
    """Group norm over all rows, then ReLU; deviations are squared after centring, which low precision survives."""
    centred = g("Sub", rows, _group_mean(g, rows, len(norm.weight)))
    variance = _group_mean(g, g("Mul", centred, centred), len(norm.weight))
    deviation = g("Sqrt", g("Add", variance, g.number(norm.eps)))
    scale = g("Div", g.vector(f"{name}.weight", array(norm.weight)[None]), deviation)
    return g("Relu", g("Add", g("Mul", centred, scale), g.vector(f"{name}.bias", array(norm.bias)[None])))


def _group_mean(g: GraphWriter, rows: str, channels: int) -> str:
    """Mean over all rows and each group's channels, given to every channel of the group: (1, channels)."""
    pairs = (channels // CHANNELS_PER_GROUP, CHANNELS_PER_GROUP)
    means = g("Reshape", g("ReduceMean", rows, axes=[0], keepdims=1), g.integers(*pairs))
    spread = g("Expand", g("ReduceMean", means, axes=[1], keepdims=1), g.integers(*pairs))
    return g("Reshape", spread, g.integers(1, channels))

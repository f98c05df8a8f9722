"""The networks as ONNX graphs of gathers, matrix products and maxima, written from their weights.

Clouds of several parts are stacked into one set of rows, so every weight is used once a frame. In the first level the
product follows grouping: three or six inputs cost nothing, and differences to the centroid come before low precision.
In the second level it runs before (`captra.learn.pointnet2`).
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
import onnx
from onnx import TensorProto

from captra.architecture import FEATURES, XYZ
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.pointnet2 import (
    Backbone,
    FeaturePropagation,
    GlobalAbstraction,
    PointwiseMlp,
    SetAbstraction,
)
from captra.learn.rotation_net import RotationHead, RotationNet
from export.graph import GraphWriter, tensor
from export.layers import Matrix, affine, cloud_norm, fold, linear, normalized, normalized_maximum
from export.rounding import NEAREST, Rounding

PIECES = 4
"""Groups of each cloud are worked through in so many pieces."""

GROUPS1 = ("group1_0", "group1_1", "group1_2")
GROUPS2 = ("group2_0", "group2_1")


def coordinate_model(network: CoordinateNet, precision: str, rounding: Rounding = NEAREST) -> onnx.ModelProto:
    """CoordinateNet for one cloud: outputs `segmentation` (1, C, N), softmax, and `coordinates` (1, P, N, 3).

    Raises:
        PrecisionError: the precision is unknown or too narrow.
    """
    g = GraphWriter(precision, rounding)
    rows = _BackboneWriter(g, 1).write(network.backbone)
    probabilities = g("Softmax", linear(g, rows, network.segmentation, "segmentation"), axis=-1)
    g("Unsqueeze", g("Transpose", probabilities, perm=[1, 0]), g.integers(0), name="segmentation")
    hidden = normalized(g, rows, network.hidden, "hidden")
    raw = g("Sigmoid", linear(g, hidden, network.coordinates, "coordinates"))
    by_part = g("Reshape", g("Sub", raw, g.number(0.5)), g.integers(1, -1, network.num_parts, XYZ))
    g("Transpose", by_part, perm=[0, 2, 1, 3], name="coordinates")
    outputs = [
        tensor("segmentation", TensorProto.FLOAT, 1, network.segmentation.out_features, "N"),
        tensor("coordinates", TensorProto.FLOAT, 1, network.num_parts, "N", XYZ),
    ]
    return g.model("coordinate", _inputs(1, "N"), outputs)


def rotation_model(network: RotationNet, precision: str, rounding: Rounding = NEAREST) -> onnx.ModelProto:
    """RotationNet for the clouds of all parts: output `rotation` (P, H, 6), or 3 for symmetric objects.

    H is the number of rows that the input `nearest1` has: only the first H points of each cloud, which are farthest
    points of their own, get features and answers.

    Raises:
        PrecisionError: the precision is unknown or too narrow.
    """
    g = GraphWriter(precision, rounding)
    rows = _BackboneWriter(g, network.num_parts).write(network.backbone)
    clouds = g("Reshape", rows, g.integers(network.num_parts, -1, FEATURES))
    heads = cast("list[RotationHead]", list(network.heads))
    raw = []
    for j, head in enumerate(heads):
        hidden = g("Gather", clouds, g.index(j), axis=0)
        for i, (layer, norm) in enumerate(head.blocks):
            product = linear(g, hidden, layer, f"heads.{j}.{i}")
            hidden = cloud_norm(g, product, norm, f"heads.{j}.{i}.norm")
        raw.append(g("Unsqueeze", linear(g, hidden, head.output, f"heads.{j}.output"), g.integers(0)))
    g("Concat", *raw, axis=0, name="rotation")
    output = tensor("rotation", TensorProto.FLOAT, network.num_parts, "H", heads[0].output.out_features)
    return g.model("rotation", _inputs(network.num_parts, "H"), [output])


def _inputs(parts: int, answered: str) -> list[onnx.ValueInfoProto]:
    axes: dict[str, tuple[str, str | int]] = {
        **{name: ("M1", f"k1_{i}") for i, name in enumerate(GROUPS1)},
        **{name: ("M2", f"k2_{i}") for i, name in enumerate(GROUPS2)},
        "nearest1": (answered, 3),
        "nearest2": ("M1", 3),
    }
    indices = [tensor(name, TensorProto.INT32, parts, rows, width) for name, (rows, width) in axes.items()]
    return [tensor("points", TensorProto.FLOAT, parts, "N", XYZ), *indices]


@dataclass(frozen=True)
class _Level:
    """The points of one resolution: all of them, or the first ones of each cloud."""

    count: str
    """Points a cloud, a vector of one integer."""
    rows: str
    """Coordinates (parts · count, 3)."""
    centres: str
    """Coordinates (parts · count, 1, 3)."""


class _BackboneWriter:
    """Writes the backbone for the clouds of `parts` parts, stacked into rows."""

    def __init__(self, g: GraphWriter, parts: int) -> None:
        self._g = g
        self._parts = parts

    def write(self, backbone: Backbone) -> str:
        """From the graph's inputs to features (parts · rows of nearest1, 128)."""
        g = self._g
        level0 = self._level(self._axis("points", 1))
        level1 = self._level(self._axis(GROUPS1[0], 1))
        level2 = self._level(self._axis(GROUPS2[0], 1))
        answered = self._level(self._axis("nearest1", 1))
        features1 = self._abstraction(backbone.level1, "level1", level0, level1, None, GROUPS1)
        features2 = self._abstraction(backbone.level2, "level2", level1, level2, features1, GROUPS2)
        overall = self._overall(backbone.level3, level2, features2)

        def repeated(matrix: Matrix) -> str:
            return self._repeat(g("MatMul", overall, g.matrix("up3.coarse", matrix)), level2.count, matrix.shape[1])

        def from_level2(matrix: Matrix) -> str:
            product = g("MatMul", up3, g.matrix("up2.coarse", matrix))
            return self._interpolate(product, "nearest2", level1, level2)

        def from_level1(matrix: Matrix) -> str:
            product = g("MatMul", up2, g.matrix("up1.coarse", matrix))
            return self._interpolate(product, "nearest1", answered, level1)

        up3 = self._propagation(backbone.up3, "up3", features2, repeated)
        up2 = self._propagation(backbone.up2, "up2", features1, from_level2)
        up1 = self._propagation(backbone.up1, "up1", answered.rows, from_level1)
        return normalized(g, up1, backbone.last, "last")

    def _axis(self, value: str, axis: int) -> str:
        return self._g("Slice", self._g("Shape", value), self._g.integers(axis), self._g.integers(axis + 1))

    def _level(self, count: str) -> _Level:
        g = self._g
        prefix = g("Slice", "points", g.integers(0), count, g.integers(1))
        return _Level(count, g("Reshape", prefix, g.integers(-1, XYZ)), g("Reshape", prefix, g.integers(-1, 1, XYZ)))

    def _row_index(self, index: str, source: _Level, width: str) -> str:
        """Indices into each cloud → indices into the rows of all clouds, (rows, width)."""
        g = self._g
        if self._parts > 1:
            starts = g("Mul", g.offsets(self._parts), g("Cast", source.count, to=TensorProto.INT32))
            index = g("Add", index, starts)
        return g("Reshape", index, g("Concat", g.integers(-1), width, axis=0))

    def _abstraction(
        self,
        abstraction: SetAbstraction,
        name: str,
        source: _Level,
        target: _Level,
        features: str | None,
        groups: Sequence[str],
    ) -> str:
        g = self._g
        maxima = []
        for i, (mlp, group) in enumerate(
            zip(cast("list[PointwiseMlp]", list(abstraction.scales)), groups, strict=True)
        ):
            size = self._axis(group, 2)
            index = self._row_index(group, source, size)
            scale = f"{name}.{i}"
            if features is None:
                hidden = self._after_grouping(mlp, scale, source, target, index, positions=abstraction.positions)
            else:
                hidden = self._before_grouping(mlp, scale, source, target, index, features)
            *middle, last = list(enumerate(mlp.layers))[1:]
            pieces = []
            for first in hidden:
                activations = first
                for j, layer in middle:
                    activations = normalized(g, activations, layer, f"{scale}.{j}")
                pieces.append(normalized_maximum(g, activations, last[1], size, f"{scale}.{last[0]}"))
            maxima.append(g("Concat", *pieces, axis=0))
        return g("Concat", *maxima, axis=1)

    def _after_grouping(
        self, mlp: PointwiseMlp, name: str, source: _Level, target: _Level, index: str, *, positions: bool
    ) -> list[str]:
        g = self._g
        matrix, bias = fold(mlp.layers[0])
        rows, centres = source.rows, target.centres
        if positions:
            only_centred = g.vector("positions.centred", np.repeat([0.0, 1.0], XYZ))
            rows = g("Concat", rows, rows, axis=1)
            centres = g("Mul", g("Concat", centres, centres, axis=2), only_centred)

        def first_layer(index: str, centres: str) -> str:
            inputs = g("Reshape", g("Sub", g("Gather", rows, index, axis=0), centres), g.integers(-1, len(matrix)))
            return g("Relu", affine(g, inputs, matrix, bias, f"{name}.0"))

        return [first_layer(*piece) for piece in self._pieces(index, centres)]

    def _before_grouping(
        self, mlp: PointwiseMlp, name: str, source: _Level, target: _Level, index: str, features: str
    ) -> list[str]:
        g = self._g
        matrix, bias = fold(mlp.layers[0])
        relative = g.matrix(f"{name}.0.relative", matrix[-XYZ:])
        of_features = g("MatMul", features, g.matrix(f"{name}.0.features", matrix[:-XYZ]))
        at_points = g("Add", of_features, g("MatMul", source.rows, relative))
        at_centres = g("Sub", g("MatMul", target.centres, relative), g.vector(f"{name}.0.bias", bias))

        def first_layer(index: str, at_centres: str) -> str:
            grouped = g("Sub", g("Gather", at_points, index, axis=0), at_centres)
            return g("Relu", g("Reshape", grouped, g.integers(-1, len(bias))))

        return [first_layer(*piece) for piece in self._pieces(index, at_centres)]

    def _pieces(self, *by_centre: str) -> Iterator[tuple[str, ...]]:
        """Values with a row for each centre in pieces that fit the processor's cache, for one to follow the other."""
        pieces = PIECES * self._parts
        return zip(*(self._g.split(value, pieces) for value in by_centre), strict=True)

    def _overall(self, abstraction: GlobalAbstraction, level: _Level, features: str) -> str:
        g = self._g
        hidden = g("Concat", level.rows, features, axis=1)
        *middle, last = abstraction.layers.layers
        for i, layer in enumerate(middle):
            hidden = normalized(g, hidden, layer, f"level3.{i}")
        return normalized_maximum(g, hidden, last, level.count, f"level3.{len(middle)}")

    def _propagation(
        self, propagation: FeaturePropagation, name: str, skip: str, spread: Callable[[Matrix], str]
    ) -> str:
        """`spread` turns the matrix for the coarser features into their product, with a row for every finer point."""
        g = self._g
        first, *rest = propagation.layers.layers
        matrix, bias = fold(first)
        product = affine(g, skip, matrix[: propagation.skip], bias, f"{name}.0")
        hidden = g("Relu", g("Add", product, spread(matrix[propagation.skip :])))
        for i, layer in enumerate(rest, 1):
            hidden = normalized(g, hidden, layer, f"{name}.{i}")
        return hidden

    def _repeat(self, rows: str, count: str, channels: int) -> str:
        """One row a cloud → one a point."""
        g = self._g
        shape = g("Concat", g.integers(self._parts), count, g.integers(channels), axis=0)
        return g("Reshape", g("Expand", g("Unsqueeze", rows, g.integers(1)), shape), g.integers(-1, channels))

    def _interpolate(self, features: str, nearest: str, fine: _Level, coarse: _Level) -> str:
        """Mean of the three nearest rows, weighted by 1 / (squared distance + 1e-8)."""
        g = self._g
        index = self._row_index(nearest, coarse, g.integers(3))
        difference = g("Sub", fine.centres, g("Gather", coarse.rows, index, axis=0))
        squared = g("ReduceSum", g("Mul", difference, difference), g.integers(2))
        weight = g("Div", g.number(1), g("Add", squared, g.number(1e-8)))
        share = g("Div", weight, g("ReduceSum", weight, g.integers(1)))
        weighted = g("Mul", g("Gather", features, index, axis=0), share)
        return g("ReduceSum", weighted, g.integers(1), keepdims=0)

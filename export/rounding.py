"""Weights as whole numbers: the nearest ones, or such that the errors of a column's weights make up for each other."""

import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

import numpy as np
import onnx
from jaxtyping import Float64, Int8

from captra.runtime.onnx_networks import open_session
from captra.runtime.providers import CPU, choose_provider

LARGEST_WHOLE = MappingProxyType({"int8": 127, "int6": 31, "int5": 15, "int4": 7})
"""What the largest weight of a column becomes where weights are whole numbers. Each fills a byte: those with fewer bits
take less room once they are compressed, as by git. The number below the least is left unused, so that columns stay
symmetric."""

FEW_INPUTS = 16
"""Matrices with fewer rows, those of coordinates, take no room and keep eight bits."""

SMALLEST = 1e-30
"""Columns of weights smaller than that become nothing."""

DAMPING = 0.01
"""Share of the mean second moment that is added to each: inputs that were never seen together are not made up for."""

SHARES = np.linspace(0.5, 1.0, 26)
"""Of a column's largest weight, that may become the largest whole number: larger ones are cut to it."""

Matrix = Float64[np.ndarray, "inputs outputs"]
Feed = Mapping[str, np.ndarray]


@dataclass(frozen=True)
class Rounded:
    """A matrix of whole numbers times the scale of each column."""

    whole: Int8[np.ndarray, "inputs outputs"]
    """At most the largest whole number, either way."""
    scale: Float64[np.ndarray, " outputs"]
    """What one stands for."""


class Rounding(Protocol):
    """Chooses whole numbers for a matrix of weights."""

    def __call__(self, name: str, matrix: Matrix, largest: int) -> Rounded:
        """For the matrix that the graph calls `name`, none larger than `largest`."""


class Nearest:
    """Every weight by itself; the largest of a column becomes the largest whole number."""

    def __call__(
        self,
        name: str,  # noqa: ARG002 - asked for by the protocol
        matrix: Matrix,
        largest: int,
    ) -> Rounded:
        """The nearest ones."""
        scale = np.maximum(np.abs(matrix).max(axis=0), SMALLEST) / largest
        return Rounded(np.rint(matrix / scale).astype(np.int8), scale)


NEAREST: Rounding = Nearest()


@dataclass(frozen=True)
class Compensated:
    """What rounding one input's weights adds to the products is taken off by the weights of inputs that go with it.

    Weights are rounded input by input, those first that are largest in the mean; after each, the ones still to come
    take the values that change the products of seen inputs least (Frantar et al., GPTQ, 2023, equations 2 and 3).
    """

    second_moments: Mapping[str, Float64[np.ndarray, "inputs inputs"]]
    """By matrix: Σ x xᵀ of the inputs x that it is multiplied with, up to a factor; without, nearest ones are taken."""

    def __call__(self, name: str, matrix: Matrix, largest: int) -> Rounded:
        """Such that products with inputs like those seen change least."""
        if name not in self.second_moments:
            return NEAREST(name, matrix, largest)
        moment = self.second_moments[name]
        moment = moment + np.eye(len(matrix)) * (DAMPING * np.trace(moment) / len(matrix) + SMALLEST)
        order = np.argsort(-np.diag(moment))
        spread = np.linalg.cholesky(np.linalg.inv(moment[np.ix_(order, order)])).T
        scale = closest_scale(matrix, largest)
        left, whole = matrix[order], np.zeros_like(matrix)
        for i, row in enumerate(order):
            whole[row] = np.clip(np.rint(left[i] / scale), -largest, largest)
            error = (left[i] - whole[row] * scale) / spread[i, i]
            left[i + 1 :] -= np.outer(spread[i, i + 1 :], error)
        return Rounded(whole.astype(np.int8), scale)


def closest_scale(matrix: Matrix, largest: int) -> Float64[np.ndarray, " outputs"]:
    """The scale of each column at which the nearest whole numbers are closest to its weights, in the mean square."""
    peak = np.maximum(np.abs(matrix).max(axis=0), SMALLEST)
    scales = SHARES[:, None] * peak / largest
    errors = [((np.clip(np.rint(matrix / s), -largest, largest) * s - matrix) ** 2).sum(axis=0) for s in scales]
    return np.asarray(scales[np.argmin(errors, axis=0), np.arange(len(peak))])


def second_moments(model: onnx.ModelProto, feeds: Iterable[Feed]) -> dict[str, Float64[np.ndarray, "inputs inputs"]]:
    """Of the inputs of every product with a matrix, by the matrix's name, over the runs of a float32 graph."""
    matrices = {constant.name for constant in model.graph.initializer}
    products = [
        (node.input[1], node.input[0])
        for node in model.graph.node
        if node.op_type in ("Gemm", "MatMul") and node.input[1] in matrices
    ]
    names = sorted({rows for _, rows in products})
    session = _telling(model, names)
    sums: dict[str, Float64[np.ndarray, "inputs inputs"]] = {}
    for feed in feeds:
        values = dict(zip(names, session.run(names, dict(feed)), strict=True))
        for matrix, name in products:
            rows = values[name].reshape(-1, values[name].shape[-1])
            sums[matrix] = sums.get(matrix, 0.0) + (rows.T @ rows).astype(np.float64)
    return sums


def _telling(model: onnx.ModelProto, names: Iterable[str]) -> Any:
    """The graph ready to run, with values on the way among its outputs."""
    told = onnx.ModelProto()
    told.CopyFrom(model)
    told.graph.output.extend(onnx.ValueInfoProto(name=name) for name in names)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "told.onnx"
        onnx.save(told, path)
        return open_session(path, {}, choose_provider("cpu", 1, [CPU]), threads=1)

"""What a float32 graph does with the inputs that it is given: which products see what, and which have to be exact."""

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from jaxtyping import Float64
from onnx import numpy_helper

from captra.runtime.onnx_networks import open_session
from captra.runtime.providers import CPU, choose_provider
from export.rounding import LARGEST_WHOLE, SMALLEST, Compensated, Moments

Feed = Mapping[str, np.ndarray]

TRIED = LARGEST_WHOLE["int4"]
"""How finely a matrix is rounded to see what that does to the answers."""


def second_moments(model: onnx.ModelProto, feeds: Iterable[Feed]) -> dict[str, Moments]:
    """Of the inputs of every product with a matrix, by the matrix's name, over the runs of a float32 graph."""
    matrices = {constant.name for constant in model.graph.initializer}
    products = [
        (node.input[1], node.input[0])
        for node in model.graph.node
        if node.op_type in ("Gemm", "MatMul") and node.input[1] in matrices
    ]
    names = sorted({rows for _, rows in products})
    told = onnx.ModelProto()
    told.CopyFrom(model)
    told.graph.output.extend(onnx.ValueInfoProto(name=name) for name in names)
    session = _open(told)
    sums: dict[str, Moments] = {}
    for feed in feeds:
        values = dict(zip(names, session.run(names, dict(feed)), strict=True))
        for matrix, name in products:
            rows = values[name].reshape(-1, values[name].shape[-1])
            sums[matrix] = sums.get(matrix, 0.0) + (rows.T @ rows).astype(np.float64)
    return sums


def coarseness(model: onnx.ModelProto, moments: Mapping[str, Moments], feeds: Sequence[Feed]) -> dict[str, float]:
    """How much coarser or finer than at the precision asked for each matrix is to be rounded, by its name.

    A bit more for every weight of a matrix takes its part in the error of the answers to a quarter. In as many bits
    altogether that error is least where each matrix's part is in proportion to its weights, which these factors lead to
    (Lagrange); their mean over all weights is 1, geometrically.
    """
    exact = _answers(model, feeds)
    damage, weights = {}, {}
    for constant in model.graph.initializer:
        if constant.name in moments:
            matrix = numpy_helper.to_array(constant).astype(np.float64)
            rounded = Compensated(moments)(constant.name, matrix, TRIED).matrix
            tried = _answers(_with_matrix(model, constant.name, rounded), feeds)
            apart = sum(float(np.square(a - b).mean() / np.square(b).mean()) for a, b in zip(tried, exact, strict=True))
            damage[constant.name] = max(apart / matrix.size, SMALLEST)
            weights[constant.name] = matrix.size
    mean = np.average(np.log(list(damage.values())), weights=list(weights.values()))
    return {name: float(np.exp((mean - np.log(value)) / 2)) for name, value in damage.items()}


def _with_matrix(model: onnx.ModelProto, name: str, matrix: Float64[np.ndarray, "inputs outputs"]) -> onnx.ModelProto:
    changed = onnx.ModelProto()
    changed.CopyFrom(model)
    constant = next(constant for constant in changed.graph.initializer if constant.name == name)
    constant.CopyFrom(numpy_helper.from_array(matrix.astype(np.float32), name))
    return changed


def _answers(model: onnx.ModelProto, feeds: Sequence[Feed]) -> list[np.ndarray]:
    """Each output, over all feeds."""
    session, names = _open(model), [output.name for output in model.graph.output]
    return [np.stack(values) for values in zip(*(session.run(names, dict(feed)) for feed in feeds), strict=True)]


def _open(model: onnx.ModelProto) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.onnx"
        onnx.save(model, path)
        return open_session(path, {}, choose_provider("cpu", 1, [CPU]), threads=1)

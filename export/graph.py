"""Writing ONNX graphs node by node: values are names, and every node is named after its output."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
import onnx
from jaxtyping import Float
from onnx import TensorProto, helper, numpy_helper

from export.rounding import FEW_INPUTS, LARGEST_WHOLE, NEAREST, Rounding

OPSET = 17
"""The oldest with everything that the networks need, so that old runtimes load them."""

IR_VERSION = 8
"""The one that came with the opset."""

PRECISIONS: Mapping[str, type[np.number]] = MappingProxyType(
    {"float32": np.float32, "float16": np.float16, **dict.fromkeys(LARGEST_WHOLE, np.int8)}
)
"""How matrices are stored; arithmetic is float32 in any case, unless the runtime lowers it."""


class PrecisionError(ValueError):
    """The weights cannot be stored in the precision asked for."""


class GraphWriter:
    """Collects nodes and constants of one graph."""

    def __init__(self, precision: str, rounding: Rounding = NEAREST) -> None:
        if precision not in PRECISIONS:
            raise PrecisionError(f"unknown precision {precision!r}: choose one of {', '.join(PRECISIONS)}")
        self._matrix_type = PRECISIONS[precision]
        self._largest_whole = LARGEST_WHOLE.get(precision)
        self._rounding = rounding
        self._nodes: list[onnx.NodeProto] = []
        self._constants: dict[str, onnx.TensorProto] = {}

    def __call__(self, operator: str, *inputs: str, name: str = "", **attributes: Any) -> str:
        """Append a node and return the name of its only output."""
        output = name or f"{operator.lower()}_{len(self._nodes)}"
        self._nodes.append(helper.make_node(operator, list(inputs), [output], name=output, **attributes))
        return output

    def split(self, value: str, pieces: int) -> list[str]:
        """Pieces along the first axis, all equal but for the last one, which takes what is left over."""
        rows = self("Slice", self("Shape", value), self.integers(0), self.integers(1))
        piece = self("Div", rows, self.integers(pieces))
        last = self("Sub", rows, self("Mul", piece, self.integers(pieces - 1)))
        sizes = self("Concat", *[piece] * (pieces - 1), last, axis=0)
        name = f"split_{len(self._nodes)}"
        outputs = [f"{name}.{i}" for i in range(pieces)]
        self._nodes.append(helper.make_node("Split", [value, sizes], outputs, name=name, axis=0))
        return outputs

    def matrix(self, name: str, values: Float[np.ndarray, "inputs outputs"]) -> str:
        """A matrix of weights, stored in the graph's precision and turned to float32, once, when the model is loaded.

        Whole numbers come with the scale of their column, `{name}.scale`.

        Raises:
            PrecisionError: a weight is too large for the precision.
        """
        turned = f"{name}.float32"
        if name in self._constants:
            return name if self._matrix_type is np.float32 else turned
        if self._largest_whole is not None:
            largest = self._largest_whole if len(values) >= FEW_INPUTS else LARGEST_WHOLE["int8"]
            rounded = self._rounding(name, values.astype(np.float64), largest)
            whole = self("Cast", self._constant(name, rounded.whole), name=f"{name}.whole", to=TensorProto.FLOAT)
            return self("Mul", whole, self.vector(f"{name}.scale", rounded.scale), name=turned)
        with np.errstate(over="ignore"):
            stored = values.astype(self._matrix_type)
        if not np.isfinite(stored).all():
            raise PrecisionError(f"{name} does not fit into {stored.dtype}: export with --precision float32")
        constant = self._constant(name, stored)
        return constant if stored.dtype == np.float32 else self("Cast", constant, name=turned, to=TensorProto.FLOAT)

    def vector(self, name: str, values: Float[np.ndarray, "..."]) -> str:
        """Biases and the like, always float32."""
        return self._constant(name, values.astype(np.float32))

    def number(self, value: float) -> str:
        """A float32 scalar."""
        return self._constant(f"float.{value:g}", np.array(value, np.float32))

    def index(self, value: int) -> str:
        """An int64 scalar."""
        return self._constant(f"int.{value}", np.array(value, np.int64))

    def integers(self, *values: int) -> str:
        """A vector of int64, for shapes and axes."""
        return self._constant("ints." + ".".join(str(value) for value in values), np.array(values, np.int64))

    def offsets(self, parts: int) -> str:
        """0, 1, 2 … as int32 (parts, 1, 1)."""
        return self._constant(f"parts.{parts}", np.arange(parts, dtype=np.int32).reshape(parts, 1, 1))

    def _constant(self, name: str, values: np.ndarray) -> str:
        if name not in self._constants:
            self._constants[name] = numpy_helper.from_array(np.asarray(values, order="C"), name)
        return name

    def model(
        self, name: str, inputs: Sequence[onnx.ValueInfoProto], outputs: Sequence[onnx.ValueInfoProto]
    ) -> onnx.ModelProto:
        """The whole graph, checked."""
        graph = helper.make_graph(self._nodes, name, inputs, outputs, list(self._constants.values()))
        opset = helper.make_opsetid("", OPSET)
        model = helper.make_model(graph, producer_name="captra", ir_version=IR_VERSION, opset_imports=[opset])
        onnx.checker.check_model(model, full_check=True)
        return model


def tensor(name: str, element_type: int, *shape: int | str) -> onnx.ValueInfoProto:
    """Describe an input or output; named axes are dynamic."""
    return helper.make_tensor_value_info(name, element_type, list(shape))

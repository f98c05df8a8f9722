"""Writes `captra/bench/peak.onnx`: a chain of matrix products whose speed is the peak that networks are compared with.

.venv/bin/python -m benchmarks.write_peak
"""

from itertools import pairwise
from pathlib import Path

import numpy as np
from onnx import ModelProto, TensorProto, checker, helper, numpy_helper, save

from captra.bench import peak


def model() -> ModelProto:
    """Products one after the other, each with ReLU so that none joins the next; weights are made on loading."""
    size = numpy_helper.from_array(np.array([peak.WIDTH, peak.WIDTH]), "size")
    value = numpy_helper.from_array(np.array([1 / peak.WIDTH], np.float32))
    nodes = [helper.make_node("ConstantOfShape", ["size"], ["weights"], value=value)]
    names = ["rows", *(f"rows{i}" for i in range(1, peak.PRODUCTS)), "answer"]
    for i, (rows, answer) in enumerate(pairwise(names)):
        nodes.append(helper.make_node("MatMul", [rows, "weights"], [f"product{i}"]))
        nodes.append(helper.make_node("Relu", [f"product{i}"], [answer]))
    rows, answer = (
        helper.make_tensor_value_info(name, TensorProto.FLOAT, [peak.ROWS, peak.WIDTH]) for name in ("rows", "answer")
    )
    graph = helper.make_graph(nodes, "peak", [rows], [answer], [size])
    return helper.make_model(graph, ir_version=8, opset_imports=[helper.make_opsetid("", 17)])


if __name__ == "__main__":
    written = model()
    checker.check_model(written, full_check=True)
    save(written, Path(peak.__file__).with_name(peak.GRAPH))

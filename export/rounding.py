"""Weights as whole numbers: the nearest ones, or such that the errors of a column's weights make up for each other."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Protocol

import numpy as np
from jaxtyping import Float64, Int8

LARGEST_WHOLE = MappingProxyType({"int8": 127, "int6": 31, "int5": 15, "int4": 7, "int3": 3})
"""What the largest weight of a column becomes where weights are whole numbers. Each fills a byte: those with fewer bits
take less room once they are compressed, as by git. The number below the least is left unused, so that columns stay
symmetric."""

FINEST = LARGEST_WHOLE["int8"]
"""More does not fit into a byte."""

FEW_INPUTS = 16
"""Matrices with fewer rows, those of coordinates, take no room and keep eight bits."""

SMALLEST = 1e-30
"""Columns of weights smaller than that become nothing."""

DAMPING = 0.01
"""Share of the mean second moment that is added to each: inputs that were never seen together are not made up for."""

Matrix = Float64[np.ndarray, "inputs outputs"]
Moments = Float64[np.ndarray, "inputs inputs"]


@dataclass(frozen=True)
class Rounded:
    """A matrix of whole numbers times the scale of each column."""

    whole: Int8[np.ndarray, "inputs outputs"]
    """At most the largest whole number, either way."""
    scale: Float64[np.ndarray, " outputs"]
    """What one stands for."""

    @property
    def matrix(self) -> Matrix:
        """What is computed with."""
        return np.asarray(self.whole * self.scale)


class Rounding(Protocol):
    """Chooses whole numbers for a matrix of weights."""

    def __call__(self, name: str, matrix: Matrix, largest: int) -> Rounded:
        """For the matrix that the graph calls `name`; the largest weight of a column becomes about `largest`."""


class Nearest:
    """Every weight by itself; the largest of a column becomes the largest whole number."""

    def __call__(
        self,
        name: str,  # noqa: ARG002 - asked for by the protocol
        matrix: Matrix,
        largest: int,
    ) -> Rounded:
        """The nearest ones."""
        scale = peaks(matrix) / largest
        return Rounded(np.rint(matrix / scale).astype(np.int8), scale)


NEAREST: Rounding = Nearest()


@dataclass(frozen=True)
class Compensated:
    """What rounding one input's weights adds to the products is taken off by the weights of inputs that go with it.

    Weights are rounded input by input, those first that are largest in the mean; after each, the ones still to come
    take the values that change the products of seen inputs least (Frantar et al., GPTQ, 2023, equations 2 and 3).
    """

    second_moments: Mapping[str, Moments]
    """By matrix: Σ x xᵀ of the inputs x that it is multiplied with, up to a factor; without, nearest ones are taken."""
    coarseness: Mapping[str, float] = field(default_factory=dict)
    """By matrix: what its scales are multiplied by, 1 where it is not named; see `export.products.coarseness`."""

    def __call__(self, name: str, matrix: Matrix, largest: int) -> Rounded:
        """Such that products with inputs like those seen change least."""
        if name not in self.second_moments:
            return NEAREST(name, matrix, largest)
        moments = self.second_moments[name]
        moments = moments + np.eye(len(matrix)) * (DAMPING * np.trace(moments) / len(matrix) + SMALLEST)
        order = np.argsort(-np.diag(moments))
        spread = np.linalg.cholesky(np.linalg.inv(moments[np.ix_(order, order)])).T
        peak = peaks(matrix)
        scale = np.clip(peak / largest * self.coarseness.get(name, 1.0), peak / FINEST, peak)
        left, whole = matrix[order], np.zeros_like(matrix)
        for i, row in enumerate(order):
            whole[row] = np.clip(np.rint(left[i] / scale), -FINEST, FINEST)
            error = (left[i] - whole[row] * scale) / spread[i, i]
            left[i + 1 :] -= np.outer(spread[i, i + 1 :], error)
        return Rounded(whole.astype(np.int8), scale)


def peaks(matrix: Matrix) -> Float64[np.ndarray, " outputs"]:
    """The largest weight of each column, either way."""
    return np.asarray(np.maximum(np.abs(matrix).max(axis=0), SMALLEST))

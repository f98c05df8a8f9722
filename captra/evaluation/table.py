"""Tables in the terminal."""

from collections.abc import Iterable, Sequence

import numpy as np
from rich.table import Table

from captra.evaluation import comparison
from captra.evaluation.comparison import Comparison
from captra.evaluation.response import ANGLES_DEG, Response
from captra.evaluation.summary import COLUMNS, Summary, cells

WIDTH = 180
"""Columns that the tables take, whatever the terminal: they are read in logs too."""


def table(rows: Iterable[Summary], title: str) -> Table:
    """Scores, one row a sequence or mean."""
    result = Table(title=title)
    result.add_column("sequences", no_wrap=True)
    for column in COLUMNS:
        result.add_column(column, justify="right")
    for row in rows:
        result.add_row(row.name, *cells(row), style="bold" if ": mean of" in row.name else None)
    return result


def comparison_table(rows: Iterable[Comparison]) -> Table:
    """What was measured beside what the paper reports of its own test data."""
    result = Table(title="here | the paper (rigid: NOCS-REAL275, articulated: SAPIEN)")
    for column in ("sequences", "category", "part"):
        result.add_column(column, no_wrap=True)
    for column in comparison.COLUMNS:
        result.add_column(column, justify="right", no_wrap=True)
    for row in rows:
        result.add_row(row.group, row.category, row.part, *comparison.cells(row))
    return result


def response_table(title: str, responses: Sequence[Response]) -> Table:
    """What is left of each turn, the median over frames."""
    result = Table(title=f"{title}: share of the turn that one step leaves")
    for column in ("part", "axis", *(f"{angle:+.0f}°" for angle in ANGLES_DEG), "all", "frames"):
        result.add_column(column, justify="right")
    for one in responses:
        medians = [f"{value:.2f}" for value in np.median(one.left, axis=0)]
        result.add_row(one.part, one.axis, *medians, f"{one.median_left:.2f}", str(len(one.left)))
    return result

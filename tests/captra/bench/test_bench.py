import numpy as np
import pytest

from captra.bench.machine import this_machine
from captra.bench.runs import BenchRun, Percentiles
from captra.bench.table import table


def test_percentiles_of_a_ramp() -> None:
    found = Percentiles.of(list(np.arange(101.0)))
    assert (found.p50, found.p95, found.p99) == (50, 95, 99)
    with pytest.raises(ValueError, match="nothing"):
        Percentiles.of([])


def test_a_run_is_a_row() -> None:
    stage = Percentiles(1.0, 2.0, 3.0)
    run = BenchRun("mug", "paper", "cpu", 1, 10, 25.32, 1.0, stage, stage, stage, stage, stage, 0.1, 0.2, 40, 500, 3)
    rows = table([run], 12.66)
    assert rows.row_count == 1
    assert "2.00" in [cell for column in rows.columns for cell in column.cells]


def test_the_machine_is_named() -> None:
    machine = this_machine()
    assert machine.cores >= 1
    assert machine.cpu
    assert "numpy" in machine.packages

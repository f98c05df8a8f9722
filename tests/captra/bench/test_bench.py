import numpy as np
import pytest
from rich.table import Table

from captra import shipped
from captra.bench import table
from captra.bench.machine import this_machine
from captra.bench.peak import gemm_peak_gflops
from captra.bench.runs import BenchRun, Hop, Percentiles, ScalingRow, histogram_percentiles
from captra.bench.scaling import POINTS, scaling
from captra.data.recordings import load_recording

STAGE = Percentiles(1.0, 2.0, 3.0)
RUN = BenchRun(
    category="mug",
    profile="paper",
    provider="cpu",
    streams=1,
    frames=10,
    fps=25.32,
    slowest_stream_share=1.0,
    total=STAGE,
    queue=STAGE,
    sample=STAGE,
    networks=Percentiles(50.0, 60.0, 70.0),
    fit=STAGE,
    decode=STAGE,
    publish=STAGE,
    cpu_ms_per_frame=40.0,
    resident_mib=500.0,
    ready_s=3.0,
    multiply_adds=2_500_000_000,
    gemm_peak_gflops=200.0,
)


def cells(rows: Table) -> list[str]:
    return [str(cell) for column in rows.columns for cell in column.cells]


def test_percentiles_of_a_ramp() -> None:
    found = Percentiles.of(list(np.arange(101.0)))
    assert (found.p50, found.p95, found.p99) == (50, 95, 99)
    with pytest.raises(ValueError, match="nothing"):
        Percentiles.of([])


def test_percentiles_of_a_histogram() -> None:
    found = histogram_percentiles([0.001, 0.002, float("inf")], [50, 45, 5])
    np.testing.assert_allclose([found.p50, found.p95, found.p99], [1.0, 2.0, 2.0])
    assert histogram_percentiles([0.001, 0.002], [0, 100]).p50 == pytest.approx(1.5)
    with pytest.raises(ValueError, match="nothing"):
        histogram_percentiles([0.001], [0])


def test_a_run_is_a_row() -> None:
    rows = table.runs_table([RUN], 12.66)
    assert rows.row_count == 1
    assert "2.00" in cells(rows)  # times the paper's figure
    assert "1.01" in cells(rows)  # 25.32 frames of 40 ms keep one core busy


def test_share_of_the_peak() -> None:
    assert RUN.peak_share == pytest.approx(0.5)  # 5 GFLOP in 50 ms are 100 of 200
    assert "50 %" in cells(table.work_table([RUN]))


def test_other_tables() -> None:
    step = ScalingRow("mug", 1, 1024, "cpu", sample_ms=1.0, networks_ms=2.0, fit_ms=3.0, multiply_adds=7_000_000)
    assert "7" in cells(table.scaling_table([step]))
    assert "64" in cells(table.hops_table([Hop(64_000, STAGE)]))


def test_the_machine_is_named() -> None:
    machine = this_machine()
    assert machine.cores >= 1
    assert machine.cpu
    assert "numpy" in machine.packages


def test_the_peak_is_measured() -> None:
    assert gemm_peak_gflops("cpu", repetitions=2) > 1


def test_cost_by_points() -> None:
    (path,) = shipped.RECORDINGS.glob("mug__*")
    rows = list(scaling(shipped.MODELS, "cpu", [load_recording(path)], frames=1))
    assert [row.points for row in rows] == list(POINTS)
    assert sorted(rows, key=lambda row: row.multiply_adds) == rows
    assert all(min(row.sample_ms, row.networks_ms, row.fit_ms) > 0 for row in rows)

"""The figures in the terminal."""

from collections.abc import Sequence

from rich.table import Table

from captra.bench.runs import BenchRun, Percentiles

WIDTH = 180
"""Columns that the table takes, whatever the terminal."""

COLUMNS = (
    "category",
    "profile",
    "provider",
    "streams",
    "FPS",
    "× paper's GPU",
    "total",
    "queue",
    "decode",
    "sample",
    "networks",
    "fit",
    "publish",
    "CPU ms",
    "MiB",
    "ready s",
)


def table(runs: Sequence[BenchRun], reference_fps: float) -> Table:
    """One row a run; stages as p50 / p95 / p99 in milliseconds."""
    result = Table(
        title="inside the service, ms as p50 / p95 / p99 or the mean; "
        f"the paper's method ran at {reference_fps} frames a second on a GPU"
    )
    for column in COLUMNS:
        result.add_column(column, justify="right")
    for run in runs:
        result.add_row(
            run.category,
            run.profile,
            run.provider,
            str(run.streams),
            f"{run.fps:.1f}",
            f"{run.fps / reference_fps:.2f}",
            _stage(run.total),
            _stage(run.queue),
            f"{run.decode_mean_ms:.2f}",
            _stage(run.sample),
            _stage(run.networks),
            _stage(run.fit),
            f"{run.publish_mean_ms:.2f}",
            f"{run.cpu_ms_per_frame:.1f}",
            f"{run.resident_mib:.0f}",
            f"{run.ready_s:.1f}",
        )
    return result


def _stage(stage: Percentiles) -> str:
    return f"{stage.p50:.1f} / {stage.p95:.1f} / {stage.p99:.1f}"

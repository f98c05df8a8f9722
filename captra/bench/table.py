"""The figures in the terminal."""

from collections.abc import Sequence

from rich.table import Table

from captra.bench.runs import BenchRun, Hop, Percentiles, ScalingRow

WIDTH = 200
"""Columns that the tables take, whatever the terminal."""

STAGES = ("total", "queue", "decode", "sample", "networks", "fit", "publish")


def runs_table(runs: Sequence[BenchRun], reference_fps: float) -> Table:
    """One row a run; stages as p50 / p95 / p99 in milliseconds."""
    result = _table(
        "inside the service, ms as p50 / p95 / p99; "
        f"the paper's method ran at {reference_fps} frames a second on a GPU",
        (
            "category",
            "profile",
            "provider",
            "streams",
            "FPS",
            "× GPU",
            "least share",
            *STAGES,
            "CPU ms",
            "cores busy",
            "MiB",
            "ready s",
        ),
    )
    for run in runs:
        result.add_row(
            run.category,
            run.profile,
            run.provider,
            str(run.streams),
            f"{run.fps:.1f}",
            f"{run.fps / reference_fps:.2f}",
            f"{run.slowest_stream_share:.2f}",
            *(_stage(getattr(run, stage)) for stage in STAGES),
            f"{run.cpu_ms_per_frame:.1f}",
            f"{run.cores_busy:.2f}",
            f"{run.resident_mib:.0f}",
            f"{run.ready_s:.1f}",
        )
    return result


def work_table(runs: Sequence[BenchRun]) -> Table:
    """What the networks of each run need, and what they reach of the fastest matrix product."""
    result = _table(
        "networks against the fastest matrix product of the same run",
        ("category", "profile", "provider", "10⁶ multiply-adds", "networks ms", "GFLOP/s", "peak GFLOP/s", "share"),
    )
    for run in (run for run in runs if run.streams == 1):
        result.add_row(
            run.category,
            run.profile,
            run.provider,
            f"{run.multiply_adds / 1e6:.0f}",
            f"{run.networks.p50:.1f}",
            f"{run.peak_share * run.gemm_peak_gflops:.0f}",
            f"{run.gemm_peak_gflops:.0f}",
            f"{100 * run.peak_share:.0f} %",
        )
    return result


def scaling_table(rows: Sequence[ScalingRow]) -> Table:
    """How cost grows with points and parts."""
    result = _table(
        "one step without a service, medians in ms, groups of realtime",
        ("category", "parts", "points", "provider", "sample", "networks", "fit", "10⁶ multiply-adds"),
    )
    for row in rows:
        result.add_row(
            row.category,
            str(row.parts),
            str(row.points),
            row.provider,
            f"{row.sample_ms:.1f}",
            f"{row.networks_ms:.1f}",
            f"{row.fit_ms:.1f}",
            f"{row.multiply_adds / 1e6:.0f}",
        )
    return result


def hops_table(hops: Sequence[Hop]) -> Table:
    """The way there and back."""
    result = _table("Zenoh alone: there and back on loopback", ("payload kB", "ms as p50 / p95 / p99"))
    for hop in hops:
        trip = hop.round_trip
        result.add_row(f"{hop.payload_bytes / 1e3:.0f}", f"{trip.p50:.2f} / {trip.p95:.2f} / {trip.p99:.2f}")
    return result


def _table(title: str, columns: Sequence[str]) -> Table:
    result = Table(title=title, title_justify="left")
    for column in columns:
        result.add_column(column, justify="right")
    return result


def _stage(stage: Percentiles) -> str:
    digits = 1 if stage.p99 >= 1 else 2
    return f"{stage.p50:.{digits}f} / {stage.p95:.{digits}f} / {stage.p99:.{digits}f}"

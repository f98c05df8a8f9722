"""`captra bench`: frames a second and where the time goes inside a running service."""

import json
from pathlib import Path
from typing import Annotated

import typer

PAPER_GPU_FPS = 12.66
"""What the paper reports for its method (Table "Tracking speed in FPS")."""

SCALING_FRAMES = 20
ROUND_TRIPS = 200


def bench(
    recording: Annotated[
        list[Path] | None,
        typer.Option(
            help="Recordings to play, a mug by default; each category needs a bundle.", exists=True, dir_okay=False
        ),
    ] = None,
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
    profile: Annotated[list[str] | None, typer.Option(help="realtime, paper; both by default.")] = None,
    provider: Annotated[list[str] | None, typer.Option(help="cpu, openvino, cuda; auto by default.")] = None,
    streams: Annotated[list[int] | None, typer.Option(help="Streams side by side; 1 by default.", min=1)] = None,
    frames: Annotated[int, typer.Option(help="Frames timed per stream.", min=1)] = 120,
    scaling: Annotated[bool, typer.Option("--scaling", help="Also how cost grows with points and parts.")] = False,
    hop: Annotated[bool, typer.Option("--hop", help="Also round trips of the Zenoh hop alone.")] = False,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the figures as JSON.")] = None,
) -> None:
    """Start services, stream recordings through them and print what they measured, beside the paper's GPU figure.

    Example: captra bench --profile realtime --provider cpu --provider openvino --streams 1 --streams 4
    """
    from dataclasses import asdict

    from rich.console import Console

    from captra.bench import table
    from captra.bench.machine import this_machine
    from captra.bench.peak import gemm_peak_gflops
    from captra.bench.runs import BenchRun, Hop, ScalingRow
    from captra.bench.scaling import scaling as scale
    from captra.data.recordings import load_recording
    from captra.outputs import check_writable
    from captra.sampling import PROFILES
    from clients.console import errors_for_people
    from clients.demo import COFFEE_MUG
    from clients.hop import hops as round_trips
    from clients.measuring import Load, measure

    console, machine = Console(width=table.WIDTH), this_machine()
    runs, steps, hops = list[BenchRun](), list[ScalingRow](), list[Hop]()
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    with errors_for_people():
        check_writable(json_out)
        played = [load_recording(path) for path in recording or [COFFEE_MUG]]
        for one in provider or ["auto"]:
            peak_gflops = gemm_peak_gflops(one)
            for name in profile or sorted(PROFILES):
                loads = [Load(each, count, frames) for each in played for count in streams or [1]]
                runs += measure(models, name, one, loads, peak_gflops)
            if scaling:
                steps += scale(models, one, played, SCALING_FRAMES)
        if hop:
            hops = round_trips(ROUND_TRIPS)
    console.print(table.runs_table(runs, PAPER_GPU_FPS))
    console.print(table.work_table(runs))
    if steps:
        console.print(table.scaling_table(steps))
    if hops:
        console.print(table.hops_table(hops))
    if json_out is not None:
        content = {
            "machine": asdict(machine),
            "runs": [asdict(run) | {"peak_share": run.peak_share, "cores_busy": run.cores_busy} for run in runs],
            "scaling": [asdict(step) for step in steps],
            "hops": [asdict(each) for each in hops],
        }
        json_out.write_text(json.dumps(content, indent=1) + "\n")

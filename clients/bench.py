"""`captra bench`: frames a second and where the time goes inside a running service."""

import json
from pathlib import Path
from typing import Annotated

import typer

PAPER_GPU_FPS = 12.66
"""What the paper reports for its method (Table "Tracking speed in FPS")."""


def bench(
    recording: Annotated[
        list[Path] | None, typer.Option(help="Recordings to play, a mug by default; each category needs a bundle.")
    ] = None,
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
    profile: Annotated[list[str] | None, typer.Option(help="realtime, paper; both by default.")] = None,
    provider: Annotated[list[str] | None, typer.Option(help="cpu, openvino, cuda; auto by default.")] = None,
    streams: Annotated[list[int] | None, typer.Option(help="Streams side by side; 1 by default.")] = None,
    frames: Annotated[int, typer.Option(help="Frames timed per stream.")] = 120,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the figures as JSON.")] = None,
) -> None:
    """Start services, stream recordings through them and print what they measured, beside the paper's GPU figure.

    Example: captra bench --profile realtime --provider cpu --provider openvino --streams 1 --streams 4
    """
    from dataclasses import asdict

    from rich.console import Console

    from captra.bench.machine import this_machine
    from captra.bench.table import WIDTH, table
    from captra.data.recordings import load_recording
    from captra.sampling import PROFILES
    from clients.console import errors_for_people
    from clients.demo import COFFEE_MUG
    from clients.measuring import Load, measure

    console, machine, runs = Console(width=WIDTH), this_machine(), []
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    played = [load_recording(path) for path in recording or [COFFEE_MUG]]
    with errors_for_people():
        for name in profile or sorted(PROFILES):
            for one in provider or ["auto"]:
                loads = [Load(each, count, frames) for each in played for count in streams or [1]]
                runs += measure(models, name, one, loads)
    console.print(table(runs, PAPER_GPU_FPS))
    if json_out is not None:
        content = {"machine": asdict(machine), "runs": [asdict(run) for run in runs]}
        json_out.write_text(json.dumps(content, indent=1) + "\n")

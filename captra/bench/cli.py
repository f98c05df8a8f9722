"""`captra bench`: frames a second and where the time goes."""

import json
from pathlib import Path
from typing import Annotated

import typer

PAPER_GPU_FPS = 12.66
"""What the paper reports for its method (Table "Tracking speed in FPS")."""


def bench(
    recording: Annotated[Path, typer.Option(help="Recording to play; its category needs a bundle.")] = Path(
        "recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"
    ),
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
    profile: Annotated[list[str] | None, typer.Option(help="realtime, paper; both by default.")] = None,
    provider: Annotated[list[str] | None, typer.Option(help="cpu, openvino, cuda or auto.")] = None,
    streams: Annotated[list[int] | None, typer.Option(help="Streams side by side; 1 by default.")] = None,
    frames: Annotated[int, typer.Option(help="Frames timed per stream.")] = 120,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the figures as JSON.")] = None,
) -> None:
    """Time the tracker with the exported networks, stage by stage, beside the paper's GPU figure.

    Example: captra bench --profile realtime --streams 1 --streams 4
    """
    from dataclasses import asdict

    from rich.console import Console

    from captra.bench.machine import this_machine
    from captra.bench.streams import run_streams
    from captra.bench.table import WIDTH, table
    from captra.data.recordings import load_recording
    from captra.runtime.onnx_networks import OnnxNetworks
    from captra.sampling import PROFILES

    console, machine, played = Console(width=WIDTH), this_machine(), load_recording(recording)
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    runs = []
    for name in profile or sorted(PROFILES):
        for one in provider or ["cpu"]:
            networks = OnnxNetworks.load(models / played.category.name, PROFILES[name], one)
            runs += [run_streams(networks, played, one, count, frames) for count in streams or [1]]
    console.print(table(runs, PAPER_GPU_FPS))
    if json_out is not None:
        content = {"machine": asdict(machine), "runs": [asdict(run) for run in runs]}
        json_out.write_text(json.dumps(content, indent=1) + "\n")

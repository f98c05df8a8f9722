"""`captra evaluate` and `captra response`: what the exported networks score."""

import json
from pathlib import Path
from typing import Annotated

import typer

Models = Annotated[Path, typer.Option(help="Folder of bundles.")]
Categories = Annotated[
    list[str] | None, typer.Option("--category", help="Category; all that have a bundle by default.")
]
Recordings = Annotated[Path, typer.Option(help="Folder of recordings.")]
ProfileName = Annotated[str, typer.Option(help="realtime or paper.")]
Provider = Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")]

DEFAULT_MODELS = Path("models")
DEFAULT_RECORDINGS = Path("recordings")


def evaluate(
    category: Categories = None,
    recordings: Recordings = DEFAULT_RECORDINGS,
    procedural: Annotated[int, typer.Option(help="Unseen procedural sequences per category, 100 frames each.")] = 0,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the rows as JSON.")] = None,
    markdown_out: Annotated[Path | None, typer.Option("--markdown", help="Also write the table as Markdown.")] = None,
) -> None:
    """Track whole sequences with the exported networks and print the paper's measures.

    Example: captra evaluate --category mug --recordings recordings --procedural 20
    """
    from itertools import chain

    from rich.console import Console

    from captra.evaluation.runner import evaluate as run
    from captra.evaluation.sequences import procedural as make
    from captra.evaluation.sequences import recordings_in
    from captra.evaluation.summary import Summary, as_json, average, markdown, summarize
    from captra.evaluation.table import WIDTH, table

    console, rows = Console(width=WIDTH), list[Summary]()
    for name in category or _available(models):
        networks = _load(models, name, profile, provider)
        groups = (("recordings", recordings_in(recordings, name)), ("procedural", make(name, procedural)))
        for group, sequences in groups:
            first = next(iter(sequences), None)
            if first is None:
                continue
            found = [
                summarize(score)
                for score in run(
                    networks, chain([first], sequences), lambda score: console.print(f"tracked {score.name}")
                )
            ]
            rows += [*found, average(f"{name}: mean of {len(found)} {group}", found)]
    console.print(table(rows, f"{profile}, {provider}"))
    if json_out is not None:
        json_out.write_text(json.dumps(as_json(rows), indent=1) + "\n")
    if markdown_out is not None:
        markdown_out.write_text(markdown(rows) + "\n")


def response(
    category: Categories = None,
    recordings: Recordings = DEFAULT_RECORDINGS,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
) -> None:
    """Turn true poses about one axis, take one step, and print the share of the turn that is left.

    Example: captra response --category mug --recordings recordings
    """
    from rich.console import Console

    from captra.evaluation.response import response as test
    from captra.evaluation.sequences import recordings_in
    from captra.evaluation.table import WIDTH, response_table

    console = Console(width=WIDTH)
    for name in category or _available(models):
        networks = _load(models, name, profile, provider)
        for recording in recordings_in(recordings, name):
            console.print(response_table(recording.name, test(networks, recording)))


def calibrate(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural validation sequences per category.")] = 6,
    frames: Annotated[int, typer.Option(help="Frames of each.")] = 50,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
) -> None:
    """Fit the confidence of a bundle on validation sequences and write it into the manifest.

    Example: captra calibrate --category mug
    """
    from dataclasses import asdict, replace

    from rich.console import Console

    from captra.evaluation.calibration import auroc, confidences, fit, observe
    from captra.evaluation.sequences import VALIDATION_SEED
    from captra.evaluation.sequences import procedural as make
    from captra.runtime.bundle import load_manifest, write_manifest

    console = Console()
    for name in category or _available(models):
        networks = _load(models, name, profile, provider)
        with console.status(f"{name}: tracking {sequences} sequences from three starts each"):
            observations = observe(networks, make(name, sequences, frames, VALIDATION_SEED))
        model = fit(observations)
        write_manifest(models / name, replace(load_manifest(models / name), health=asdict(model)))
        found = auroc(confidences(model, observations), observations.correct)
        console.print(
            f"{name}: {len(observations.correct)} steps, {100 * observations.correct.mean():.0f} % right, "
            f"AUROC {found:.3f} on the sequences it was fitted to"
        )


def _available(models: Path) -> list[str]:
    from captra.runtime.bundle import find_bundles

    return sorted(find_bundles(models))


def _load(models: Path, category: str, profile: str, provider: str):  # type: ignore[no-untyped-def]
    from captra.runtime.onnx_networks import OnnxNetworks
    from captra.sampling import PROFILES

    return OnnxNetworks.load(models / category, PROFILES[profile], provider)

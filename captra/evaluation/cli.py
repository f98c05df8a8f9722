"""`captra evaluate` and `captra response`: what the exported networks score."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from captra.evaluation.runner import ExportedNetworks
    from captra.runtime.onnx_networks import OnnxNetworks

Models = Annotated[Path, typer.Option(help="Folder of bundles.")]
Categories = Annotated[
    list[str] | None, typer.Option("--category", help="Category; all that have a bundle by default.")
]
Recordings = Annotated[Path, typer.Option(help="Folder of recordings.")]
ProfileName = Annotated[str, typer.Option(help="realtime or paper.")]
Provider = Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")]
Cache = Annotated[Path, typer.Option(help="Folder that keeps simulated sequences.")]

DEFAULT_MODELS = Path("models")
DEFAULT_RECORDINGS = Path("recordings")
DEFAULT_CACHE = Path(".campaign/sequences")


def evaluate(
    category: Categories = None,
    recordings: Recordings = DEFAULT_RECORDINGS,
    procedural: Annotated[int, typer.Option(help="Unseen procedural sequences per category.")] = 0,
    meshes: Annotated[
        Path | None, typer.Option(help="Library of objects with an INDEX.json: those for validation are filmed too.")
    ] = None,
    frames: Annotated[int, typer.Option(help="Of each sequence that is simulated.")] = 100,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    jobs: Annotated[int, typer.Option(help="Sequences tracked at a time, each in a process of its own.")] = 1,
    cache: Cache = DEFAULT_CACHE,
    write_scores: Annotated[bool, typer.Option("--write-scores", help="Put the means into the manifests.")] = False,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the rows as JSON.")] = None,
    markdown_out: Annotated[Path | None, typer.Option("--markdown", help="Also write the table as Markdown.")] = None,
) -> None:
    """Track whole sequences with the exported networks and print the paper's measures.

    Example: captra evaluate --category mug --recordings recordings --procedural 20 --jobs 2
    """
    from rich.console import Console

    from captra.evaluation.manifest_scores import command_for
    from captra.evaluation.manifest_scores import write_scores as write
    from captra.evaluation.runner import evaluate as run
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import library, recordings_in
    from captra.evaluation.sequences import procedural as unseen
    from captra.evaluation.summary import Summary, as_json, average, average_of_parts, markdown, summarize
    from captra.evaluation.table import WIDTH, table
    from captra.evaluation.workers import workers
    from captra.runtime.cores import available_cores

    console, rows, kept = Console(width=WIDTH), list[Summary](), SequenceCache.open(cache)
    options = {"recordings": recordings, "procedural": procedural, "frames": frames}
    options |= {"meshes": meshes} if meshes else {}
    with workers(jobs) as pool:
        for name in category or _available(models):
            threads = max(1, available_cores() // jobs)
            exported, means = _exported(models, name, profile, provider, threads), dict[str, Summary]()
            for group, sources in (
                ("recordings", recordings_in(recordings, name, meshes)),
                ("procedural", unseen(name, procedural, kept, frames)),
                ("meshes", library(meshes, name, kept, frames) if meshes else ()),
            ):
                scores = []
                for score in run(exported, sources, pool):
                    scores.append(score)
                    console.print(f"tracked {score.name}: 5°5cm {100 * score.within_5deg_5cm.mean():.1f} %")
                if not scores:
                    continue
                found = [summarize(score) for score in scores]
                means[group] = average(f"{name}: mean of {len(found)} {group}", found)
                rows += [*found, *average_of_parts(scores), means[group]]
            if write_scores and means:
                write(models / name, command_for(name, options | {"profile": profile}), means)
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
        for source in recordings_in(recordings, name):
            console.print(response_table(source.name, test(networks, source.load().recording)))


def calibrate(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural validation sequences per category.")] = 6,
    frames: Annotated[int, typer.Option(help="Frames of each.")] = 50,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    cache: Cache = DEFAULT_CACHE,
) -> None:
    """Fit the confidence of a bundle on validation sequences and write it into the manifest.

    Example: captra calibrate --category mug
    """
    from dataclasses import asdict, replace

    from rich.console import Console

    from captra.evaluation.calibration import auroc, confidences, fit, observe
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import VALIDATION_SEED
    from captra.evaluation.sequences import procedural as make
    from captra.runtime.bundle import load_manifest, write_manifest

    console, kept = Console(), SequenceCache.open(cache)
    for name in category or _available(models):
        networks = _load(models, name, profile, provider)
        with console.status(f"{name}: tracking {sequences} sequences from three starts each"):
            sources = make(name, sequences, kept, frames, VALIDATION_SEED)
            observations = observe(networks, (source.load().recording for source in sources))
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


def _load(models: Path, category: str, profile: str, provider: str) -> "OnnxNetworks":
    from captra.runtime.cores import available_cores

    return _exported(models, category, profile, provider, available_cores()).load()


def _exported(models: Path, category: str, profile: str, provider: str, threads: int) -> "ExportedNetworks":
    from captra.evaluation.runner import ExportedNetworks

    return ExportedNetworks(models / category, profile, provider, threads)

"""`captra evaluate`, `captra response` and `captra fuse`: what the exported networks score."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from captra.errors import UserError

if TYPE_CHECKING:
    from captra.evaluation.runner import ExportedNetworks
    from captra.runtime.onnx_networks import OnnxNetworks

Models = Annotated[Path, typer.Option(help="Folder of bundles.")]
Categories = Annotated[
    list[str] | None, typer.Option("--category", help="Category; all that have a bundle by default.")
]
Recordings = Annotated[Path, typer.Option(help="Folder of recordings.")]
ProfileName = Annotated[Literal["realtime", "paper"], typer.Option(metavar="NAME", help="realtime or paper.")]
Provider = Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")]
Cache = Annotated[Path, typer.Option(help="Folder that keeps simulated sequences.")]

Jobs = Annotated[int, typer.Option(help="Sequences tracked at a time, each in a process of its own.", min=1)]


class NothingToEvaluateError(UserError):
    """There is no sequence to track."""


DEFAULT_MODELS = Path("models")
DEFAULT_RECORDINGS = Path("recordings")
DEFAULT_CACHE = Path(".campaign/sequences")


def evaluate(
    category: Categories = None,
    recordings: Recordings = DEFAULT_RECORDINGS,
    procedural: Annotated[int, typer.Option(help="Unseen procedural sequences per category.", min=0)] = 0,
    standalone: Annotated[
        int,
        typer.Option(
            help="Unseen articulated instances by themselves before a perfect camera, as in the paper's dataset.", min=0
        ),
    ] = 0,
    meshes: Annotated[
        Path | None, typer.Option(help="Library of objects with an INDEX.json: those for validation are filmed too.")
    ] = None,
    frames: Annotated[int, typer.Option(help="Of each sequence that is simulated.", min=2)] = 100,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    robustness: Annotated[bool, typer.Option("--robustness", help="Also with noise on the poses.")] = False,
    baseline: Annotated[bool, typer.Option("--baseline", help="Also oracle ICP, RANSAC and a fixed scale.")] = False,
    response: Annotated[bool, typer.Option("--response", help="Also the response test, on every sequence.")] = False,
    jobs: Jobs = 1,
    cache: Cache = DEFAULT_CACHE,
    pictures: Annotated[
        Path | None, typer.Option(help="Folder for errors over time and the ten worst moments.")
    ] = None,
    write_scores: Annotated[bool, typer.Option("--write-scores", help="Put the means into the manifests.")] = False,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the rows as JSON.")] = None,
    markdown_out: Annotated[Path | None, typer.Option("--markdown", help="Also write the tables as Markdown.")] = None,
) -> None:
    """Track whole sequences with the exported networks and print the paper's measures beside its own figures.

    Example: captra evaluate --category mug --recordings recordings --procedural 20 --jobs 2
    """
    from rich.console import Console

    from captra.evaluation import followers
    from captra.evaluation.manifest_scores import REFERENCE, command_for
    from captra.evaluation.manifest_scores import write_scores as write
    from captra.evaluation.report import Report
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import library, recordings_in
    from captra.evaluation.sequences import procedural as unseen
    from captra.evaluation.sequences import standalone as by_themselves
    from captra.evaluation.table import WIDTH
    from captra.evaluation.workers import workers
    from captra.outputs import check_folder, check_writable
    from captra.runtime.cores import available_cores

    check_writable(json_out, markdown_out)
    check_folder(pictures)
    names, console = with_models(category, models), Console(width=WIDTH)
    kept = SequenceCache.open(cache)
    others = (*(followers.ROBUSTNESS if robustness else ()), *(followers.BASELINES if baseline else ()))
    options = {"recordings": recordings, "procedural": procedural, "frames": frames, "profile": profile}
    options |= {"standalone": standalone} if standalone else {}
    options |= {"meshes": meshes} if meshes else {}
    options |= {"provider": provider} if provider != REFERENCE else {}
    report = Report()
    with workers(jobs) as pool:
        for name in names:
            bundle = exported(models, name, profile, provider, max(1, available_cores() // jobs))
            for group, sources in (
                ("recordings", recordings_in(recordings, name, meshes)),
                ("procedural", unseen(name, procedural, kept, frames)),
                ("standalone", by_themselves(name, standalone, kept, frames)),
                ("meshes", library(meshes, name, kept, frames) if meshes else ()),
            ):
                report.measure(bundle, name, group, list(sources), others, pool, console, with_response=response)
            if write_scores and report.means(name):
                write(models / name, command_for(name, options), report.means(name))
    if report.is_empty:
        raise NothingToEvaluateError(
            f"no sequence to track in {recordings}: name a folder of recordings by --recordings, or have some "
            "simulated by --procedural 20"
        )
    for table in report.tables(f"{profile}, {provider}"):
        console.print(table)
    if json_out is not None:
        json_out.write_text(json.dumps(report.as_json(), indent=1) + "\n")
    if markdown_out is not None:
        markdown_out.write_text(report.markdown())
    if pictures is not None:
        report.draw(pictures)


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
    for name in with_models(category, models):
        networks = load(models, name, profile, provider)
        for source in recordings_in(recordings, name):
            console.print(response_table(source.name, test(networks, source.load().recording)))


def fuse(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural validation sequences per category.", min=1)] = 24,
    frames: Annotated[int, typer.Option(help="Of each.", min=2)] = 100,
    instances: Annotated[int, typer.Option(help="Objects on which lasting errors are measured.", min=2)] = 24,
    errors_only: Annotated[
        bool, typer.Option("--errors-only", help="Keep the fusion, measure lasting errors.")
    ] = False,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    jobs: Jobs = 1,
    cache: Cache = DEFAULT_CACHE,
) -> None:
    """Choose on validation sequences how a bundle's opinions on rotations become one, and note it in the manifest.

    Tries whether to ask about the mirrored cloud too, and measures by how much poses and sizes stay wrong on one
    object: so much is made up for by the given pose.

    Example: captra fuse --category mug
    """
    from dataclasses import replace
    from functools import partial

    from rich.console import Console

    from captra.categories import get_category
    from captra.evaluation.found_errors import describe, measure_found_error
    from captra.evaluation.fusion_choice import FusedNetworks, Fusion, choose, measure
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import VALIDATION_SEED
    from captra.evaluation.sequences import procedural as unseen
    from captra.evaluation.table import WIDTH, table
    from captra.evaluation.workers import workers
    from captra.runtime.bundle import load_manifest, write_manifest
    from captra.runtime.cores import available_cores

    names, console = with_models(category, models), Console(width=WIDTH)
    kept = SequenceCache.open(cache)
    with workers(jobs) as pool:
        for name in names:
            networks = exported(models, name, profile, provider, max(1, available_cores() // jobs))
            best = Fusion.of(load_manifest(models / name))
            if not errors_only:
                sources = list(unseen(name, sequences, kept, frames, VALIDATION_SEED))
                best, means = choose(name, partial(measure, networks, sources, pool))
                console.print(table(means, f"{name}: {best.name} is in the manifest now"))
            objects = list(unseen(name, instances, kept, frames, VALIDATION_SEED))
            error = measure_found_error(get_category(name), FusedNetworks(networks, best), objects, pool)
            manifest = replace(best.set_in(load_manifest(models / name)), found_error=error.calibration)
            write_manifest(models / name, manifest)
            console.print(f"{name}: {describe(error)}")


def with_models(categories: list[str] | None, models: Path) -> list[str]:
    """The categories that were asked for, or all that have a bundle.

    Raises:
        UnknownCategoryError: one of them is none.
        BundleError: one of them, or all, have no bundle.
    """
    from captra.categories import get_category
    from captra.runtime.bundle import BundleError, find_bundles

    there = sorted(find_bundles(models))
    for name in categories or ():
        if get_category(name).name not in there:
            raise BundleError(
                f"there is no model of {name} in {models}: take one of {', '.join(there) or 'none'}, write one with "
                "`captra export`, or name another folder by --models"
            )
    if not there:
        raise BundleError(f"there are no models in {models}: name the folder that holds them by --models")
    return categories or there


def load(models: Path, category: str, profile: str, provider: str) -> "OnnxNetworks":
    """The networks of a bundle, on all cores."""
    from captra.runtime.cores import available_cores

    return exported(models, category, profile, provider, available_cores()).load()


def exported(models: Path, category: str, profile: str, provider: str, threads: int) -> "ExportedNetworks":
    """The networks of a bundle, not loaded yet."""
    from captra.evaluation.runner import ExportedNetworks

    return ExportedNetworks(models / category, profile, provider, threads)

"""`captra calibrate` and `captra health`: how far the tracker's word can be trusted."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from captra.evaluation.cli import DEFAULT_CACHE, DEFAULT_MODELS, Cache, Categories, Jobs, Models, ProfileName, Provider

if TYPE_CHECKING:
    from captra.evaluation.sequences import SequenceSource

Looks = Annotated[int, typer.Option(help="Looks a frame while a track does not hold; 1 never searches.", min=1)]
DEFAULT_LOOKS = 4


def calibrate(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural validation sequences per category.", min=1)] = 6,
    jobs: Jobs = 2,
    looks: Looks = DEFAULT_LOOKS,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    cache: Cache = DEFAULT_CACHE,
) -> None:
    """Fit the confidence of a bundle, and its thresholds, on validation sequences and write them into the manifest.

    Example: captra calibrate --category mug
    """
    from dataclasses import replace

    import numpy as np
    from rich.console import Console

    from captra.evaluation.calibration import auroc, confidences
    from captra.evaluation.calibration_runner import calibrated
    from captra.evaluation.cli import exported, with_models
    from captra.evaluation.sequences import VALIDATION_SEED
    from captra.evaluation.workers import workers
    from captra.runtime.bundle import load_manifest, write_manifest
    from captra.runtime.cores import available_cores

    console, threads = Console(), max(1, available_cores() // jobs)
    with workers(jobs) as pool:
        for name in with_models(category, models):
            with console.status(f"{name}: tracking what goes wrong in {sequences} sequences, twice"):
                sources = sources_of(name, sequences, cache, VALIDATION_SEED)
                networks = exported(models, name, profile, provider, threads)
                monitor, found = calibrated(networks, sources, pool, looks)
            write_manifest(models / name, replace(load_manifest(models / name), health=monitor.calibration))
            right = np.asarray(found.correct.all(axis=1))
            console.print(
                f"{name}: {len(right)} steps, {100 * right.mean():.0f} % right; AUROC "
                f"{auroc(confidences(monitor.confidence_of, found), right):.3f} on the sequences it was fitted to; "
                f"doubt below {monitor.doubt_below:.2f}, trust above {monitor.trust_above:.2f}"
            )


def health(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural test sequences per category.", min=1)] = 2,
    kinds: Annotated[list[str] | None, typer.Option("--kind", help="Kind of incident; all by default.")] = None,
    rates: Annotated[bool, typer.Option(help="Also with and without prediction, at 10 and 30 Hz.")] = True,
    jobs: Jobs = 2,
    looks: Looks = DEFAULT_LOOKS,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    cache: Cache = DEFAULT_CACHE,
    json_out: Annotated[Path | None, typer.Option("--json", help="Also write the figures as JSON.")] = None,
    markdown_out: Annotated[Path | None, typer.Option("--markdown", help="Also write the tables as Markdown.")] = None,
    picture: Annotated[Path | None, typer.Option(help="Also draw the reliability diagram (PNG).")] = None,
) -> None:
    """Let things go wrong in test sequences, and print how the tracker takes it: told, unharmed, recovered.

    Example: captra health --category mug --json health.json --markdown health.md --picture reliability.png
    """
    from rich.console import Console

    from captra.evaluation import health_report
    from captra.evaluation.cli import exported, with_models
    from captra.evaluation.health_figures import HealthFigures, by_kind, figures
    from captra.evaluation.health_report import HealthReport
    from captra.evaluation.incident_runner import Rehearsal, watch_all
    from captra.evaluation.incidents import INCIDENTS
    from captra.evaluation.prediction_rates import Rate, pooled
    from captra.evaluation.prediction_rates import rates as measure_rates
    from captra.evaluation.sequences import TEST_SEED
    from captra.evaluation.table import WIDTH
    from captra.evaluation.watching import Watched
    from captra.evaluation.workers import workers
    from captra.outputs import check_writable
    from captra.runtime.bundle import load_manifest
    from captra.runtime.cores import available_cores

    console, chosen = Console(width=WIDTH), tuple(kinds or INCIDENTS)
    if unknown := [kind for kind in chosen if kind not in INCIDENTS]:
        raise typer.BadParameter(f"{unknown[0]!r} is none of {', '.join(INCIDENTS)}")
    if picture is not None and picture.suffix != ".png":
        raise typer.BadParameter(f"--picture {picture} is no PNG: name a file that ends in .png")
    check_writable(json_out, markdown_out, picture)
    names, threads = with_models(category, models), max(1, available_cores() // jobs)
    found, everything = list[HealthFigures](), list[Watched]()
    measured = list[Rate]()
    with workers(jobs) as pool:
        for name in names:
            networks, watched = exported(models, name, profile, provider, threads), list[Watched]()
            sources = sources_of(name, sequences, cache, TEST_SEED)
            rehearsals = [Rehearsal(source, (kind,), i) for i, source in enumerate(sources) for kind in chosen]
            for some in watch_all(networks, rehearsals, pool, load_manifest(models / name).health, looks):
                watched += some
                console.print(*(f"tracked {one.name}: {100 * one.correct.mean():.0f} % right" for one in some))
            found.append(figures(name, watched))
            everything += watched
            if rates:
                measured += measure_rates(name, networks, sources, pool)
    if len(names) > 1:
        found.append(figures(health_report.OVERALL, everything))
        measured += list(pooled(measured))
    report = HealthReport(found, by_kind(everything), measured)
    for table in health_report.tables(report):
        console.print(table)
    minutes = processor_minutes()
    console.print(f"{minutes:.1f} minutes of processor time, {minutes / len(names):.1f} a category")
    if json_out is not None:
        json_out.write_text(json.dumps(health_report.as_json(report), indent=1, allow_nan=False) + "\n")
    if markdown_out is not None:
        markdown_out.write_text(health_report.markdown(report))
    if picture is not None:
        health_report.draw_reliability(found, picture)


def processor_minutes() -> float:
    """What this process and those that it started and saw end have used so far."""
    import resource

    usages = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages) / 60


def sources_of(name: str, count: int, cache: Path, first_seed: int) -> "Sequence[SequenceSource]":
    """Procedural sequences of a category, as long as incidents need them."""
    from captra.evaluation.incidents import LONGEST
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import procedural

    return list(procedural(name, count, SequenceCache.open(cache), LONGEST, first_seed))

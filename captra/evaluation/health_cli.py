"""`captra calibrate` and `captra health`: how far the tracker's word can be trusted."""

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from captra.evaluation.cli import DEFAULT_CACHE, DEFAULT_MODELS, Cache, Categories, Models, ProfileName, Provider

if TYPE_CHECKING:
    from captra.evaluation.incidents import Incident


def calibrate(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural validation sequences per category.", min=1)] = 6,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    cache: Cache = DEFAULT_CACHE,
) -> None:
    """Fit the confidence of a bundle, and its thresholds, on validation sequences and write them into the manifest.

    Example: captra calibrate --category mug
    """
    from dataclasses import replace
    from functools import partial

    import numpy as np
    from rich.console import Console

    from captra.evaluation.calibration import auroc, calibrate, confidences, observations
    from captra.evaluation.cli import available, load
    from captra.evaluation.incidents import INCIDENTS
    from captra.evaluation.sequences import VALIDATION_SEED
    from captra.evaluation.watching import watch
    from captra.runtime.bundle import load_manifest, write_manifest
    from captra.tracker import Tracker

    console, faults = Console(), [kind for kind in INCIDENTS if kind != "nothing"]
    for name in category or available(models):
        networks = load(models, name, profile, provider)
        with console.status(f"{name}: tracking two incidents in each of {sequences} sequences"):
            happened = _incidents(
                name, sequences, cache, VALIDATION_SEED, lambda i: ["nothing", faults[i % len(faults)]]
            )
            found = observations(list(watch(partial(Tracker, networks), happened)))
        monitor = calibrate(found)
        write_manifest(models / name, replace(load_manifest(models / name), health=monitor.calibration))
        right = np.asarray(found.correct.all(axis=1))
        console.print(
            f"{name}: {len(right)} steps, {100 * right.mean():.0f} % right; AUROC "
            f"{auroc(confidences(monitor.confidence_of, found), right):.3f} on the sequences it was fitted to; "
            f"doubt below {monitor.doubt_below:.2f}, trust above {monitor.trust_above:.2f}"
        )


def health(
    category: Categories = None,
    sequences: Annotated[int, typer.Option(help="Procedural test sequences per category.", min=1)] = 4,
    kinds: Annotated[list[str] | None, typer.Option("--kind", help="Kind of incident; all by default.")] = None,
    looks: Annotated[int, typer.Option(help="Looks a frame while a track does not hold; 1 never searches.")] = 4,
    models: Models = DEFAULT_MODELS,
    profile: ProfileName = "realtime",
    provider: Provider = "cpu",
    cache: Cache = DEFAULT_CACHE,
) -> None:
    """Let things go wrong in test sequences, and print how the tracker takes it: told, unharmed, recovered.

    Example: captra health --category mug --sequences 4
    """
    from functools import partial

    from rich.console import Console

    from captra.evaluation.cli import available, load
    from captra.evaluation.health_report import summary
    from captra.evaluation.incidents import INCIDENTS
    from captra.evaluation.sequences import TEST_SEED
    from captra.evaluation.table import WIDTH
    from captra.evaluation.watching import watch
    from captra.health import HealthMonitor
    from captra.recovery import LookBudget
    from captra.tracker import Tracker, TrackerOptions

    console, options, chosen = Console(width=WIDTH), TrackerOptions(search=LookBudget(looks)), kinds or list(INCIDENTS)
    if unknown := [kind for kind in chosen if kind not in INCIDENTS]:
        raise typer.BadParameter(f"{unknown[0]!r} is none of {', '.join(INCIDENTS)}")
    for name in category or available(models):
        networks = load(models, name, profile, provider)
        monitor, watched = HealthMonitor.calibrated(networks.manifest.health), []
        happened = _incidents(name, sequences, cache, TEST_SEED, lambda _: chosen)
        for one in watch(partial(Tracker, networks, health=monitor, options=options), happened):
            watched.append(one)
            console.print(f"tracked {one.incident.recording.name}: {100 * one.correct.mean():.0f} % right")
        console.print(summary(name, watched))


def _incidents(
    name: str, count: int, cache: Path, first_seed: int, kinds_of: Callable[[int], Sequence[str]]
) -> "Iterator[Incident]":
    """Incidents in procedural sequences, `kinds_of` says which in each."""
    from captra.evaluation.incidents import LONGEST, make_incident
    from captra.evaluation.sequence_cache import SequenceCache
    from captra.evaluation.sequences import procedural

    for index, source in enumerate(procedural(name, count, SequenceCache.open(cache), LONGEST, first_seed)):
        recording = source.load().recording
        for kind in kinds_of(index):
            yield make_incident(kind, recording, index)

"""`captra train`: from rendered views to checkpoints."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Annotated

import typer

from captra.categories import Category
from captra.errors import UserError
from captra.learn.plan import ROTATION, NetworkName, Plan

DEFAULT_FOLDER = Path(".campaign")
DEFAULT_RUN = "run"
FURTHER_LEARNING_RATE = 4e-4
"""Weights that were trained to the end are not shaken up again."""


class NoViewsError(UserError):
    """There is nothing to train on."""


class UnlikeError(UserError):
    """Categories that no network can serve together."""


def train(
    category: Annotated[str | None, typer.Option(help="What to train, e.g. mug.")] = None,
    everything: Annotated[
        bool, typer.Option("--all", help="All categories one after the other, from views to bundles in models/.")
    ] = False,
    samples: Annotated[int, typer.Option(help="Samples that each network sees before the run ends.", min=1)] = 60_000,
    folder: Annotated[
        Path, typer.Option(help="Campaign folder: views are read from it, state goes to it.")
    ] = DEFAULT_FOLDER,
    run: Annotated[str, typer.Option(help="Name of the run: one state and one log each.")] = DEFAULT_RUN,
    start_from: Annotated[
        Path | None,
        typer.Option(help="Bundle or folder of checkpoints to start from; its name is their category."),
    ] = None,
    only: Annotated[
        NetworkName | None,
        typer.Option(help="Train one network further, from what to start from, and leave the other as it is."),
    ] = None,
    anew: Annotated[
        bool,
        typer.Option("--anew", help="With --only rotation: from the backbone of the CoordinateNet to start from."),
    ] = False,
    shared_with: Annotated[
        list[str] | None,
        typer.Option(help="Another category whose views are mixed in, so that the networks serve it as well."),
    ] = None,
    learning_rate: Annotated[
        float | None,
        typer.Option(
            help="Of both optimizers at the start; by default 1e-3, or 4e-4 from weights of the same category."
        ),
    ] = None,
    threads: Annotated[int, typer.Option(help="CPU threads.")] = 1,
    seed: Annotated[int, typer.Option(help="Of weights, views and perturbations.")] = 1,
    meshes: Annotated[
        Path | None, typer.Option(help="With --all: library whose objects for training are mixed into the views.")
    ] = None,
) -> None:
    """Train both networks of a category, or of all; interrupt it whenever you like, the same command goes on.

    Views come from `captra generate`, which may still be writing.

    Example: captra train --category mug --samples 60000
    """
    import signal

    import torch
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    from captra.categories import get_category
    from captra.data.dataset import ViewDataset
    from captra.learn.curves import plot_curves
    from captra.learn.provenance import provenance
    from captra.learn.training import Progress as RunProgress
    from captra.learn.training import Trainer

    if (category is None) != everything:
        raise typer.BadParameter("say either --category NAME or --all")
    if everything:
        check_untold(
            {
                "--only": only,
                "--anew": anew,
                "--shared-with": shared_with,
                "--start-from": start_from,
                "--learning-rate": learning_rate,
                "--run": run != DEFAULT_RUN,
            }
        )
    check_meshes(meshes, everything=everything)
    shown = [] if category is None else [category, *(shared_with or [])]
    for name in shown:
        check_views(get_category(name).name, folder)

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, interrupt)  # also where a background job was started with it ignored
    signal.signal(signal.SIGTERM, interrupt)
    console = Console()
    torch.set_num_threads(threads)
    if category is None:
        run_campaign(folder, samples, threads, seed, meshes, console.print)
        return
    chosen = get_category(category)
    check_alike(chosen, map(get_category, shown))
    where = [views_of(name, folder) for name in shown]
    state = folder / "runs" / category / run
    check_start(only, start_from, anew=anew)
    further = start_from is not None and start_from.name == category and not anew
    rate = learning_rate or (FURTHER_LEARNING_RATE if further else Plan.learning_rate)
    networks = Plan.networks if only is None else (only,)
    plan = Plan(samples=samples, seed=seed, learning_rate=rate, networks=networks, anew=anew)
    trainer = Trainer(chosen, ViewDataset(*where), plan, state, provenance(*where))
    if start_from is not None and trainer.progress.samples == 0:
        trainer.start_from(get_category(start_from.name), start_from)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.completed}/{task.total}"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console) as progress:
        task = progress.add_task(f"{category}: samples", total=samples, completed=trainer.progress.samples)

        def report(done: RunProgress, terms: dict[str, float]) -> None:
            loss = " ".join(f"{name} {value:.3f}" for name, value in terms.items())
            progress.update(task, completed=done.samples, description=f"{category}: {loss}"[:160])

        try:
            trainer.run(report)
        except KeyboardInterrupt:
            console.print("stopped; run the same command to go on")
    plot_curves(state / "log.jsonl", state / "curves.png")
    console.print(f"checkpoints and curves are in {state}; next: captra export --category {category} …")


def check_untold(options: Mapping[str, object]) -> None:
    """The campaign of all categories plans by itself which networks it trains, and from what.

    Raises:
        typer.BadParameter: it was told, by an option that has a value.
    """
    told = [name for name, value in options.items() if value]
    if told:
        raise typer.BadParameter(
            f"--all decides that by itself: leave out {' and '.join(told)}, or say --category NAME"
        )


def check_meshes(meshes: Path | None, *, everything: bool) -> None:
    """Only the campaign of all categories makes views.

    Raises:
        typer.BadParameter: one category is to be trained on meshes.
    """
    if meshes is not None and not everything:
        raise typer.BadParameter(
            "--meshes is for --all, which makes views itself: give it to captra generate before training one category"
        )


def check_start(only: NetworkName | None, start_from: Path | None, *, anew: bool) -> None:
    """One network alone has to come from somewhere, and RotationNet alone has another one to start from.

    Raises:
        typer.BadParameter: what is missing is not said.
    """
    if only is not None and start_from is None:
        raise typer.BadParameter(f"--only {only} takes networks from somewhere: say --start-from models/NAME")
    if anew and only != ROTATION:
        raise typer.BadParameter("--anew is for RotationNet alone: say --only rotation as well")


def views_of(category: str, folder: Path) -> Path:
    """Where training looks for the views of a category."""
    return folder / "views" / category / "train"


def check_views(category: str, folder: Path) -> None:
    """Say how to make views where there are none.

    Raises:
        NoViewsError: there are none.
    """
    from captra.data.dataset import ViewDataset

    where = views_of(category, folder)
    if len(ViewDataset(where)) == 0:
        raise NoViewsError(
            f"there are no views in {where}: make some first, with "
            f"captra generate --category {category} --count 12000 --seed 1 --out {where}"
        )


def check_alike(category: Category, others: Iterable[Category]) -> None:
    """Networks serve categories that have as many parts, joints of the same kinds, and the same symmetry.

    Raises:
        UnlikeError: one is of another kind.
    """
    for other in others:
        if _kind(other) != _kind(category):
            raise UnlikeError(
                f"{other.name} cannot share networks with {category.name}: parts, joints and symmetry must be the same"
            )


def _kind(category: Category) -> tuple[object, ...]:
    joints = tuple((joint.kind, joint.child, joint.parent, joint.axis) for joint in category.joints)
    return len(category.parts), category.root, joints, category.symmetric, category.background


def run_campaign(
    folder: Path, samples: int, threads: int, seed: int, meshes: Path | None, tell: Callable[[str], None]
) -> None:
    """The queue of `--all`, until it is through or interrupted; what it tells is kept in the folder too."""
    from datetime import UTC, datetime

    from captra.learn.campaign import Campaign, Folders
    from captra.learn.local_steps import LocalSteps, yield_to_others

    folders = Folders(folder, Path("models"))
    folder.mkdir(parents=True, exist_ok=True)

    def note(text: str) -> None:
        tell(text)
        with (folder / "campaign.log").open("a") as log:
            log.write(f"{datetime.now(UTC):%Y-%m-%d %H:%M:%S} {text}\n")

    yield_to_others()
    steps = LocalSteps(folders, samples, threads=threads, meshes=meshes, seed=seed)
    try:
        Campaign(folders, steps, samples, note).run()
    except KeyboardInterrupt:
        note("stopped; run the same command to go on")

"""`captra plot`: how a track went, in one picture."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from clients.history import History

STAGE_COLOURS = {"queue": "tab:gray", "sample": "tab:green", "infer": "tab:orange", "solve": "tab:purple"}
"""Where the time of a frame goes."""
Curve = tuple[str, Any, str]


def plot(
    file: Annotated[
        Path, typer.Argument(help="*.mcap of a session, or *.json of results.", exists=True, dir_okay=False)
    ],
    out: Annotated[Path | None, typer.Option(help="Picture to write. [default: the file's name with .png]")] = None,
    truth: Annotated[
        Path | None,
        typer.Option(
            help="Recording (*.npz) that was played, where the file holds no truth.", exists=True, dir_okay=False
        ),
    ] = None,
) -> None:
    """Draw error (where the truth is known), confidence and latency of a track, with its states behind.

    Example:

        captra plot mug.mcap
    """
    from matplotlib.backend_bases import FigureCanvasBase

    from captra.data.recordings import load_recording
    from captra.outputs import check_writable
    from clients.console import errors_for_people
    from clients.history import history_of

    picture = out or file.with_suffix(".png")
    if picture.suffix.removeprefix(".") not in FigureCanvasBase.get_supported_filetypes():
        raise typer.BadParameter(f"--out {picture} is no picture: name a file that ends in .png, .pdf or .svg")
    with errors_for_people():
        check_writable(picture)
        history = history_of(file, None if truth is None else load_recording(truth))
    draw(history, file.stem, picture)
    typer.echo(f"{picture}: {len(history.results)} results" + ("" if history.truth else ", without truth"))


def draw(history: "History", title: str, picture: Path) -> None:
    """One panel a quantity, over the frames' numbers in order."""
    from matplotlib.figure import Figure

    from captra.evaluation.state_bands import legend_of, shade

    panels = list(panels_of(history))
    states = [result.state for result in history.results]
    figure = Figure(figsize=(10, 2.2 * len(panels)), layout="constrained")
    for axes, (label, top, curves) in zip(figure.subplots(len(panels), 1, sharex=True), panels, strict=True):
        shade(axes, states, first=0)
        for name, values, colour in curves:
            axes.plot(range(len(states)), values, label=name, color=colour, linewidth=1.3)
        axes.set(ylabel=label, xlim=(-0.5, len(states) - 0.5), ylim=(0, top))
        if len(curves) > 1:
            axes.legend(fontsize="small", ncols=len(curves), loc="upper right")
    figure.legend(handles=legend_of(states), fontsize="small", ncols=4, loc="outside lower center")
    figure.axes[0].set_title(title)
    figure.axes[-1].set_xlabel("result")
    figure.savefig(picture, dpi=100)


def panels_of(history: "History") -> Iterator[tuple[str, float | None, list[Curve]]]:
    """Label, upper bound and curves of each panel."""
    from captra.evaluation.state_bands import PART_COLOURS

    errors = history.errors()
    if errors is not None:
        names = [part.name for part in history.results[0].parts]
        for label, values in zip(("rotation error, °", "translation error, cm"), errors, strict=True):
            yield label, None, [(*part, colour) for *part, colour in zip(names, values.T, PART_COLOURS, strict=False)]
    yield "confidence", 1.02, [("confidence", [result.confidence for result in history.results], "tab:blue")]
    timings = [result.timing_ms for result in history.results]
    stages = [(stage, [getattr(each, stage) for each in timings], colour) for stage, colour in STAGE_COLOURS.items()]
    yield "latency, ms", None, [("total", [each.total for each in timings], "black"), *stages]

"""What a person sees in the terminal while poses come in."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol, Self

import typer
from rich import box
from rich.console import Console
from rich.live import Live
from rich.table import Table

from captra.errors import UserError
from captra.health import State
from clients.results import Result

COLOURS = {State.TRACKING: "green", State.UNCERTAIN: "yellow", State.LOST: "red", State.RECOVERING: "yellow"}
LINE_EVERY = 10
REFRESHES_PER_SECOND = 8


class View(Protocol):
    """Something that shows results; used with `with`."""

    def __call__(self, result: Result) -> None:
        """Show one more result."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *exception: object) -> None: ...


class LivePoses:
    """For terminals: a table that is redrawn in place."""

    def __init__(self, console: Console) -> None:
        self._live = Live(console=console, refresh_per_second=REFRESHES_PER_SECOND)

    def __call__(self, result: Result) -> None:
        """Show the newest poses."""
        self._live.update(pose_table(result))

    def __enter__(self) -> Self:
        self._live.start()
        return self

    def __exit__(self, *exception: object) -> None:
        self._live.stop()


class PoseLines:
    """For logs and pipes: a line for every tenth frame and for every change of state."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._state: State | None = None
        self._seen = 0

    def __call__(self, result: Result) -> None:
        """Print a line when there is something to say."""
        if self._seen % LINE_EVERY == 0 or result.state is not self._state:
            self._console.print(pose_line(result), soft_wrap=True, highlight=False)
        self._state = result.state
        self._seen += 1

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exception: object) -> None:
        """Nothing to put back."""


def view_for(console: Console) -> View:
    """The view that suits where the output goes."""
    return LivePoses(console) if console.is_terminal else PoseLines(console)


def pose_table(result: Result) -> Table:
    """One row a part, and the state in its colour above."""
    colour = COLOURS[result.state]
    table = Table(
        title=f"frame {result.seq}  [{colour}]{result.state}[/{colour}]  confidence {result.confidence:.2f}",
        title_justify="left",
        box=box.SIMPLE_HEAD,
    )
    for heading in ("part", "translation, m", "quat_xyzw", "size, m"):
        table.add_column(heading, no_wrap=True)
    for part in result.parts:
        table.add_row(part.name, numbers(part.translation), numbers(part.quat_xyzw, "5.2f"), numbers(part.size, ".3f"))
    return table


def pose_line(result: Result) -> str:
    """State and centres in one line."""
    centres = "; ".join(f"{part.name} at {numbers(part.translation)} m" for part in result.parts)
    return f"frame {result.seq:4d}  {result.state:10s} {result.confidence:4.2f}  {centres}"


def numbers(values: tuple[float, ...], form: str = "6.3f") -> str:
    """Side by side; metres have three decimals, which are millimetres."""
    return " ".join(format(value, form) for value in values)


@contextmanager
def errors_for_people() -> Iterator[None]:
    """End the command with the message of an expected error, without a traceback."""
    try:
        yield
    except UserError as error:
        typer.echo(f"captra: {error}", err=True)
        raise typer.Exit(1) from error

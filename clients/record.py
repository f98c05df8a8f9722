"""`captra record`: what sessions of a running service do, in MCAP files."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import Event
from typing import Annotated

import typer

from clients.cli import Url


def record(
    sessions: Annotated[
        list[str] | None, typer.Argument(metavar="[SESSION]...", help="Ids of sessions. [default: all, also new ones]")
    ] = None,
    out: Annotated[Path, typer.Option(help="Folder of the files, one a session.", file_okay=False)] = Path(),
    seconds: Annotated[float | None, typer.Option(help="How long. [default: until Ctrl-C]", min=0)] = None,
    url: Url = None,
) -> None:
    """Listen to sessions that others have opened, and write clouds, results and events into *.mcap files.

    SIGTERM ends it as Ctrl-C does: every file is completed.

    Foxglove and Rerun open them, `captra track` replays them, `captra plot` draws them.

    Example:

        captra record --out recordings
    """
    from contextlib import closing, suppress

    from clients.console import errors_for_people
    from clients.listening import listen_to
    from clients.rest import RestApi

    out.mkdir(parents=True, exist_ok=True)
    with (
        errors_for_people(),
        closing(RestApi(url)) as api,
        suppress(KeyboardInterrupt),
        stopped_by_signals() as stopped,
    ):
        listen_to(api, sessions or [], out, typer.echo, seconds, stopped)


@contextmanager
def stopped_by_signals() -> Iterator[Event]:
    """An event that SIGTERM or Ctrl-C sets, so that what is being written is written whole; a second one interrupts."""
    stopped = Event()

    def stop(*_: object) -> None:
        if stopped.is_set():
            raise KeyboardInterrupt
        stopped.set()

    # Also SIGINT, which a background job of a shell is started with ignored.
    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield stopped
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)

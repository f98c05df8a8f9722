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

    from captra.outputs import check_folder
    from clients.console import errors_for_people
    from clients.listening import listen_to
    from clients.rest import RestApi

    with errors_for_people(), suppress(KeyboardInterrupt), stopped_by_signals() as stopped:
        check_folder(out)
        with closing(RestApi(url)) as api:
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

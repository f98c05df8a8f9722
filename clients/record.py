"""`captra record`: what sessions of a running service do, in MCAP files."""

from pathlib import Path
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

    Foxglove and Rerun open them, `captra track` replays them, `captra plot` draws them.

    Example:

        captra record --out recordings
    """
    from contextlib import closing, suppress

    from clients.console import errors_for_people
    from clients.listening import listen_to
    from clients.rest import RestApi

    out.mkdir(parents=True, exist_ok=True)
    with errors_for_people(), closing(RestApi(url)) as api, suppress(KeyboardInterrupt):
        listen_to(api, sessions or [], out, typer.echo, seconds)

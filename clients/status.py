"""`captra status`: whether a service is there, what it can track, and what it tracks."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

import typer

from clients.cli import Url

TIMEOUT_S = 4.0


def status(
    url: Url = None,
    quiet: Annotated[bool, typer.Option("--quiet", help="Print nothing but what is wrong.")] = False,
) -> None:
    """Say whether a service is ready, which categories it can track, and how its sessions are.

    Ends with status 0 only if it is ready. The first thing to try when no poses come.

    Example:

        captra status --url http://robot:8080
    """
    from contextlib import closing

    from rich.console import Console

    from clients.console import errors_for_people
    from clients.rest import RestApi

    with errors_for_people(), closing(RestApi(url, TIMEOUT_S)) as api:
        api.check_ready()
        if quiet:
            return
        console = Console(highlight=False)
        console.print(f"The service at {api.url} is ready.")
        console.print(*models_as_text(api.models()), *sessions_as_text(api.sessions()), sep="\n")


def models_as_text(models: Sequence[Mapping[str, Any]]) -> list[str]:
    """What can be tracked, a line a category."""
    lines = [
        f"  {model['category']}: {model['error'] or '{precision} weights, run by {provider}'.format(**model)}"
        for model in models
    ]
    return ["Categories:", *lines]


def sessions_as_text(sessions: Sequence[Mapping[str, Any]]) -> list[str]:
    """The open sessions, a line each."""
    lines = [
        f"  {session['session_id']}: {session['category']}, {session['state']}, "
        f"{counters['processed']} of {counters['received']} frames processed, {counters['dropped']} dropped, "
        f"{counters['rejected']} rejected"
        + "".join(f" ({number} × {reason})" for reason, number in counters["rejected_by_reason"].items())
        for session in sessions
        for counters in (session["counters"],)
    ]
    return ["Sessions:", *lines] if lines else ["No session is open."]

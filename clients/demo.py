"""`captra demo`: starts a service as a user would and tracks a recording with it."""

from pathlib import Path
from typing import Annotated

import typer

from captra.shipped import RECORDINGS
from clients.cli import Pace, ProfileName

COFFEE_MUG = RECORDINGS / "mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"


def demo(
    recording: Annotated[
        Path, typer.Option(help="What to track, *.npz.", exists=True, dir_okay=False, show_default="a coffee mug")
    ] = COFFEE_MUG,
    as_fast_as_possible: Pace = False,
    profile: ProfileName = None,
) -> None:
    """Start a service, track a recorded coffee mug with it, and stop it again.

    Nothing needs to run before. Ends with status 0 only if the track held: no frame lost, the last one tracking, and
    the last pose within 10° and 5 cm of the truth.

    Example:

        captra demo --as-fast-as-possible
    """
    from rich.console import Console

    from captra.data.recordings import load_recording
    from clients.console import errors_for_people, view_for
    from clients.playback import play_through
    from clients.report import advice, failure, table_of
    from clients.service_process import ServiceProcess

    console = Console()
    with errors_for_people():
        played = load_recording(recording)
        console.print("Starting the service (the first time it compiles its kernels)…")
        with ServiceProcess() as service:
            console.print(f"It is ready at {service.url}: opening a session for a {played.category.name}.")
            with view_for(console) as view:
                playback = play_through(
                    service.url, played, view, as_fast_as_possible=as_fast_as_possible, profile=profile
                )
    console.print(table_of(playback), advice(playback) or "", sep="\n", highlight=False)
    reason = failure(playback)
    console.print("The track held." if reason is None else f"The track did not hold: {reason}.", highlight=False)
    raise typer.Exit(0 if reason is None else 1)

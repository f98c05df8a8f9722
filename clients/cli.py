"""`captra track`: plays a recording through a running service."""

from pathlib import Path
from typing import Annotated, Literal

import typer

Url = Annotated[
    str | None, typer.Option(help="Address of the service. [default: $CAPTRA_URL or http://127.0.0.1:8080]")
]
Pace = Annotated[
    bool,
    typer.Option(
        "--as-fast-as-possible/--realtime",
        help="Send each cloud when the one before is answered, or at the camera's frame rate.",
    ),
]
ProfileName = Annotated[str | None, typer.Option(help="Sampling budget: realtime or paper. [default: the service's]")]
EncodingName = Annotated[Literal["i16", "f32"], typer.Option(help="How clouds are sent.")]


def track(
    recordings: Annotated[
        list[Path], typer.Argument(metavar="RECORDING...", help="Recordings, *.npz.", exists=True, dir_okay=False)
    ],
    url: Url = None,
    as_fast_as_possible: Pace = False,
    profile: ProfileName = None,
    encoding: EncodingName = "i16",
) -> None:
    """Play recordings through a running service and compare the poses with the truth; several end with their mean.

    Example:

        captra track recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz
    """
    from rich.console import Console

    from captra.data.recordings import load_recording
    from captra.evaluation.table import WIDTH
    from clients.console import errors_for_people, view_for
    from clients.playback import play_through
    from clients.report import means_of, table_of

    console, playbacks = Console(), []
    for path in recordings:
        with errors_for_people(), view_for(console) as view:
            playback = play_through(
                url,
                load_recording(path),
                view,
                as_fast_as_possible=as_fast_as_possible,
                profile=profile,
                encoding=encoding,
            )
        console.print(table_of(playback))
        playbacks.append(playback)
    if len(playbacks) > 1:
        Console(width=WIDTH).print(means_of(playbacks))

"""`captra track`: plays a recording through a running service."""

from collections.abc import Sequence
from itertools import product
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
ProfileName = Annotated[
    Literal["realtime", "paper"] | None,
    typer.Option(metavar="NAME", help="Sampling budget: realtime or paper. [default: the service's]"),
]
EncodingName = Annotated[Literal["i16", "f32"], typer.Option(help="How clouds are sent.")]
Record = Annotated[Path | None, typer.Option(help="Write the session into this *.mcap file; of several, one each.")]


def track(
    recordings: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDING...",
            help="Recordings: *.npz with ground truth, or *.mcap of sessions.",
            exists=True,
            dir_okay=False,
        ),
    ],
    url: Url = None,
    as_fast_as_possible: Pace = False,
    profile: ProfileName = None,
    encoding: EncodingName = "i16",
    record: Record = None,
) -> None:
    """Play recordings through a running service and compare the poses with the truth; several end with their mean.

    An *.mcap file of a session is replayed as it went, and its poses are compared with those in the file.

    Example:

        captra track recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz
    """
    from rich.console import Console

    from captra.data.recordings import load_recording
    from captra.evaluation.table import WIDTH
    from captra.recording.reader import is_mcap
    from clients.console import errors_for_people, view_for
    from clients.playback import play_through
    from clients.replay import replay
    from clients.report import advice, means_of, table_of

    console, playbacks = Console(), []
    with errors_for_people():
        check_apart(record, recordings)
    sessions = [path for path in recordings if is_mcap(path)]
    for path in sessions:
        with errors_for_people(), view_for(console) as view:
            pairs = replay(url, path, view)
        same = sum(pair.identical for pair in pairs)
        console.print(f"{path}: {len(pairs)} frames replayed, {same} with the same pose to the last digit")
    for path in [path for path in recordings if path not in sessions]:
        with errors_for_people(), view_for(console) as view:
            playback = play_through(
                url,
                load_recording(path),
                view,
                as_fast_as_possible=as_fast_as_possible,
                profile=profile,
                encoding=encoding,
                record=file_for(record, path, len(recordings)),
            )
        console.print(table_of(playback), advice(playback) or "", sep="\n", highlight=False)
        playbacks.append(playback)
    if len(playbacks) > 1:
        Console(width=WIDTH).print(means_of(playbacks))


def check_apart(record: Path | None, recordings: Sequence[Path]) -> None:
    """Make sure that nothing which is played is recorded over.

    Raises:
        RecordingError: a recording would be.
    """
    from captra.data.recordings import RecordingError

    targets = [target for path in recordings if (target := file_for(record, path, len(recordings))) is not None]
    for target, path in product(targets, recordings):
        if target.exists() and target.samefile(path):
            raise RecordingError(f"--record {record} would overwrite {path}, which is to be played: name another file")


def file_for(record: Path | None, recording: Path, count: int) -> Path | None:
    """Where one of `count` recordings is recorded: several go into files that also bear their names."""
    if record is None or count == 1:
        return record
    return record.with_name(f"{record.stem}__{recording.stem}{record.suffix}")

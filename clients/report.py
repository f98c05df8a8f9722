"""The table at the end of a played recording, and whether the track held."""

from collections.abc import Iterator, Sequence

import numpy as np
from rich.table import Table

from captra import metrics
from captra.evaluation.scoring import SequenceScore, score
from captra.evaluation.summary import average, summarize
from captra.evaluation.table import table as summary_table
from captra.health import State
from clients.playback import Playback

HELD_DEG = 10.0
HELD_CM = 5.0
SPARSE = 0.5
"""Share of answered frames below which drops spoil a track."""

Row = tuple[str, str]


def table_of(playback: Playback) -> Table:
    """Frames, states, errors against the truth, rates and latencies of one playback."""
    table = Table(title=playback.recording.name, title_justify="left")
    table.add_column("measure")
    table.add_column("value", justify="right")
    for section in (track_rows, accuracy_rows, speed_rows):
        for measure, value in section(playback):
            table.add_row(measure, value)
        table.add_section()
    return table


def means_of(playbacks: Sequence[Playback]) -> Table:
    """One row a recording, and their mean."""
    rows = [summarize(score(playback.recording, playback.poses())) for playback in playbacks]
    return summary_table([*rows, average(f"all: mean of {len(rows)} recordings", rows)], "through the service")


def track_rows(playback: Playback) -> Iterator[Row]:
    """How many frames were answered and in which states."""
    results = playback.results
    yield "frames sent / answered", f"{len(playback.recording)} / {len(results)}"
    if playback.rejections:
        yield "frames rejected", str(len(playback.rejections))
    if not results:
        return
    yield "state at the end", f"{results[-1].state} (confidence {results[-1].confidence:.2f})"
    counts = {state: sum(result.state is state for result in results) for state in State}
    yield "frames by state", ", ".join(f"{count} {state}" for state, count in counts.items() if count)


def accuracy_rows(playback: Playback) -> Iterator[Row]:
    """Errors of each part; the first frame is given and not scored."""
    category = playback.recording.category
    scored = score(playback.recording, playback.poses())
    for part, name in enumerate(category.parts):
        yield from part_rows(scored, part, f"{name}: " if len(category.parts) > 1 else "")
    for joint, errors in zip(category.joints, scored.joint_error.T, strict=True):
        unit = "°" if joint.kind == "revolute" else " cm"
        yield f"{joint.name}: joint error, mean", f"{errors.mean():.1f}{unit}"
    if not category.symmetric and scored.symmetric.any():
        yield "frames whose yaw cannot be seen", f"{scored.symmetric.sum()} (scored as symmetric)"


def part_rows(scored: SequenceScore, part: int, prefix: str) -> Iterator[Row]:
    """Errors of one part."""
    rotation, translation = scored.rotation_deg[:, part], scored.translation_cm[:, part]
    yield f"{prefix}rotation error, mean / worst", f"{rotation.mean():.1f}° / {rotation.max():.1f}°"
    yield f"{prefix}translation error, mean / worst", f"{translation.mean():.2f} cm / {translation.max():.2f} cm"
    yield f"{prefix}5°5cm", f"{100 * scored.within_5deg_5cm[:, part].mean():.1f} %"
    yield f"{prefix}IoU, oriented / NOCS", f"{scored.iou[:, part].mean():.3f} / {scored.iou_nocs[:, part].mean():.3f}"


def speed_rows(playback: Playback) -> Iterator[Row]:
    """Frames a second and latencies."""
    yield "frames per second", f"{len(playback.results) / playback.elapsed_s:.1f}"
    if not playback.results:
        return
    round_trips = [r.round_trip_ms for r in playback.results if r.round_trip_ms is not None]
    yield "latency put → pose, p50 / p95 / p99", percentiles(round_trips)
    yield "of which in the service", percentiles([result.timing_ms.total for result in playback.results])


def percentiles(milliseconds: Sequence[float]) -> str:
    """p50 / p95 / p99."""
    values = np.percentile(milliseconds, (50, 95, 99))
    return " / ".join(f"{value:.1f}" for value in values) + " ms"


def advice(playback: Playback) -> str | None:
    """What to do where so many frames went unanswered that the object leaps from one to the next."""
    sent, answered = len(playback.recording), len(playback.results) + len(playback.rejections)
    if answered >= SPARSE * sent:
        return None
    return (
        f"Only {answered} of {sent} frames were answered: the service does not keep up with this rate, and what moves "
        "far between two answers is hard to follow. --as-fast-as-possible waits for each answer; captra bench tells "
        "where the time goes."
    )


def failure(playback: Playback) -> str | None:
    """Why the track did not hold, or None when it did.

    It held when the service called no frame lost, calls the last one tracking, and the last pose of every part is
    within 10° and 5 cm of the truth.
    """
    if not playback.results:
        return "not one frame was answered"
    lost = sum(result.state is State.LOST for result in playback.results)
    if lost:
        return f"the service called {lost} of {len(playback.results)} frames lost"
    if playback.results[-1].state is not State.TRACKING:
        return f"the last frame is {playback.results[-1].state}"
    scored = score(playback.recording, playback.poses())
    rotation, translation = scored.rotation_deg[-1], scored.translation_cm[-1]
    if not metrics.within(rotation, translation, HELD_DEG, HELD_CM).all():
        return f"the last pose is off by {rotation.max():.1f}° and {translation.max():.1f} cm"
    return None

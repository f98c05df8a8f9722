"""Plays a recording into a session, as the camera did or as fast as the service answers."""

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from captra.data.recordings import Recording, RecordingError
from captra.geometry import Pose
from clients.errors import NoResultError
from clients.packing import Frame
from clients.recorder import recorder_for
from clients.results import Event, Result
from clients.session import Session, open_session

FEWEST_FRAMES = 2
"""The pose of the first frame is given, and the stamps of two make a rate."""


@dataclass(frozen=True)
class Playback:
    """What came back."""

    recording: Recording
    """What was played."""
    results: tuple[Result, ...]
    """In the order of arrival; fewer than frames where the service dropped some."""
    rejections: tuple[Event, ...]
    """Clouds that the service could not use."""
    elapsed_s: float
    """From the first cloud sent to the last result."""

    def poses(self) -> list[Pose]:
        """The pose known at each frame but the first, which is given: a frame without a result keeps the one before."""
        frame_of = {int(stamp): frame for frame, stamp in enumerate(self.recording.stamps_ns)}
        result_of = {frame_of[result.stamp_ns]: result for result in self.results}
        poses = [result_of[0].pose if 0 in result_of else self.recording.init]
        for frame in range(1, len(self.recording)):
            poses.append(result_of[frame].pose if frame in result_of else poses[-1])
        return poses[1:]


def frame_rate_hz(recording: Recording) -> float:
    """Frames a second of the camera, from the median distance of the stamps."""
    return float(1e9 / np.median(np.diff(recording.stamps_ns)))


def frames(recording: Recording) -> Iterator[Frame]:
    """The clouds with their stamps."""
    for cloud, stamp_ns in zip(recording.clouds, recording.stamps_ns, strict=True):
        yield Frame(cloud, int(stamp_ns))


def play(
    session: Session,
    recording: Recording,
    rate_hz: float | None,
    watch: Callable[[Result], None],
) -> Playback:
    """Stream a recording over Zenoh; `rate_hz` None waits for each result before the next cloud goes out.

    Raises:
        NoResultError: the service stopped answering.
    """
    results: list[Result] = []
    events: list[Event] = []
    started = time.perf_counter()
    for result in session.track(frames(recording), rate_hz=rate_hz, on_event=events.append):
        results.append(result)
        watch(result)
    elapsed_s = time.perf_counter() - started
    return Playback(recording, tuple(results), rejected(events), elapsed_s)


def play_through(
    url: str | None,
    recording: Recording,
    watch: Callable[[Result], None],
    *,
    as_fast_as_possible: bool,
    profile: str | None = None,
    encoding: str = "i16",
    record: Path | None = None,
) -> Playback:
    """Play a recording in a session of its own, at the camera's rate or as fast as the service answers.

    Raises:
        RecordingError: there is nothing to play in it.
        NoResultError: not one frame had a result.
    """
    if len(recording) < FEWEST_FRAMES:
        raise RecordingError(
            f"{recording.name} holds {len(recording)} frames: at least {FEWEST_FRAMES} are needed, for the pose of the "
            "first is given; record it again while the object is in view"
        )
    rate_hz = None if as_fast_as_possible else frame_rate_hz(recording)
    recorder = recorder_for(record)
    recorder.truth(recording)
    with (
        closing(recorder),
        open_session(
            recording.category.name, recording.init, url=url, profile=profile, encoding=encoding, record=recorder
        ) as session,
    ):
        playback = play(session, recording, rate_hz, watch)
    if not playback.results:
        why = playback.rejections[-1].detail if playback.rejections else "captra status says how the service is"
        raise NoResultError(f"not one of the {len(recording)} frames of {recording.name} had a result: {why}")
    return playback


def rejected(events: Sequence[Event]) -> tuple[Event, ...]:
    """The events that say that a cloud was of no use."""
    return tuple(event for event in events if event.kind == "rejected")

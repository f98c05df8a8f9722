"""A recording that cannot be written is told from one that is whole, and ends without its session."""

from collections.abc import Mapping
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import numpy as np

from captra.observations import Crop, Observation, PointCloud
from captra.recording.reader import messages
from captra.recording.writer import SessionWriter
from service.envelopes import Envelope, NumberedHeader
from service.recording.tape import McapTape
from tests.service.support import F32, TIMEOUT_S, blob, f32

BODY: Mapping[str, Any] = {"category": "mug"}
LARGE = f32(np.random.default_rng(0).normal(size=(200_000, 3)))
"""More than a chunk, so that it is written at once."""


class Unshowable(PointCloud):
    """Meets a defect when it is drawn."""

    def whole(self) -> Crop:
        raise ValueError("a defect")


def has_room(size_bytes: int) -> str | None:
    """For a file of any size."""
    return None


def tape_to(path: Path) -> tuple[McapTape, "SimpleQueue[str]"]:
    """A tape, and how it ended."""
    ends: SimpleQueue[str] = SimpleQueue()
    writer = SessionWriter(path)
    return McapTape(writer, BODY, has_room, lambda: ends.put("whole"), lambda: ends.put("broken"), path.name), ends


def put(tape: McapTape, seq: int, payload: bytes, observation: Observation) -> None:
    tape.frame(NumberedHeader(seq, seq, None), Envelope(F32, payload, None, 0.0), b"", observation)


def test_a_full_disk_breaks_a_recording_off_at_once() -> None:
    tape, ends = tape_to(Path("/dev/full"))
    put(tape, 0, LARGE, PointCloud.of(blob()))
    assert ends.get(timeout=TIMEOUT_S) == "broken"
    put(tape, 1, LARGE, PointCloud.of(blob()))
    tape.close()
    assert ends.empty()


def test_a_disk_that_is_full_at_the_end_breaks_a_recording_off() -> None:
    tape, ends = tape_to(Path("/dev/full"))
    put(tape, 0, f32(blob()), PointCloud.of(blob()))
    tape.close()
    assert ends.get(timeout=TIMEOUT_S) == "broken"


def test_a_defect_ends_a_recording_and_what_came_before_is_whole(tmp_path: Path) -> None:
    tape, ends = tape_to(tmp_path / "session.mcap")
    put(tape, 0, f32(blob()), PointCloud.of(blob()))
    put(tape, 1, f32(blob()), Unshowable(*np.zeros((3, 1, 1), np.float32)))
    put(tape, 2, f32(blob()), PointCloud.of(blob()))
    tape.close()
    assert ends.get(timeout=TIMEOUT_S) == "whole"
    assert [body["seq"] for name, body in messages(tmp_path / "session.mcap") if name == "captra.Frame"] == [0]

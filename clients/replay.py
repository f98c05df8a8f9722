"""Plays the recording of a session through the service once more, and compares the poses to the last digit."""

import base64
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import orjson
from mcap.exceptions import McapError
from mcap.reader import make_reader

from captra.data.recordings import RecordingError
from clients.recorder import FRAME, RESET, RESULT, SESSION
from clients.rest import RestApi
from clients.results import Result, parse_result


@dataclass(frozen=True)
class RecordedFrame:
    """What went to the service."""

    seq: int
    """Its number."""
    stamp_ns: int
    """Its stamp."""
    encoding: str
    """Of the payload."""
    payload: bytes
    """The cloud or image."""
    region: bytes
    """Its mask or box, packed as in an attachment; empty where it had none."""


@dataclass(frozen=True)
class Replayed:
    """One frame, then and now."""

    recorded: Result
    """What the service said when the file was written."""
    replayed: Result
    """What it says now."""

    @property
    def identical(self) -> bool:
        """Whether every digit of every part, joint and confidence is the same."""
        then, now = self.recorded, self.replayed
        return (then.parts, then.joints, then.confidence, then.state) == (
            now.parts,
            now.joints,
            now.confidence,
            now.state,
        )


def messages(path: Path) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Schema name and content of our own messages, in the order of writing.

    Raises:
        RecordingError: the file is no recording of a session.
    """
    try:
        with path.open("rb") as file:
            for schema, _, message in make_reader(file).iter_messages(log_time_order=False):
                if schema is not None and schema.name.startswith("captra."):
                    yield schema.name, orjson.loads(message.data)
    except (McapError, orjson.JSONDecodeError) as error:
        raise RecordingError(f"{path} is no whole MCAP recording ({error}): record it again") from error


def replay(url: str | None, path: Path, watch: Callable[[Result], None]) -> list[Replayed]:
    """Send every frame that had a result to a new session that starts as the recorded one did.

    Raises:
        RecordingError: the file holds no session.
        RequestRefusedError: the service cannot open such a session, or refuses a frame that it once took.
    """
    frames: dict[int, RecordedFrame] = {}
    pairs: list[Replayed] = []
    session_id: str | None = None
    with closing(RestApi(url)) as api:
        try:
            for name, body in messages(path):
                if name == SESSION:
                    session_id = api.post_session(body)["session_id"]
                elif name == FRAME:
                    frames[body["seq"]] = frame_of(body)
                elif name == RESET and session_id is not None:
                    api.put_pose(session_id, body)
                elif name == RESULT and session_id is not None and body["seq"] in frames:
                    pairs.append(again(api, session_id, frames.pop(body["seq"]), parse_result(body)))
                    watch(pairs[-1].replayed)
        finally:
            if session_id is not None:
                api.delete(session_id)
    if session_id is None:
        raise RecordingError(f"{path} holds no session of captra: record one with open_session(..., record=...)")
    return pairs


def frame_of(body: Mapping[str, Any]) -> RecordedFrame:
    """A frame as it was recorded."""
    payload, region = (base64.b64decode(body.get(name, "")) for name in ("payload", "mask"))
    return RecordedFrame(body["seq"], body["stamp_ns"], body["encoding"], payload, region)


def again(api: RestApi, session_id: str, frame: RecordedFrame, recorded: Result) -> Replayed:
    """One frame through the service."""
    answer = api.post_frame(
        session_id, frame.payload, frame.encoding, seq=frame.seq, stamp_ns=frame.stamp_ns, region=frame.region
    )
    return Replayed(recorded, parse_result(answer))

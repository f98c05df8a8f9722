"""Plays the recording of a session through the service once more, and compares the poses to the last digit."""

import base64
from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from captra.data.recordings import RecordingError
from captra.recording.reader import messages
from captra.recording.writer import EVENT, FRAME, RESET, RESULT, SESSION
from clients.errors import RequestRefusedError
from clients.rest import RestApi
from clients.results import Result, parse_result
from clients.tracking import UNSEEN

NO_FRAME = -1


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
class Answer:
    """What became of a frame."""

    looks: int | None
    """How many looks it might take; none in files of services that did not tell."""
    result: Result | None
    """None where nothing was seen near the object."""


@dataclass(frozen=True)
class Replayed:
    """One frame, then and now."""

    recorded: Result
    """What the service said when the file was written."""
    replayed: Result | None
    """What it says now; none where it sees nothing near the object any more."""

    @property
    def identical(self) -> bool:
        """Whether every digit of every part, joint and confidence is the same."""
        then, now = self.recorded, self.replayed
        return now is not None and (then.parts, then.joints, then.confidence, then.state) == (
            now.parts,
            now.joints,
            now.confidence,
            now.state,
        )


def replay(url: str | None, path: Path, watch: Callable[[Result], None]) -> list[Replayed]:
    """Send every frame that the tracker saw to a new session that starts as the recorded one did.

    Raises:
        RecordingError: the file holds no session, or one without results.
        RequestRefusedError: the service cannot open such a session, or refuses a frame that it once took.
    """
    answers = answers_in(path)
    pairs: list[Replayed] = []
    session_id: str | None = None
    frames = 0
    with closing(RestApi(url)) as api:
        try:
            for name, body in messages(path):
                if name == SESSION and session_id is None:
                    session_id = api.post_session(tracked_alike(body))["session_id"]
                elif name == RESET and session_id is not None:
                    api.put_pose(session_id, body)
                elif name == FRAME:
                    frames += 1
                    if session_id is None or frames not in answers:
                        continue
                    then = answers[frames]
                    now = again(api, session_id, frame_of(body), then.looks)
                    if then.result is not None:
                        pairs.append(Replayed(then.result, now))
                        if now is not None:
                            watch(now)
        finally:
            if session_id is not None:
                api.delete(session_id)
    if session_id is None:
        raise RecordingError(
            f"{path} holds no session of captra: record one with open_session(..., record=...), captra record, or the "
            "field `record` when you open it; clients/examples/11_ros2_bag.py tracks through a bag of ROS 2"
        )
    if not pairs:
        raise RecordingError(
            f"{path} holds no frame that had a result, so there is nothing to replay: record while clouds of the "
            "object are sent, and close the session afterwards"
        )
    return pairs


def tracked_alike(body: Mapping[str, Any]) -> dict[str, Any]:
    """A session that is tracked alike: what does not concern its track is left out."""
    return {name: value for name, value in body.items() if name not in {"record", "ros2"}}


def answers_in(path: Path) -> dict[int, Answer]:
    """What became of the frames of a file, counted from one.

    Frames that newer ones replaced, or that were refused for another reason, are not in it. A listener may have heard a
    result before its frame. Where nothing was seen, a result tells the state that changed, before or after the event
    that says so: it is no answer.
    """
    answers: dict[int, Answer] = {}
    frame_by_seq: dict[int, int] = {}
    early: dict[int, Answer] = {}
    frames = 0
    for name, body in messages(path):
        seq: int = body["seq"] if body.get("seq") is not None else NO_FRAME
        if name == RESET:
            early.clear()
        elif name == FRAME:
            frames += 1
            frame_by_seq[seq] = frames
            if seq in early:
                answers[frames] = early.pop(seq)
        elif name == RESULT or (name == EVENT and body.get("reason") in UNSEEN):
            answer = Answer(body.get("looks"), parse_result(body) if name == RESULT else None)
            known, key = (answers, frame_by_seq[seq]) if seq in frame_by_seq else (early, seq)
            if key not in known or answer.result is None:
                known[key] = answer
    return answers


def frame_of(body: Mapping[str, Any]) -> RecordedFrame:
    """A frame as it was recorded."""
    payload, region = (base64.b64decode(body.get(name, "")) for name in ("payload", "mask"))
    return RecordedFrame(body["seq"], body["stamp_ns"], body["encoding"], payload, region)


def again(api: RestApi, session_id: str, frame: RecordedFrame, looks: int | None) -> Result | None:
    """One frame through the service, with as many looks as it might take then; none where it sees nothing."""
    try:
        answer = api.post_frame(
            session_id,
            frame.payload,
            frame.encoding,
            seq=frame.seq,
            stamp_ns=frame.stamp_ns,
            region=frame.region,
            looks=looks,
        )
    except RequestRefusedError as refusal:
        if refusal.reason not in UNSEEN:
            raise
        return None
    return parse_result(answer)

"""Typical mistakes of a program that uses the client, made against a running service: each says what to do next."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from captra.data.recordings import RecordingError
from captra.geometry import Pose
from clients import (
    Camera,
    DepthImage,
    Event,
    FrameRejectedError,
    RequestRefusedError,
    ServiceUnreachableError,
    Session,
    SessionClosedError,
    open_session,
)
from tests.service.support import Running, blob, free_endpoint, running

UNTURNED = np.eye(3)[None]
CENTRE = np.array([[0.0, 0.0, 0.5]])
SIZE = np.full((1, 3), 0.1)


def pose(rotation: np.ndarray = UNTURNED, translation: np.ndarray = CENTRE, size: np.ndarray = SIZE) -> Pose:
    return Pose.from_size(rotation, translation, size)


OPENING: dict[str, tuple[dict[str, Any], type[Exception], str]] = {
    "wrong category": ({"category": "mugg"}, RequestRefusedError, "choose one of bottle, bowl"),
    "no model": ({"category": "bottle"}, RequestRefusedError, "no model of bottle"),
    "wrong number of parts": (
        {"category": "laptop_articulated"},
        RequestRefusedError,
        r"2 parts \(base, display\), 1 are given: give each",
    ),
    "size in millimetres": ({"pose": pose(size=1e3 * SIZE)}, RequestRefusedError, "millimetres by 1000"),
    "far away": ({"pose": pose(translation=1e6 * CENTRE)}, RequestRefusedError, "millimetres by 1000"),
    "flat box": ({"pose": pose(size=SIZE * [1, 0, 1])}, RequestRefusedError, "longer than zero"),
    "mirrored": ({"pose": pose(rotation=-UNTURNED)}, RequestRefusedError, "Mirrored axes"),
    "with scale": ({"pose": pose(rotation=0.1 * UNTURNED)}, RequestRefusedError, "without scale"),
    "one part without its axis": ({"pose": pose(UNTURNED[0], CENTRE[0], SIZE[0])}, ValueError, r"rotation\[None\]"),
    "parts that do not match": ({"pose": pose(rotation=np.tile(UNTURNED, (2, 1, 1)))}, ValueError, "one entry a part"),
    "not seen": ({"pose": pose(translation=np.nan * CENTRE)}, ValueError, "holds NaN .*was the object not seen"),
    "encoding": ({"encoding": "f64"}, ValueError, "use one of i16, f32"),
    "record as the service takes it": ({"record": True}, ValueError, "record_in_service=True"),
    "camera as JSON": ({"camera": {"fx": 590}}, ValueError, r"camera is a clients\.Camera"),
    "smoothing as JSON": ({"smoothing": {}}, ValueError, r"smoothing is a clients\.Smoothing"),
    "profile": ({"profile": "fast"}, RequestRefusedError, "'realtime' or 'paper'"),
    "masks": ({"masks": "objects"}, RequestRefusedError, "'object' or 'parts'"),
    "camera of centimetres": (
        {"camera": Camera(0, 600, 320, 240, 640, 480)},
        RequestRefusedError,
        "/body/camera/fx: .*greater than 0",
    ),
    "large images": (
        {"camera": Camera(600, 600, 960, 540, 1920, 1080)},
        RequestRefusedError,
        "every other row and column .*CAPTRA_MAX_POINTS",
    ),
    "nowhere to record": ({"record": "/dev/null/x.mcap"}, RecordingError, "name a file in a folder"),
    "no scheme": ({"url": "robot:8080"}, ServiceUnreachableError, "write it like http://robot:8080"),
    "no service": ({"url": "http://127.0.0.1:9"}, ServiceUnreachableError, "start one with `captra serve`"),
}


@pytest.mark.parametrize("case", OPENING)
def test_sessions_that_cannot_be_opened(case: str, url: str, service: Running) -> None:
    wrong, error, hint = OPENING[case]
    arguments: dict[str, Any] = {"category": "mug", "pose": pose(), "url": url} | wrong
    with pytest.raises(error, match=hint):
        open_session(**arguments)
    assert service.http.get("/v1/sessions").json()["sessions"] == [], "nothing is left over"


SENDING: dict[str, tuple[Callable[[Session], object], type[Exception], str]] = {
    "empty": (lambda session: session.post(np.zeros((0, 3))), RequestRefusedError, "send at least those around"),
    "no depth at all": (lambda session: session.post(np.full((9, 3), np.nan)), RequestRefusedError, "has no points"),
    "millimetres": (lambda session: session.post(1e3 * blob()), ValueError, "are they millimetres"),
    "another frame": (
        lambda session: list(session.track([blob((1, 0, 0.5))])),
        FrameRejectedError,
        r"frame and units \(metres\), or give a new pose",
    ),
    "depth without camera": (
        lambda session: session.put(DepthImage(np.ones((4, 4), np.uint16))),
        ValueError,
        "intrinsics of the depth images",
    ),
    "text": (lambda session: session.put("cloud.ply"), ValueError, r"a cloud has the shape"),  # type: ignore[arg-type]
}


@pytest.mark.parametrize("case", SENDING)
def test_frames_that_cannot_be_used_leave_the_session_as_it_was(case: str, url: str) -> None:
    attempt, error, hint = SENDING[case]
    with open_session("mug", pose(), url=url) as session:
        with pytest.raises(error, match=hint):
            attempt(session)
        assert session.post(blob()).state == "tracking"


def test_lists_of_numbers_are_clouds_too(url: str) -> None:
    with open_session("mug", pose(), url=url) as session:
        assert session.post(blob().tolist()).state == "tracking"


def test_a_closed_session_says_so_at_once(url: str, service: Running) -> None:
    with open_session("mug", pose(), url=url) as session:
        service.http.delete(f"/v1/sessions/{session.session_id}")
        event = session.receive()
        assert isinstance(event, Event)
        assert event.kind == "closing"
        for attempt in (lambda: session.put(blob()), lambda: session.post(blob()), lambda: session.track([blob()])):
            with pytest.raises(SessionClosedError, match=r"a client closed the session\): open a new one"):
                attempt()
    with open_session("mug", pose(), url=url) as session:
        pass
    with pytest.raises(SessionClosedError, match=r"this client closed it\): open a new one"):
        session.put(blob())


def test_a_router_that_cannot_be_reached() -> None:
    with running("mug", zenoh_advertise=(free_endpoint(),)) as service:
        assert service.service.readiness.wait_prepared(120)
        with pytest.raises(ServiceUnreachableError, match=r"no Zenoh router answers .*CAPTRA_ZENOH_LISTEN"):
            open_session("mug", pose(), url=str(service.http.base_url), timeout_s=0.5)
        assert service.http.get("/v1/sessions").json()["sessions"] == []


def test_stamps_of_a_clock_that_differs_come_back_as_they_are(url: str) -> None:
    with open_session("mug", pose(), url=url) as session:
        stamps = [10**18, 5, -7, 2**62]
        assert [session.post(blob(), stamp).stamp_ns for stamp in stamps] == stamps


def test_what_was_recorded_before_a_mistake_is_kept(url: str, tmp_path: Path) -> None:
    path = tmp_path / "session.mcap"
    with open_session("mug", pose(), url=url, record=path) as session:
        list(session.track([blob()]))
        with pytest.raises(ValueError, match="are they millimetres"):
            session.put(1e3 * blob())
    assert path.stat().st_size > len(blob()) * 6

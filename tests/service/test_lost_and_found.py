"""An object that goes out of sight is reported lost, and found again without anybody's help: over Zenoh."""

import threading
import time
from collections.abc import Callable, Iterator

import numpy as np
import pytest
import zenoh

from captra.categories import CATEGORIES
from tests.service.support import (
    Camera,
    CentreNetworks,
    CentreProvider,
    Inbox,
    Running,
    blob,
    f32,
    inbox,
    running,
    zenoh_client,
)

HIDDEN_FRAMES = 30


class DepthOnly(CentreNetworks):
    """Knows the object by its depth: in what is flat, such as a board, it sees nothing but noise."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        self.doubtful = np.linalg.eigvalsh(np.cov(points_canonical.T))[0] < 1e-3
        return super().coordinates(points_canonical, neighborhoods)


@pytest.fixture(scope="module")
def seeing() -> Iterator[Running]:
    provider = CentreProvider()
    provider.networks["mug"] = DepthOnly(CATEGORIES["mug"])
    with running(provider=provider) as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


@pytest.fixture
def net(seeing: Running) -> Iterator[zenoh.Session]:
    with zenoh_client(seeing.endpoint) as network:
        yield network


def board() -> np.ndarray:
    """What hides the object: flat, close before it, and wider than the ball that is looked at."""
    rng = np.random.default_rng(4)
    return np.asarray(np.c_[rng.uniform(-0.3, 0.3, (4000, 2)), np.full(4000, 0.44)])


def nothing() -> np.ndarray:
    """An empty scene: all that is seen is far away."""
    return np.asarray(blob((0, 0, 3.0)))


def no_points() -> np.ndarray:
    """A crop around the object that has gone: not one point."""
    return np.zeros((0, 3))


class Stream:
    """Puts frame after frame, each once the last is done, and notes the states that subscribers are told."""

    def __init__(self, seeing: Running, net: zenoh.Session) -> None:
        self.opened = seeing.open_session()
        self.poses, self.events = (inbox(net, self.opened["zenoh"][key]) for key in ("pose", "event"))
        self._camera = Camera(net, self.opened["zenoh"]["cloud"])
        self._service, self._seq = seeing, 0

    def put(self, points: np.ndarray) -> None:
        """One frame, and wait until it is tracked or refused."""
        self._camera.put(f32(points), self._seq, stamp_ns=self._seq * 33_000_000)
        self._seq += 1
        deadline = time.monotonic() + 10
        while time.monotonic() < deadline:
            counters = self._service.session(self.opened["session_id"])["counters"]
            if counters["processed"] + counters["rejected"] == self._seq:
                return
            time.sleep(0.002)
        raise AssertionError("the frame was neither tracked nor refused")

    def told(self, inbox_: Inbox) -> list[str]:
        """States in the order they were told."""
        return [inbox_.message(i)["state"] for i in range(len(inbox_))]

    def state_events(self) -> list[str]:
        """New states, as events tell them."""
        bodies = [self.events.message(i) for i in range(len(self.events))]
        return [body["state"] for body in bodies if body["kind"] == "state"]


@pytest.mark.parametrize("hidden_by", [board, nothing, no_points])
@pytest.mark.parametrize("moved_m", [0.0, 0.07])
def test_hidden_object_is_reported_lost_and_found_again(
    seeing: Running, net: zenoh.Session, hidden_by: Callable[[], np.ndarray], moved_m: float
) -> None:
    stream = Stream(seeing, net)
    for _ in range(3):
        stream.put(blob())
    for _ in range(HIDDEN_FRAMES):
        stream.put(hidden_by())
    shown = seeing.session(stream.opened["session_id"])
    assert (shown["state"], shown["last_result"]["state"]) == ("lost", "lost")
    assert shown["last_result"]["confidence"] < 0.05
    assert shown["last_result"]["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=5e-3)
    for _ in range(15):
        stream.put(blob((moved_m, 0, 0.5)))
    result = seeing.session(stream.opened["session_id"])["last_result"]
    assert result["state"] == "tracking"
    assert result["parts"][0]["translation"] == pytest.approx([moved_m, 0, 0.5], abs=5e-3)
    assert stream.state_events() == ["uncertain", "lost", "recovering", "tracking"]
    told = stream.told(stream.poses)
    assert list(dict.fromkeys(told)) == ["tracking", "uncertain", "lost", "recovering"]
    assert told[-1] == "tracking"


@pytest.mark.parametrize(("unseen", "reason"), [(nothing, "no-points-near-object"), (no_points, "empty-cloud")])
def test_track_says_in_the_third_frame_that_it_sees_nothing(
    seeing: Running, net: zenoh.Session, unseen: Callable[[], np.ndarray], reason: str
) -> None:
    stream = Stream(seeing, net)
    stream.put(blob())
    for _ in range(5):
        stream.put(unseen())
    lost = stream.poses.message(2)
    assert (lost["state"], lost["confidence"], lost["seq"], lost["stamp_ns"]) == ("lost", 0.0, 3, 3 * 33_000_000)
    assert stream.events.message(len(stream.events) - 1)["reason"] == reason
    assert len(stream.poses) == 3  # one result for the frame that was tracked, one for each change of state


def test_given_pose_wins_over_a_search_that_is_under_way(seeing: Running, net: zenoh.Session) -> None:
    stream, networks = Stream(seeing, net), seeing.provider.networks["mug"]
    stream.put(blob())
    for _ in range(8):
        stream.put(board())
    networks.asked.clear()
    networks.gate.clear()
    answers: list[dict[str, object]] = []
    session_id = stream.opened["session_id"]
    frame = threading.Thread(target=lambda: seeing.post_frame(session_id, f32(board()), 100))
    frame.start()
    assert networks.asked.wait(10)
    part = {"rotation": {"quat_xyzw": [0, 0, 0, 1]}, "translation": [0.4, 0, 0.5], "size": [0.1, 0.1, 0.1]}
    put = threading.Thread(
        target=lambda: answers.append(seeing.http.put(f"/v1/sessions/{session_id}/pose", json={"parts": [part]}).json())
    )
    put.start()
    networks.gate.set()
    for thread in (frame, put):
        thread.join(10)
    assert answers[0]["state"] == "tracking"
    result = seeing.post_frame(session_id, f32(blob((0.41, 0, 0.5))), 0).json()
    assert result["state"] == "tracking"
    assert result["parts"][0]["translation"] == pytest.approx([0.41, 0, 0.5], abs=5e-3)

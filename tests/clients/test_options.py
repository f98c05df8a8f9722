"""What open_session is asked for reaches the service, over real sockets, and does there what it says."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from captra.categories import CATEGORIES
from captra.geometry import Pose
from captra.recording.reader import messages
from clients import Frame, RequestRefusedError, Ros2, Smoothing, open_session
from clients.options import SessionOptions
from clients.replay import replay
from tests.service.support import Running, blob, running

FRAME_NS = 33_000_000


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recorded")


@pytest.fixture(scope="module")
def service(recorded: Path) -> Iterator[Running]:
    with running("mug", "laptop_articulated", record_dir=recorded) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


def start(category: str) -> Pose:
    parts = CATEGORIES[category].num_parts
    return Pose.from_size(np.tile(np.eye(3), (parts, 1, 1)), np.tile([0, 0, 0.5], (parts, 1)), np.full((parts, 3), 0.1))


def tracked(service: Running, x: list[float], **options: Any) -> tuple[np.ndarray, dict[str, Any]]:
    """Published x of an object that is seen at these, and the session as the service shows it."""
    frames = [Frame(blob((each, 0, 0.5)), FRAME_NS * index) for index, each in enumerate(x)]
    with open_session("mug", start("mug"), url=str(service.http.base_url), **options) as session:
        found = [result.parts[0].translation[0] for result in session.track(frames)]
        return np.array(found), service.session(session.session_id)


def test_smoothing_calms_an_object_that_trembles(service: Running) -> None:
    jitter = [0.004 * (-1) ** i for i in range(20)]
    raw, _ = tracked(service, jitter)
    calm, shown = tracked(service, jitter, smoothing=Smoothing(cutoff_hz=0.5))
    assert shown["smoothing"] == {"cutoff_hz": 0.5, "translation_gain": 10, "rotation_gain": 2}
    assert np.ptp(calm[8:]) < 0.3 * np.ptp(raw[8:])


@pytest.mark.parametrize(("prediction", "follows"), [("none", False), ("constant-velocity", True)])
def test_prediction_follows_what_would_move_out_of_reach(service: Running, prediction: Any, follows: bool) -> None:
    fast = np.cumsum(np.linspace(0.0, 0.15, 20)).tolist()
    frames = [Frame(blob((each, 0, 0.5)), 3 * FRAME_NS * index) for index, each in enumerate(fast)]
    with open_session("mug", start("mug"), url=str(service.http.base_url), prediction=prediction) as session:
        *_, last = session.track(frames, on_event=lambda event: None)
    assert bool(abs(last.parts[0].translation[0] - fast[-1]) < 0.01) == follows


def test_joint_axes_are_told_by_joint(service: Running) -> None:
    laptop = ("laptop_articulated", start("laptop_articulated"))
    url = str(service.http.base_url)
    with open_session(*laptop, url=url, joint_axes={"hinge": np.array([0, 0, 1])}) as session:
        assert service.session(session.session_id)["joint_axes"] == {"hinge": [0, 0, 1]}
    with open_session(*laptop, url=url, joint_axes={}) as session:
        assert service.session(session.session_id)["joint_axes"] == {}
    with pytest.raises(RequestRefusedError, match="laptop_articulated has no joint 'lid'; it has hinge"):
        open_session(*laptop, url=url, joint_axes={"lid": (1, 0, 0)})


def test_the_service_records_where_it_is_asked_to_and_a_replay_does_not(service: Running, recorded: Path) -> None:
    _, shown = tracked(service, [0.0, 0.01], record_in_service=True)
    (path,) = recorded.glob("*.mcap")
    assert path.stem == f"mug_{shown['session_id']}"
    body = {"record": True} | next(dict(body) for name, body in messages(path) if name == "captra.Session")
    assert body["category"] == "mug"
    assert all(pair.identical for pair in replay(str(service.http.base_url), path, lambda _: None))
    assert list(recorded.glob("*.mcap*")) == [path]


def test_what_only_a_node_of_ros_2_can_do_is_refused_by_others(service: Running) -> None:
    with pytest.raises(RequestRefusedError) as refused:
        open_session("mug", start("mug"), url=str(service.http.base_url), ros2=Ros2("/camera/points"))
    assert refused.value.reason == "unsupported-option"


def test_what_is_not_asked_for_is_left_to_the_service() -> None:
    assert SessionOptions().body() == {}
    assert SessionOptions(ros2=Ros2(name="cup"), record=True).body() == {"ros2": {"name": "cup"}, "record": True}

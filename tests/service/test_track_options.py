"""Options of a session: what they change, what is refused, and that they outlive a process."""

from typing import Any

import numpy as np
import orjson
import pytest

from captra.motion import STANDING_STILL, ConstantVelocity
from captra.recovery import NO_SEARCH, TimeBudget
from service.sqlite_store import record_of, settings_json, trusted_json
from service.store import InMemorySessionStore
from service.track_options import Smoothing, TrackOptions
from tests.service.support import Running, blob, f32, running
from tests.service.test_store import record

FRAME_NS = 33_000_000


def track(service: Running, session_id: str, x: list[float], frame_ns: int = FRAME_NS) -> np.ndarray:
    """Published x of an object seen at these; NaN where a frame held nothing near it."""
    answers = [
        service.post_frame(session_id, f32(blob((each, 0, 0.5))), seq, stamp_ns=seq * frame_ns).json()
        for seq, each in enumerate(x)
    ]
    return np.array([answer["parts"][0]["translation"][0] if "parts" in answer else np.nan for answer in answers])


def test_smoothing_calms_an_object_at_rest_and_only_with_stamps_that_rise(service: Running) -> None:
    jitter = [0.004 * (-1) ** i for i in range(20)]
    plain = service.open_session()["session_id"]
    smooth, unstamped = (service.open_session(smoothing={})["session_id"] for _ in range(2))
    raw = track(service, plain, jitter)
    assert np.ptp(track(service, smooth, jitter)[8:]) < 0.3 * np.ptp(raw[8:])
    assert np.ptp(track(service, unstamped, jitter, frame_ns=0)[8:]) == pytest.approx(np.ptp(raw[8:]), rel=0.1)


def test_smoothing_is_never_fed_back(service: Running) -> None:
    session_id = service.open_session(smoothing={"cutoff_hz": 0.01, "translation_gain": 0.0})["session_id"]
    track(service, session_id, [0.02 * i for i in range(8)])
    trusted = service.service.registry.get(session_id)._trusted.pose
    assert trusted.translation[0, 0] == pytest.approx(0.14, abs=3e-3)
    assert service.session(session_id)["last_result"]["parts"][0]["translation"][0] < 0.05


@pytest.mark.parametrize(("prediction", "follows"), [("none", False), ("constant-velocity", True)])
def test_prediction_follows_what_would_move_out_of_reach(service: Running, prediction: str, follows: bool) -> None:
    session_id = service.open_session(prediction=prediction)["session_id"]
    fast = np.cumsum(np.linspace(0.0, 0.15, 20)).tolist()  # in the end further a frame than the crop reaches
    found = track(service, session_id, fast, frame_ns=100_000_000)
    assert bool(abs(found[-1] - fast[-1]) < 0.01) == follows


def test_joint_axes_keep_parts_on_their_joints(service: Running) -> None:
    networks = service.provider.networks["laptop_articulated"]
    free = service.open_session("laptop_articulated")["session_id"]
    held = service.open_session("laptop_articulated", joint_axes={})["session_id"]

    def tilted(points_canonical: np.ndarray, neighborhoods: Any) -> np.ndarray:
        c, s = np.cos(0.1), np.sin(0.1)
        about_y = np.array([c, 0, -s, 0, 1, 0], np.float32)  # the first two columns of a turn that no hinge allows
        unturned = np.array([1, 0, 0, 0, 1, 0], np.float32)
        of_parts = np.stack([unturned, about_y])
        return np.repeat(of_parts[:, None], points_canonical.shape[1], axis=1)

    networks.rotations = tilted  # type: ignore[method-assign]
    turns = [
        service.post_frame(session_id, f32(blob()), 0).json()["parts"][1]["quat_xyzw"] for session_id in (free, held)
    ]
    assert abs(turns[0][1]) > 0.03  # sin 0.05, less what the given pose puts right
    assert abs(turns[1][1]) < 1e-6


@pytest.mark.parametrize(
    ("category", "options", "named"),
    [
        ("mug", {"joint_axes": {"hinge": [1, 0, 0]}}, "mug has no joint 'hinge'"),
        ("laptop_articulated", {"joint_axes": {"hinge": [0, 0, 0]}}, "no direction"),
        ("laptop_articulated", {"joint_axes": {"hinge": [1, 0]}}, "hinge"),
        ("mug", {"smoothing": {"cutoff_hz": 0}}, "cutoff_hz"),
        ("mug", {"smoothing": {"beta": 1}}, "beta"),
        ("mug", {"prediction": "psychic"}, "prediction"),
    ],
)
def test_options_that_cannot_be_honoured_are_refused(
    service: Running, category: str, options: dict[str, Any], named: str
) -> None:
    parts = len(service.service.provider.get(category, "realtime").networks.category.parts)
    part = {"rotation": {"quat_xyzw": [0, 0, 0, 1]}, "translation": [0, 0, 0.5], "size": [0.1, 0.1, 0.1]}
    answer = service.http.post("/v1/sessions", json={"category": category, "parts": [part] * parts} | options)
    assert (answer.status_code, answer.json()["reason"]) == (422, "invalid-request")
    assert named in answer.text


def test_next_process_goes_on_with_the_same_options() -> None:
    store = InMemorySessionStore()
    with running("mug", store=store) as first:
        opened = first.open_session(prediction="constant-velocity", smoothing={"cutoff_hz": 0.5})
    session_id = opened["session_id"]
    with running("mug", store=store, prediction="none") as second:
        assert second.service.readiness.wait_prepared(30)
        session = second.service.registry.get(session_id)
        assert session.record.options == TrackOptions("constant-velocity", Smoothing(0.5, 10.0, 2.0))
        assert isinstance(session._tracker._options.motion, ConstantVelocity)
        jitter = track(second, session_id, [0.004 * (-1) ** i for i in range(20)])
        assert np.ptp(jitter[8:]) < 0.004


def test_sessions_stored_before_there_were_options_have_none() -> None:
    older = orjson.loads(settings_json(record("a")))
    del older["options"]
    assert record_of(orjson.dumps(older), trusted_json(record("a").trusted)).options == TrackOptions()


def test_service_chooses_for_sessions_that_do_not_say() -> None:
    with running("mug", prediction="constant-velocity", search_budget_ms=40) as chosen:
        silent, other = (chosen.open_session(prediction=asked)["session_id"] for asked in (None, "none"))
        trackers = [chosen.service.registry.get(session_id)._tracker for session_id in (silent, other)]
        assert isinstance(trackers[0]._options.motion, ConstantVelocity)
        assert trackers[1]._options.motion is STANDING_STILL
        assert isinstance(trackers[0]._options.search, TimeBudget)
        assert trackers[0]._options.search is not trackers[1]._options.search


def test_no_budget_means_no_search() -> None:
    assert TrackOptions().tracker_options(0).search is NO_SEARCH

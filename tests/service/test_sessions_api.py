"""REST sessions over a real socket: open, look, start again, close."""

import time

import numpy as np
import pytest

from service.rest.inputs import NewSession
from service.rest.outputs import OpenedSession, Result, SessionState
from tests.service.support import F32, I16, STAMP_NS, CentreProvider, Running, blob, f32, running, session_body


def test_post_opens_a_session(service: Running) -> None:
    answer = service.http.post("/v1/sessions", json=session_body("mug", idle_timeout_s=42))
    assert answer.status_code == 201
    opened = answer.json()
    session_id = opened["session_id"]
    assert answer.headers["Location"] == f"/v1/sessions/{session_id}"
    assert set(opened) == {"session_id", "category", "state", "expires_after_s", "encodings", "zenoh", "ros2"}
    assert (opened["category"], opened["state"]) == ("mug", "tracking")
    assert opened["expires_after_s"] == pytest.approx(42, abs=1)
    assert opened["encodings"] == [F32, I16, "application/cdr"]
    assert opened["zenoh"] == {
        "cloud": f"captra/default/sessions/{session_id}/cloud",
        "pose": f"captra/default/sessions/{session_id}/pose",
        "event": f"captra/default/sessions/{session_id}/event",
        "endpoints": [service.endpoint],
        "secret": None,
    }
    OpenedSession.model_validate_json(answer.content)
    assert service.http.get(answer.headers["Location"]).status_code == 200


def test_examples_of_the_document_are_accepted(service: Running) -> None:
    for example in NewSession.model_config["json_schema_extra"]["examples"]:  # type: ignore[index, union-attr]
        assert service.http.post("/v1/sessions", json=example).status_code == 201


def test_get_shows_state_counters_and_last_result(service: Running) -> None:
    opened = service.open_session(frame_id="wrist_camera")
    service.post_frame(opened["session_id"], f32(blob()), seq=3)
    service.post_frame(opened["session_id"], b"", seq=4)
    answer = service.http.get(f"/v1/sessions/{opened['session_id']}")
    shown = answer.json()
    SessionState.model_validate_json(answer.content)
    assert shown["counters"] == {
        "received": 2, "processed": 1, "dropped": 0, "rejected": 1, "rejected_by_reason": {"empty-cloud": 1},
    }  # fmt: skip
    assert (shown["profile"], shown["frame_id"], shown["idle_timeout_s"]) == ("realtime", "wrist_camera", 300)
    assert abs(shown["created_ns"] - time.time_ns()) < 60e9
    assert shown["last_result"]["seq"] == 3
    assert shown["zenoh"] == opened["zenoh"]


def test_list_shows_every_session_oldest_first(service: Running) -> None:
    ids = [service.open_session(category)["session_id"] for category in ("mug", "laptop_articulated", "mug")]
    listed = service.http.get("/v1/sessions").json()["sessions"]
    assert [session["session_id"] for session in listed] == ids
    assert len(set(ids)) == 3


def test_pose_before_the_first_frame_is_the_one_given(service: Running) -> None:
    opened = service.open_session(translation=(0.1, 0.2, 0.7))
    answer = service.http.get(f"/v1/sessions/{opened['session_id']}/pose")
    result = answer.json()
    Result.model_validate_json(answer.content)
    assert (result["seq"], result["stamp_ns"], result["state"]) == (None, None, "tracking")
    assert result["parts"][0]["translation"] == [0.1, 0.2, 0.7]
    assert result["parts"][0]["size"] == [0.1, 0.1, 0.1]


def test_frame_by_http_is_answered_with_its_result(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    answer = service.post_frame(session_id, f32(blob((0.01, 0, 0.5))), seq=7, stamp_ns=STAMP_NS)
    assert answer.status_code == 200
    Result.model_validate_json(answer.content)
    result = answer.json()
    assert (result["session_id"], result["seq"], result["stamp_ns"]) == (session_id, 7, STAMP_NS)
    assert result["parts"][0]["translation"] == pytest.approx([0.01, 0, 0.5], abs=2e-3)
    assert service.http.get(f"/v1/sessions/{session_id}/pose").json() == result


def test_largest_seq_and_most_negative_stamp_come_back_exactly(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    result = service.post_frame(session_id, f32(blob()), seq=2**64 - 1, stamp_ns=-(2**63)).json()
    assert (result["seq"], result["stamp_ns"]) == (2**64 - 1, -(2**63))


def test_put_starts_again_from_a_new_pose(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    service.post_frame(session_id, f32(blob()), seq=100)
    parts = session_body(translation=(0.5, 0, 1.5))["parts"]
    answer = service.http.put(f"/v1/sessions/{session_id}/pose", json={"parts": parts})
    assert answer.status_code == 200
    assert answer.json()["parts"][0]["translation"] == [0.5, 0, 1.5]
    assert service.http.get(f"/v1/sessions/{session_id}/pose").json() == answer.json()
    result = service.post_frame(session_id, f32(blob((0.51, 0, 1.5))), seq=0).json()  # frames are numbered anew
    assert result["parts"][0]["translation"] == pytest.approx([0.51, 0, 1.5], abs=2e-3)
    assert result["seq"] == 0


def test_matrix_and_quaternion_mean_the_same(service: Running) -> None:
    quarter_turn = {"matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}
    same = {"quat_xyzw": [0, 0, np.sqrt(0.5), np.sqrt(0.5)]}
    poses = []
    for rotation in (quarter_turn, same):
        body = session_body()
        body["parts"][0]["rotation"] = rotation
        session_id = service.http.post("/v1/sessions", json=body).json()["session_id"]
        poses.append(service.http.get(f"/v1/sessions/{session_id}/pose").json()["parts"][0]["quat_xyzw"])
    assert poses[0] == pytest.approx(poses[1])
    assert poses[0] == pytest.approx([0, 0, np.sqrt(0.5), np.sqrt(0.5)])


def test_delete_closes(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    assert service.http.delete(f"/v1/sessions/{session_id}").status_code == 204
    for method, path in (("GET", ""), ("DELETE", ""), ("GET", "/pose")):
        answer = service.http.request(method, f"/v1/sessions/{session_id}{path}")
        assert (answer.status_code, answer.json()["reason"]) == (404, "unknown-session")
    assert service.post_frame(session_id, f32(blob())).json()["reason"] == "unknown-session"
    assert service.http.get("/v1/sessions").json() == {"sessions": []}


def test_idle_session_expires_and_frames_put_that_off() -> None:
    with running("mug") as service:
        session_id = service.open_session(idle_timeout_s=0.6)["session_id"]
        deadline = time.monotonic() + 1.2
        seq = 0
        while time.monotonic() < deadline:
            assert service.post_frame(session_id, f32(blob()), seq).status_code == 200
            seq += 1
        remaining = service.session(session_id)["expires_after_s"]
        assert 0 < remaining <= 0.6
        session = service.service.registry.get(session_id)
        while session.liveness.expired() is None:
            time.sleep(0.01)
        while service.http.get(f"/v1/sessions/{session_id}").status_code == 200:
            assert time.monotonic() < deadline + 10
        assert service.metric('captra_sessions{state="tracking"}') == 0


def test_categories_tell_what_can_be_tracked(service: Running) -> None:
    categories = {entry["name"]: entry for entry in service.http.get("/v1/categories").json()["categories"]}
    assert len(categories) == 10
    assert [name for name, entry in categories.items() if entry["trackable"]] == ["mug", "laptop_articulated"]
    laptop = categories["laptop_articulated"]
    assert (laptop["parts"], laptop["root"], laptop["surroundings"]) == (["base", "display"], "base", False)
    assert laptop["joints"][0] == {
        "name": "hinge", "kind": "revolute", "child": "display", "parent": "base", "axis": [-1, 0, 0],
    }  # fmt: skip


def test_models_tell_what_tracks(service: Running) -> None:
    models = service.http.get("/v1/models").json()["models"]
    assert [model["category"] for model in models] == ["mug", "laptop_articulated"]
    assert set(models[0]) == {"category", "precision", "provider", "profiles", "loaded", "error", "manifest"}


def test_ready_turns_true_when_models_are_loaded_and_false_when_the_service_stops() -> None:
    provider = CentreProvider("mug")
    provider.loading.clear()
    with running(provider=provider) as service:
        assert service.http.get("/v1/health/live").json() == {"status": "live"}
        answer = service.http.get("/v1/health/ready")
        assert (answer.status_code, answer.json()["reason"]) == (503, "not-ready")
        assert answer.headers["Content-Type"] == "application/problem+json"
        assert service.metric("captra_ready") == 0
        provider.loading.set()
        assert service.service.readiness.wait_prepared(30)
        assert service.http.get("/v1/health/ready").json() == {"status": "ready"}
        assert service.metric("captra_ready") == 1
        service.service.readiness.stopping()
        assert service.http.get("/v1/health/ready").status_code == 503


def test_event_loop_stays_free_while_a_frame_is_processed(service: Running) -> None:
    networks = service.provider.networks["mug"]
    opened = service.open_session()
    session = service.service.registry.get(opened["session_id"])
    networks.gate.clear()
    import threading

    poster = threading.Thread(target=service.post_frame, args=(opened["session_id"], f32(blob())))
    poster.start()
    assert networks.asked.wait(10)
    assert service.http.get("/v1/health/live").status_code == 200
    assert service.session(opened["session_id"])["counters"]["received"] == 1  # not even the session itself is blocked
    assert session.last_result.seq is None
    networks.gate.set()
    poster.join()
    assert session.last_result.seq == 0


@pytest.mark.parametrize(
    ("endpoint", "host", "expected"),
    [
        ("tcp/127.0.0.1:7447", "robot", "tcp/127.0.0.1:7447"),
        ("tcp/0.0.0.0:7447", "robot", "tcp/robot:7447"),
        ("tcp/[::]:7447", "10.0.0.5", "tcp/10.0.0.5:7447"),
        ("udp/0.0.0.0:7447", "fe80::1", "udp/[fe80::1]:7447"),
    ],
)
def test_endpoint_that_listens_everywhere_is_where_the_client_reached_the_service(
    endpoint: str, host: str, expected: str
) -> None:
    from service.rest.views import reachable

    assert reachable(endpoint, host) == expected

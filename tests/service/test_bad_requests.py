"""Every request that is refused: its status, its reason, its problem, its counter; and the session stays as it was."""

import re
from typing import Any

import httpx
import pytest
import zenoh

from service.networks import Engine
from service.rejections import ModelNotLoadableError
from tests.service.support import CentreProvider, Running, blob, f32, inbox, part_body, running, session_body


def refused(answer: httpx.Response, status: int, reason: str) -> dict[str, Any]:
    """Assert that an answer is the problem that it should be, and that it is counted."""
    assert answer.headers["Content-Type"] == "application/problem+json", answer.text
    problem: dict[str, Any] = answer.json()
    assert (answer.status_code, problem["status"], problem["reason"]) == (status, status, reason), problem
    assert problem["type"] == f"urn:captra:problem:{reason}"
    assert problem["instance"] == answer.request.url.path
    assert problem["title"]
    assert problem["detail"]
    if reason != "internal-error":  # a defect that no frame met is told by the log
        counted = httpx.get(answer.request.url.join("/metrics"), timeout=10).text
        assert re.search(rf'^captra_requests_rejected_total{{reason="{reason}"}} [1-9]', counted, re.MULTILINE)
    return problem


def part(**options: Any) -> list[dict[str, Any]]:
    return [part_body(**options)]


HALF_TURN = [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]

BAD_POSES = [
    ([part_body(), part_body()], "wrong-number-of-parts"),
    (part(rotation={"quat_xyzw": [0, 0, 0, 0]}), "not-a-rotation"),
    (part(rotation={"quat_xyzw": [0, 0, 0, 1.01]}), "not-a-rotation"),
    (part(rotation={"quat_xyzw": [0, 0, 0, 1e300]}), "not-a-rotation"),
    (part(rotation={"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}), "not-a-rotation"),
    (part(rotation={"matrix": [[2, 0, 0], [0, 2, 0], [0, 0, 2]]}), "not-a-rotation"),
    (part(rotation={"matrix": [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]}), "not-a-rotation"),
    (part(rotation={"matrix": [[0, 0, 0], [0, 0, 0], [0, 0, 0]]}), "not-a-rotation"),
    (part(rotation={"matrix": [[1e200, 0, 0], [0, 1, 0], [0, 0, 1]]}), "not-a-rotation"),
    (part(size=[0.1, 0, 0.1]), "size-not-positive"),
    (part(size=[0.1, -0.1, 0.1]), "size-not-positive"),
    (part(size=[120, 90, 80]), "implausible-pose"),
    (part(size=[6, 9, 4.1]), "implausible-pose"),
    (part(size=[1e-300, 0.1, 0.1]), "implausible-pose"),
    (part(translation=[0, 0, 1e5]), "implausible-pose"),
    ([], "invalid-request"),
    (part(rotation={"quat_xyzw": [0, 0, 1]}), "invalid-request"),
    (part(rotation={"matrix": [[1, 0], [0, 1]]}), "invalid-request"),
    (part(rotation={}), "invalid-request"),
    (part(rotation={"quat_xyzw": [0, 0, 0, 1], "matrix": HALF_TURN}), "invalid-request"),
    (part(rotation={"euler": [0, 0, 0]}), "invalid-request"),
    (part(translation=["0", 0, 0]), "invalid-request"),
    (part(translation=[0, 0, True]), "invalid-request"),
    (part(size=None), "invalid-request"),
]


@pytest.mark.parametrize(("parts", "reason"), BAD_POSES)
def test_pose_that_is_none(service: Running, network: zenoh.Session, parts: Any, reason: str) -> None:
    refused(service.http.post("/v1/sessions", json=session_body() | {"parts": parts}), 422, reason)
    assert service.http.get("/v1/sessions").json() == {"sessions": []}
    opened = service.open_session()
    events = inbox(network, opened["zenoh"]["event"])
    path = f"/v1/sessions/{opened['session_id']}/pose"
    before = service.http.get(path).json()
    problem = refused(service.http.put(path, json={"parts": parts}), 422, reason)
    assert service.http.get(path).json() == before
    assert service.metric(f'captra_requests_rejected_total{{reason="{reason}"}}') == 2
    if reason != "invalid-request":
        event = events.message(0)
        assert (event["kind"], event["reason"], event["detail"]) == ("pose-rejected", reason, problem["detail"])


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        ({"category": "unicorn"}, "unknown-category"),
        ({"category": "bottle"}, "category-without-model"),
        ({"masks": True}, "invalid-request"),
        ({"masks": "image"}, "invalid-request"),
        ({"camera": {"fx": 590, "fy": 590, "cx": 320}}, "invalid-request"),
        ({"camera": {"fx": 0, "fy": 590, "cx": 320, "cy": 240}}, "invalid-request"),
        ({"camera": {"fx": 590, "fy": 590, "cx": 320, "cy": 240, "width": 640}}, "invalid-request"),
        ({"camera": {"fx": 590, "fy": 590, "cx": 320, "cy": 240, "distortion": [0.1, 0, 0]}}, "unsupported-option"),
        ({"profile": "turbo"}, "invalid-request"),
        ({"idle_timeout_s": 0}, "invalid-request"),
        ({"idle_timeout_s": 1e9}, "invalid-request"),
        ({"category": 7}, "invalid-request"),
        ({"frame_id": None}, "invalid-request"),
        ({"frames": "camera"}, "invalid-request"),
    ],
)
def test_session_that_cannot_be_opened(service: Running, options: dict[str, Any], reason: str) -> None:
    refused(service.http.post("/v1/sessions", json=session_body() | options), 422, reason)
    assert service.http.get("/v1/sessions").json() == {"sessions": []}
    assert service.metric(f'captra_requests_rejected_total{{reason="{reason}"}}') == 1


class DamagedProvider(CentreProvider):
    """Has a bundle that cannot be loaded."""

    def get(self, category: str, profile: str) -> Engine:
        raise ModelNotLoadableError(f"the model of {category} cannot be loaded: rotation.onnx is damaged")


def test_model_that_cannot_be_loaded() -> None:
    with running(provider=DamagedProvider("mug")) as service:
        assert service.service.readiness.wait_prepared(30)
        problem = refused(service.http.post("/v1/sessions", json=session_body()), 503, "model-not-loadable")
        assert "rotation.onnx" in problem["detail"]
        assert service.http.get("/v1/sessions").json() == {"sessions": []}


def test_unknown_category_names_the_known_ones(service: Running) -> None:
    problem = refused(
        service.http.post("/v1/sessions", json=session_body() | {"category": "cup"}), 422, "unknown-category"
    )
    assert "mug" in problem["detail"]


def test_invalid_request_points_at_every_mistake(service: Running) -> None:
    body = session_body() | {"profile": "turbo"}
    del body["parts"][0]["size"]
    problem = refused(service.http.post("/v1/sessions", json=body), 422, "invalid-request")
    assert {error["pointer"] for error in problem["errors"]} == {"/body/parts/0/size", "/body/profile"}


@pytest.mark.parametrize(
    ("options", "pointer"),
    [
        ({"idle_timeout_s": 1e6}, "/body/idle_timeout_s"),
        ({"camera": {"fx": 1, "fy": 1, "cx": 0, "cy": 0, "width": 5}}, "/body/camera"),
        ({"joint_axes": {"hinge": [1, 0, 0]}}, "/body/joint_axes"),
    ],
)
def test_what_only_the_service_knows_to_be_invalid_is_pointed_at_too(
    service: Running, options: dict[str, Any], pointer: str
) -> None:
    problem = refused(service.http.post("/v1/sessions", json=session_body() | options), 422, "invalid-request")
    assert [error["pointer"] for error in problem["errors"]] == [pointer]
    assert problem["detail"] == f"{pointer}: {problem['errors'][0]['detail']}"


def test_of_very_many_mistakes_some_are_told(service: Running) -> None:
    body = session_body() | {f"unknown{i}": 0 for i in range(1000)}
    problem = refused(service.http.post("/v1/sessions", json=body), 422, "invalid-request")
    assert len(problem["errors"]) == 20
    assert "999 more" in problem["detail"]


@pytest.mark.parametrize(
    "body",
    [
        b"{",
        b"",
        b"null",
        b"[]",
        b"\xff\xfe",
        b'{"category": "mug", "parts": [{"rotation": {"quat_xyzw": [NaN, 0, 0, 1]}}]}',
        b'{"category": "mug", "parts": [{"translation": [0, 0, Infinity]}]}',
        b'{"category": "mug", "idle_timeout_s": 1' + b"0" * 400 + b"}",
        b"[" * 100_000,
    ],
)
def test_body_that_is_no_session(service: Running, body: bytes) -> None:
    answer = service.http.post("/v1/sessions", content=body, headers={"Content-Type": "application/json"})
    assert answer.status_code == 422
    refused(answer, answer.status_code, "invalid-request")


@pytest.mark.parametrize("content_type", ["text/plain", "application/x-www-form-urlencoded", ""])
def test_body_of_another_kind(service: Running, content_type: str) -> None:
    headers = {"Content-Type": content_type} if content_type else {}
    refused(service.http.post("/v1/sessions", content=b"{}", headers=headers), 415, "unsupported-media-type")


@pytest.mark.parametrize("chunked", [False, True])
def test_body_over_the_limit(chunked: bool) -> None:
    with running("mug", max_body_bytes=1000) as service:
        body = b" " * 5_000_000
        content: Any = (body[start : start + 65536] for start in range(0, len(body), 65536)) if chunked else body
        headers = {"Content-Type": "application/json"}
        refused(service.http.post("/v1/sessions", content=content, headers=headers), 413, "body-too-large")
        assert service.http.post("/v1/sessions", json=session_body()).status_code == 201


def test_too_many_sessions() -> None:
    with running("mug", max_sessions=2) as service:
        ids = [service.open_session()["session_id"] for _ in range(2)]
        refused(service.http.post("/v1/sessions", json=session_body()), 429, "too-many-sessions")
        service.http.delete(f"/v1/sessions/{ids[0]}")
        service.open_session()


@pytest.mark.parametrize("path", ["", "/pose"])
def test_unknown_session(service: Running, path: str) -> None:
    refused(service.http.get(f"/v1/sessions/f00{path}"), 404, "unknown-session")
    refused(service.http.delete("/v1/sessions/f00"), 404, "unknown-session")
    refused(service.http.put("/v1/sessions/f00/pose", json={"parts": part()}), 404, "unknown-session")
    refused(service.post_frame("f00", f32(blob())), 404, "unknown-session")


def test_unknown_path(service: Running) -> None:
    refused(service.http.get("/v2/sessions"), 404, "not-found")


def test_method_that_is_not_allowed(service: Running) -> None:
    answer = service.http.patch("/v1/sessions")
    problem = refused(answer, 405, "method-not-allowed")
    assert answer.headers["Allow"] == "GET, POST"
    assert "GET, POST" in problem["detail"]


QUERIES = ["", "?seq=1", "?stamp_ns=1", "?seq=-1&stamp_ns=1", "?seq=x&stamp_ns=1"]
OVERFLOWING = [f"?seq={2**64}&stamp_ns=1", f"?seq=1&stamp_ns={2**63}"]


@pytest.mark.parametrize("query", QUERIES + OVERFLOWING)
def test_frame_without_a_proper_number_and_stamp(service: Running, query: str) -> None:
    session_id = service.open_session()["session_id"]
    refused(service.http.post(f"/v1/sessions/{session_id}/frames{query}", content=f32(blob())), 422, "invalid-request")


def test_defect_of_the_service_is_a_problem_too(service: Running, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = 'captra_requests_rejected_total{reason="internal-error"}'
    before = service.metric(counter)
    monkeypatch.setattr(service.service.registry, "sessions", lambda: 1 / 0)
    refused(service.http.get("/v1/sessions"), 500, "internal-error")
    monkeypatch.undo()
    metrics = httpx.get(service.http.base_url.join("/metrics")).text  # the server ends the connection of a defect
    assert f"{counter} {before + 1}" in metrics

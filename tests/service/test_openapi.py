"""The OpenAPI document describes what the service does."""

import re
from typing import Any

import pytest

from service.rejections import FRAME_REASONS, REQUEST_REASONS
from tests.service.support import Running

METHODS = {
    "/v1/sessions": {"post", "get"},
    "/v1/sessions/{session_id}": {"get", "delete"},
    "/v1/sessions/{session_id}/pose": {"get", "put"},
    "/v1/sessions/{session_id}/frames": {"post"},
    "/v1/zenoh": {"get"},
    "/v1/recordings": {"get"},
    "/v1/recordings/{name}": {"get", "delete"},
    "/v1/categories": {"get"},
    "/v1/models": {"get"},
    "/v1/health/live": {"get"},
    "/v1/health/ready": {"get"},
    "/metrics": {"get"},
}
NEVER_BY_A_PATH = {"missing-attachment", "malformed-attachment", "wrong-secret", "not-found", "method-not-allowed"}


@pytest.fixture
def document(service: Running) -> dict[str, Any]:
    found: dict[str, Any] = service.http.get("/openapi.json").json()
    return found


def operations(document: dict[str, Any]) -> list[dict[str, Any]]:
    return [operation for path in document["paths"].values() for operation in path.values()]


def test_every_path_is_there(document: dict[str, Any]) -> None:
    assert {path: set(methods) for path, methods in document["paths"].items()} == METHODS


def test_every_operation_is_described_with_its_problems(document: dict[str, Any]) -> None:
    for operation in operations(document):
        assert operation["description"]
        assert any(status.startswith("2") for status in operation["responses"])
        problems = {status: answer for status, answer in operation["responses"].items() if status >= "4"}
        assert "500" in problems
        for status, answer in problems.items():
            content = answer["content"]["application/problem+json"]
            assert content["schema"] == {"$ref": "#/components/schemas/Problem"}
            assert {example["value"]["status"] for example in content["examples"].values()} == {int(status)}
    assert "HTTPValidationError" not in document["components"]["schemas"]


def test_every_reason_is_an_example_somewhere(document: dict[str, Any]) -> None:
    examples = {
        reason
        for operation in operations(document)
        for answer in operation["responses"].values()
        for reason in answer.get("content", {}).get("application/problem+json", {}).get("examples", {})
    }
    assert examples == {*FRAME_REASONS, *REQUEST_REASONS} - NEVER_BY_A_PATH


def test_every_reference_leads_somewhere(document: dict[str, Any]) -> None:
    def references(node: object) -> list[str]:
        if isinstance(node, dict):
            here = [node["$ref"]] if "$ref" in node else []
            return here + [found for child in node.values() for found in references(child)]
        return [found for child in node for found in references(child)] if isinstance(node, list) else []

    schemas = document["components"]["schemas"]
    names = {reference.removeprefix("#/components/schemas/") for reference in references(document)}
    assert names <= set(schemas)
    assert {"Problem", "NewSession", "OpenedSession", "SessionState", "Result"} <= names


def test_clouds_are_described_as_bytes(document: dict[str, Any]) -> None:
    operation = document["paths"]["/v1/sessions/{session_id}/frames"]["post"]
    assert set(operation["requestBody"]["content"]) == {
        "application/vnd.captra.cloud.f32",
        "application/vnd.captra.cloud.i16",
        "application/cdr",
        "image/png",
        "application/vnd.captra.depth.u16",
        "application/vnd.captra.depth.f32",
        "multipart/form-data",
    }
    assert {entry["name"]: entry["required"] for entry in operation["parameters"]} == {
        "session_id": True, "seq": True, "stamp_ns": True, "box": False, "looks": False,
    }  # fmt: skip


def test_reasons_are_unique_and_their_counters_exist_from_the_start(service: Running) -> None:
    for reasons in (FRAME_REASONS, REQUEST_REASONS):
        assert len(set(reasons)) == len(reasons)
    assert set(FRAME_REASONS) & set(REQUEST_REASONS) == {"internal-error"}  # a defect may be met by both
    for reason in FRAME_REASONS:
        assert service.metric(f'captra_frames_rejected_total{{reason="{reason}"}}') == 0
    for reason in REQUEST_REASONS:
        assert service.metric(f'captra_requests_rejected_total{{reason="{reason}"}}') == 0


def test_the_page_for_people_loads_nothing_from_elsewhere(service: Running) -> None:
    page = service.http.get("/docs").text
    loaded = re.findall(r"""(?:src|href|url)\s*[=:]\s*["']([^"']+)["']""", page)
    assert len(loaded) == 4  # script, style, icon, document
    for path in loaded:
        assert path.startswith("/"), path
        assert service.http.get(path).status_code == 200
    assert "://" not in page

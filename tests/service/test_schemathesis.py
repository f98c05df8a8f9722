"""Requests made up from the OpenAPI document: whatever comes, the answer is one that the document describes."""

from collections.abc import Iterator
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis import Case, GenerationMode
from schemathesis.checks import load_all_checks
from schemathesis.specs.openapi.checks import positive_data_acceptance

from tests.service.support import Running, running
from tests.service.test_openapi import METHODS

EXAMPLES = 20
NOTHING_TO_SEND = {
    "/v1/categories",
    "/v1/models",
    "/v1/recordings",
    "/v1/zenoh",
    "/v1/health/live",
    "/v1/health/ready",
    "/metrics",
}
OPERATIONS = [
    (path, method, mode)
    for path, methods in METHODS.items()
    for method in sorted(methods)
    for mode in GenerationMode
    if mode is GenerationMode.POSITIVE or not (path in NOTHING_TO_SEND or (path, method) == ("/v1/sessions", "get"))
]
load_all_checks()


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    with running(max_sessions=8) as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


@pytest.mark.parametrize(("path", "method", "mode"), OPERATIONS)
def test_every_answer_is_one_that_the_document_describes(
    service: Running, path: str, method: str, mode: GenerationMode
) -> None:
    schema = schemathesis.openapi.from_url(f"{service.http.base_url}/openapi.json")

    @settings(
        max_examples=EXAMPLES, deadline=None, derandomize=True, database=None, suppress_health_check=list(HealthCheck)
    )
    @given(case=schema[path][method].as_strategy(generation_mode=mode), open_session=st.booleans())
    def answers(case: Case[Any], open_session: bool) -> None:
        if open_session and "session_id" in case.path_parameters:
            case.path_parameters["session_id"] = one_of_the_open(service)
        # A document cannot say which matrices are rotations, so that what has the right form may still be refused.
        case.call_and_validate(excluded_checks=[positive_data_acceptance])

    answers()
    assert service.metric('captra_frames_rejected_total{reason="internal-error"}') == 0


def one_of_the_open(service: Running) -> str:
    sessions = service.service.registry.sessions()
    return sessions[0].session_id if sessions else str(service.open_session()["session_id"])

"""Errors as problem+json (RFC 9457): every refusal, and everything that the framework refuses by itself."""

from collections.abc import Mapping
from dataclasses import asdict
from http import HTTPStatus
from typing import Any

import orjson
from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel, ConfigDict, Field
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect
from starlette.routing import compile_path

from service.rejections import (
    ForbiddenError,
    FrameRejectedError,
    InternalError,
    InvalidRequestError,
    MethodNotAllowedError,
    Mistake,
    NotFoundError,
    RejectedError,
    RequestFailedError,
    UnauthorizedError,
)

MEDIA_TYPE = "application/problem+json"
MOST_MISTAKES = 20
"""So many are told of a request; how many there are is said."""
GUARDING = (UnauthorizedError, ForbiddenError)
TYPE_PREFIX = "urn:captra:problem:"
CLIENT_LEFT = 499
"""Status of an answer that nobody reads."""


class FieldError(BaseModel):
    """One thing that is wrong with a request."""

    pointer: str = Field(description="Where: a JSON pointer into the request, e.g. `/body/parts/0/size`.")
    detail: str = Field(description="What is wrong there.")


class Problem(BaseModel):
    """An error, as RFC 9457 describes it."""

    model_config = ConfigDict(
        json_schema_extra={
            "examples": [
                {
                    "type": "urn:captra:problem:unknown-session",
                    "title": "Unknown session",
                    "status": 404,
                    "detail": "no session 'f00' is open: it was closed, it expired, or it never was; POST a new one",
                    "instance": "/v1/sessions/f00",
                    "reason": "unknown-session",
                }
            ]
        }
    )

    type: str = Field(description="`urn:captra:problem:` and the reason.")
    title: str = Field(description="The kind of problem, for people.")
    status: int = Field(description="HTTP status.")
    detail: str = Field(description="What is wrong this time, and what to do next.")
    instance: str = Field(description="Path of the request.")
    reason: str = Field(description="The kind of problem, for programs; the same word as in events and metrics.")
    errors: list[FieldError] | None = Field(
        default=None, description="For a request that is not valid: each thing wrong."
    )


def documented(*kinds: type[RejectedError], guarded: bool = True) -> dict[int | str, dict[str, Any]]:
    """Entries for the `responses` of a route: each status once, with an example of each reason."""
    responses: dict[int | str, dict[str, Any]] = {}
    every: set[type[RejectedError]] = {*kinds, InternalError, *(GUARDING if guarded else ())}
    for kind in sorted(every, key=lambda kind: (kind.status, kind.reason)):
        entry = responses.setdefault(kind.status, {"description": "", "content": {MEDIA_TYPE: _content()}})
        example = {"summary": kind.title, "value": _members(kind, "what is wrong, and what to do next", "/v1/…")}
        entry["content"][MEDIA_TYPE]["examples"][kind.reason] = example
        reasons = entry["content"][MEDIA_TYPE]["examples"]
        entry["description"] = "Refused: " + ", ".join(f"`{reason}`" for reason in reasons)
    return responses


def install(app: FastAPI) -> None:
    """Answer every error of an application with problem+json."""
    app.add_exception_handler(RejectedError, _refused)
    app.add_exception_handler(RequestValidationError, _invalid)
    app.add_exception_handler(HTTPException, _http_error)
    app.add_exception_handler(ClientDisconnect, _left)
    app.add_exception_handler(Exception, _defect)


def answer(request: Request, rejection: RejectedError, headers: Mapping[str, str] | None = None) -> Response:
    """The answer that tells of a refusal; counts it, unless it is of a frame."""
    if not isinstance(rejection, FrameRejectedError):  # frames are counted where they are refused
        request.app.state.service.telemetry.request_rejected(rejection.reason)
    body = _members(rejection, rejection.detail, request.url.path)
    if isinstance(rejection, InvalidRequestError):
        body["errors"] = [asdict(mistake) for mistake in rejection.mistakes[:MOST_MISTAKES]]
    return Response(orjson.dumps(body), rejection.status, media_type=MEDIA_TYPE, headers=dict(headers or {}))


def _content() -> dict[str, Any]:
    return {"schema": {"$ref": "#/components/schemas/Problem"}, "examples": {}}


def _members(kind: type[RejectedError] | RejectedError, detail: str, instance: str) -> dict[str, Any]:
    return {
        "type": TYPE_PREFIX + kind.reason,
        "title": kind.title,
        "status": kind.status,
        "detail": detail,
        "instance": instance,
        "reason": kind.reason,
    }


async def _refused(request: Request, error: Exception) -> Response:
    assert isinstance(error, RejectedError)
    return answer(request, error)


def remark(entry: Mapping[str, Any]) -> str:
    """What is wrong with one field, as pydantic found it."""
    match entry["type"]:
        case "extra_forbidden":
            return "there is no such field: leave it out, or correct its name"
        case "model_attributes_type" | "model_type" | "dict_type":
            return "it is no JSON object, {…}"
        case "json_invalid":
            return f"it is no JSON ({entry.get('ctx', {}).get('error', 'it ends too soon')})"
        case "string_pattern_mismatch":
            return f"it does not match {entry['ctx']['pattern']}"
    return str(entry["msg"]).removeprefix("Value error, ")


async def _invalid(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    mistakes = [
        Mistake("/" + "/".join(str(step) for step in entry["loc"]), remark(entry)) for entry in error.errors()
    ] or [Mistake("", "see the OpenAPI document")]
    return answer(request, InvalidRequestError(*mistakes))


async def _http_error(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    path, method = request.url.path, request.method
    match error.status_code:
        case HTTPStatus.NOT_FOUND:
            rejection: RejectedError = NotFoundError(f"{path} leads nowhere: GET /openapi.json lists every path")
        case HTTPStatus.METHOD_NOT_ALLOWED:
            allowed = ", ".join(_methods_of(request)) or (error.headers or {}).get("Allow", "")
            rejection = MethodNotAllowedError(f"{path} cannot be reached with {method}: use {allowed}")
            return answer(request, rejection, {"Allow": allowed})
        case _:
            rejection = InvalidRequestError(Mistake("", str(error.detail)))  # the document has its status
    return answer(request, rejection, error.headers)


def _methods_of(request: Request) -> list[str]:
    """All methods that a path of the OpenAPI document can be reached with, each by a route of its own."""
    paths: Mapping[str, Mapping[str, Any]] = request.app.openapi()["paths"]
    fitting = [methods for path, methods in paths.items() if compile_path(path)[0].match(request.url.path)]
    return sorted({method.upper() for methods in fitting for method in methods})


async def _left(request: Request, error: Exception) -> Response:  # noqa: ARG001 - in the middle of its body
    return Response(status_code=CLIENT_LEFT)


async def _defect(request: Request, error: Exception) -> Response:  # noqa: ARG001 - the log has it
    return answer(request, RequestFailedError("the service failed on this request; its log tells why"))

"""Asks who calls before anything of a request is read."""

from http import HTTPMethod
from urllib.parse import parse_qs

from starlette.datastructures import Headers
from starlette.requests import HTTPConnection, Request
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocket

from service.rejections import RejectedError, UnauthorizedError
from service.rest.problems import answer
from service.security.access import Gate, Permission

OPEN_PATHS = ("/v1/health/", "/docs", "/openapi.json", "/viewer/static/")
"""Probes, and what tells how to ask: documentation, and the live page, which asks for a key itself."""
READING = {HTTPMethod.GET, HTTPMethod.HEAD, HTTPMethod.OPTIONS}
POLICY_VIOLATION = 1008


class Guard:
    """ASGI middleware: reading needs a caller that may read, everything else one that may write."""

    def __init__(self, app: ASGIApp, gate: Gate) -> None:
        self._app = app
        self._gate = gate

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, or refuse it."""
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        try:
            scope["state"] = {**scope.get("state", {}), "caller": self._gate.admit(bearer_of(scope), needed_for(scope))}
        except RejectedError as rejection:
            await refuse(rejection, scope, receive, send)
        else:
            await self._app(scope, receive, send)


def needed_for(scope: Scope) -> Permission:
    """What a request takes."""
    if scope["path"] == "/" or scope["path"].startswith(OPEN_PATHS):
        return Permission.NOTHING
    return Permission.READ if scope.get("method", HTTPMethod.GET) in READING else Permission.WRITE


def bearer_of(scope: Scope) -> str | None:
    """The bearer token: from the header, or from `?access_token=`, since a browser's sockets have no headers."""
    scheme, _, token = Headers(scope=scope).get("authorization", "").partition(" ")
    if scheme.lower() == "bearer" and token:
        return token.strip()
    return parse_qs(HTTPConnection(scope).url.query).get("access_token", [None])[0]


async def refuse(rejection: RejectedError, scope: Scope, receive: Receive, send: Send) -> None:
    """Answer with the problem."""
    if scope["type"] == "websocket":
        await WebSocket(scope, receive, send).close(POLICY_VIOLATION, rejection.reason)
        return
    headers = {"WWW-Authenticate": "Bearer"} if isinstance(rejection, UnauthorizedError) else {}
    await answer(Request(scope, receive), rejection, headers)(scope, receive, send)

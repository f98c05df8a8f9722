"""Reading bodies without trusting their length or their kind."""

from collections.abc import AsyncIterator, Callable, Coroutine, MutableMapping
from typing import Any

import anyio
from fastapi import Request, Response
from fastapi.routing import APIRoute

from service.rejections import BodyTooLargeError, SlowBodyError, UnsupportedMediaTypeError

DRAINED_BYTES = 64 * 2**20
"""How much of a refused body is read and thrown away, so that the client gets to read the answer."""


LONGEST_S = 30.0
"""What a body may take to arrive: the largest one comes within it at 5 Mbit/s."""


async def read_body(request: Request, check_size: Callable[[int], None], longest_s: float = LONGEST_S) -> bytes:
    """The whole body; `check_size` raises as soon as it is known to be too large.

    Raises:
        SlowBodyError: it takes longer than `longest_s`.
    """
    try:
        with anyio.fail_after(longest_s):
            return await _read(request, check_size)
    except TimeoutError:
        raise SlowBodyError(
            f"the body did not arrive within {longest_s:g} s: send fewer points, or over a faster network"
        ) from None


async def _read(request: Request, check_size: Callable[[int], None]) -> bytes:
    declared = request.headers.get("content-length", "")
    body = bytearray()
    chunks = request.stream()
    try:
        if declared.isdecimal():
            check_size(int(declared))
        async for chunk in chunks:
            body += chunk
            check_size(len(body))
    except Exception:
        await _drain(chunks, len(body))
        raise
    return bytes(body)


async def discard_body(request: Request) -> None:
    """Read the body of a refused request and keep none of it."""
    await _drain(request.stream(), 0)


async def _drain(chunks: AsyncIterator[bytes], drained_bytes: int) -> None:
    async for chunk in chunks:
        drained_bytes += len(chunk)
        if drained_bytes > DRAINED_BYTES:
            break


class JsonRoute(APIRoute):
    """A route whose body, if it has one, is JSON of limited size."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """The handler that FastAPI makes, given a body that has been checked."""
        handler = super().get_route_handler()
        if self.body_field is None:
            return handler

        async def checked(request: Request) -> Response:
            check_media_type(request.headers.get("content-type", ""))
            limit = request.app.state.service.settings.max_body_bytes
            body = await read_body(request, lambda size: check_size(size, limit))

            async def receive() -> MutableMapping[str, Any]:
                return {"type": "http.request", "body": body, "more_body": False}

            return await handler(Request(request.scope, receive))

        return checked


def check_media_type(content_type: str) -> None:
    """Refuse bodies that do not say they are JSON.

    Raises:
        UnsupportedMediaTypeError: they say something else, or nothing.
    """
    if content_type.partition(";")[0].strip().lower() != "application/json":
        raise UnsupportedMediaTypeError(f"the body is {content_type[:100]!r}: send JSON as application/json")


def check_size(size: int, limit: int) -> None:
    """Refuse bodies over the limit.

    Raises:
        BodyTooLargeError: it is.
    """
    if size > limit:
        raise BodyTooLargeError(f"the body has {size} bytes or more, the limit is {limit}")

from typing import Any

import anyio
import pytest
from fastapi import Request

from service.rejections import BodyTooLargeError, SlowBodyError
from service.rest.bodies import read_body


def request_of(*chunks: bytes) -> Request:
    """A request whose body does not end after the chunks."""
    waiting = list(chunks)

    async def receive() -> dict[str, Any]:
        if not waiting:
            await anyio.sleep_forever()
        return {"type": "http.request", "body": waiting.pop(0), "more_body": True}

    return Request({"type": "http", "method": "POST", "headers": []}, receive)


def any_size(size: int) -> None:
    """Nothing is too large."""


def at_most_four(size: int) -> None:
    """Five bytes are too many."""
    if size > 4:
        raise BodyTooLargeError("too large")


@pytest.mark.parametrize("chunks", [(), (b"half", b" a cloud")])
def test_a_body_that_does_not_end_is_not_waited_for(chunks: tuple[bytes, ...]) -> None:
    with pytest.raises(SlowBodyError, match=r"0\.05 s") as caught:
        anyio.run(read_body, request_of(*chunks), any_size, 0.05)
    assert (caught.value.status, caught.value.reason) == (408, "slow-body")


def test_nor_one_that_is_too_large_and_does_not_end() -> None:
    with pytest.raises(SlowBodyError):
        anyio.run(read_body, request_of(b"five!"), at_most_four, 0.05)

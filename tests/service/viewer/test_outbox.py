"""What waits for a viewer that does not take it stays small, and nobody waits for that viewer."""

import asyncio
import threading
from collections.abc import Coroutine
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, TypeVar

import numpy as np

from service.viewer.clouds import Frame
from service.viewer.outbox import LONGEST_LINE, Outbox

Answer = TypeVar("Answer")


def run(scenario: Coroutine[Any, Any, Answer]) -> Answer:
    """In a thread of its own: the one of the tests may hold the loop of the browser that other tests look through."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, scenario).result()


def frame(number: int) -> Frame:
    return Frame(f"session/{number}", np.zeros((1, 3), np.float32))


def test_the_newest_cloud_alone_waits() -> None:
    async def scenario() -> None:
        outbox = Outbox()
        for number in range(5):
            outbox.put_cloud(partial(frame, number))
        make = outbox.take_cloud()
        assert make is not None
        made = make()
        assert made is not None
        assert made.scene == "session/4"
        assert outbox.take_cloud() is None

    run(scenario())


def test_old_messages_go_first_when_the_line_is_full() -> None:
    async def scenario() -> None:
        outbox = Outbox()
        for number in range(LONGEST_LINE + 10):
            outbox.put_message(str(number).encode())
        waiting = outbox.take_messages()
        assert len(waiting) == LONGEST_LINE
        assert waiting[-1] == str(LONGEST_LINE + 9).encode()

    run(scenario())


def test_another_thread_wakes_the_viewer() -> None:
    async def scenario() -> None:
        outbox = Outbox()
        threading.Timer(0.05, outbox.put_message, (b"news",)).start()
        await asyncio.wait_for(outbox.wait(30), 10)
        assert outbox.take_messages() == [b"news"]

    run(scenario())


def test_putting_after_the_service_stopped_does_nothing() -> None:
    async def made() -> Outbox:
        return Outbox()

    outbox = run(made())
    outbox.put_message(b"late")
    outbox.put_cloud(lambda: frame(0))

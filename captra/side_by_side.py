"""Two pieces of work at the same time, for work that releases the GIL, where a core is free for it."""

import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Protocol, TypeVar

One = TypeVar("One")
Other = TypeVar("Other")


class SideBySide(Protocol):
    """How two pieces of work share the cores; may be called from any thread."""

    def __call__(self, one: Callable[[], One], other: Callable[[], Other]) -> tuple[One, Other]:
        """Both answers; what either raises is raised here, once both have ended."""


class InTurn:
    """One after the other, in the caller's thread."""

    def __call__(self, one: Callable[[], One], other: Callable[[], Other]) -> tuple[One, Other]:
        """Both answers."""
        return one(), other()


IN_TURN: SideBySide = InTurn()


class WhileCoresAreFree:
    """Side by side as long as fewer callers than cores are at it, else in turn: more threads would only wait.

    Threads that wait for work are kept: starting one costs milliseconds on a busy machine.
    """

    def __init__(self, cores: int) -> None:
        self._cores = cores
        self._busy = 0
        self._lock = threading.Lock()
        self._threads = ThreadPoolExecutor(max(1, cores - 1), "captra-beside")

    def __call__(self, one: Callable[[], One], other: Callable[[], Other]) -> tuple[One, Other]:
        """Both answers; `one` runs in another thread where a core is free."""
        claimed = self._claim()
        try:
            if claimed == 1:
                return one(), other()
            future = self._threads.submit(one)
            try:
                answer = other()
            finally:
                future.exception()
            return future.result(), answer
        finally:
            self._release(claimed)

    def _claim(self) -> int:
        with self._lock:
            claimed = 2 if self._busy + 2 <= self._cores else 1
            self._busy += claimed
            return claimed

    def _release(self, claimed: int) -> None:
        with self._lock:
            self._busy -= claimed

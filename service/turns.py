"""Takes turns: a few at a time, in the order in which they came."""

import threading
from collections import deque
from types import TracebackType


class Turns:
    """A context that so many threads may be inside at once; whoever waits longest is next, so that nobody starves.

    Each frame that is being tracked holds the memory of a network run. With one in hand for every session that memory
    would grow with their number, and on the same cores none of them would be done any sooner.
    """

    def __init__(self, at_once: int) -> None:
        self._free = at_once
        self._waiting: deque[threading.Event] = deque()
        self._lock = threading.Lock()

    def __enter__(self) -> None:
        with self._lock:
            if self._free > 0:
                self._free -= 1
                return
            mine = threading.Event()
            self._waiting.append(mine)
        mine.wait()

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with self._lock:
            if self._waiting:
                self._waiting.popleft().set()
            else:
                self._free += 1

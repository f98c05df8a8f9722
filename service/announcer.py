"""Events on their way out: told by a thread of their own, so that whoever listens slowly never delays a frame."""

import threading
from collections import deque
from collections.abc import Callable

from service.results import Event

CAPACITY = 256
"""Events of one session that may wait; when there are more, the oldest go."""


class Announcer:
    """Hands events to `tell` in order; `tell` may block, `put` never does."""

    def __init__(
        self, tell: Callable[[Event], None], on_drop: Callable[[], None], on_end: Callable[[], None], name: str
    ) -> None:
        """`on_end` is called on the thread that tells, after the last event, however late that is."""
        self._tell = tell
        self._on_end = on_end
        self._on_drop = on_drop
        self._waiting: deque[Event] = deque()
        self._changed = threading.Condition()
        self._closed = False
        self._thread = threading.Thread(target=self._run, name=f"captra-events-{name}", daemon=True)
        self._thread.start()

    def put(self, event: Event) -> None:
        """Tell this after what is waiting."""
        with self._changed:
            if len(self._waiting) >= CAPACITY:
                self._waiting.popleft()
                self._on_drop()
            self._waiting.append(event)
            self._changed.notify()

    def close(self, timeout_s: float = 1.0) -> None:
        """Tell what is waiting, for as long as that takes but no longer than `timeout_s`; nothing afterwards."""
        with self._changed:
            self._closed = True
            self._changed.notify()
        self._thread.join(timeout_s)
        with self._changed:
            self._waiting.clear()

    def _run(self) -> None:
        while (event := self._next()) is not None:
            self._tell(event)
        self._on_end()

    def _next(self) -> Event | None:
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._closed)
            return self._waiting.popleft() if self._waiting else None

"""What arrives for a session, in order, from Zenoh's threads to the one that reads."""

from collections import deque
from threading import Condition
from typing import Generic, TypeVar

Message = TypeVar("Message")


class Inbox(Generic[Message]):
    """A bounded queue that never makes the sender wait: when it is full the oldest message goes."""

    def __init__(self, capacity: int = 1024) -> None:
        self._messages: deque[Message] = deque(maxlen=capacity)
        self._changed = Condition()

    def put(self, message: Message) -> None:
        """Append a message and wake the reader."""
        with self._changed:
            self._messages.append(message)
            self._changed.notify()

    def get(self, timeout_s: float) -> Message | None:
        """The oldest message, or None when none came within `timeout_s` seconds."""
        with self._changed:
            if not self._changed.wait_for(lambda: self._messages, timeout_s):
                return None
            return self._messages.popleft()

    def clear(self) -> None:
        """Forget what has not been read."""
        with self._changed:
            self._messages.clear()

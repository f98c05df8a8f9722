"""What waits for one viewer: the newest cloud alone, and a short line of messages; nobody ever waits for a viewer."""

import asyncio
from collections import deque
from collections.abc import Callable

from service.viewer.clouds import Frame

LONGEST_LINE = 256
"""Messages that may wait for a slow viewer; the oldest go first."""

MakeFrame = Callable[[], Frame | None]


class Outbox:
    """Filled from any thread, emptied by the viewer's own task on the event loop that made it."""

    def __init__(self) -> None:
        self._loop = asyncio.get_running_loop()
        self._filled = asyncio.Event()
        self._messages: deque[bytes] = deque(maxlen=LONGEST_LINE)
        self._cloud: MakeFrame | None = None

    def put_message(self, message: bytes) -> None:
        """Add a JSON message."""
        self._messages.append(message)
        self._wake()

    def put_cloud(self, make: MakeFrame) -> None:
        """Replace the cloud that waits; `make` is called on a worker thread if and when it is sent."""
        self._cloud = make
        self._wake()

    @property
    def has_cloud(self) -> bool:
        """Whether a cloud waits."""
        return self._cloud is not None

    def take_messages(self) -> list[bytes]:
        """All messages that wait, oldest first."""
        messages = []
        while self._messages:
            messages.append(self._messages.popleft())
        return messages

    def take_cloud(self) -> MakeFrame | None:
        """The cloud that waits."""
        cloud, self._cloud = self._cloud, None
        return cloud

    def clear_cloud(self) -> None:
        """Forget the cloud that waits: the viewer looks elsewhere."""
        self._cloud = None

    async def wait(self, timeout_s: float) -> None:
        """Until something was put, or the time is over."""
        try:
            await asyncio.wait_for(self._filled.wait(), timeout_s)
        except TimeoutError:
            return
        self._filled.clear()

    def _wake(self) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._filled.set)

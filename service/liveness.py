"""When a session ends by itself: without frames for too long, or without its client."""

import time
from collections.abc import Callable
from enum import StrEnum


class CloseReason(StrEnum):
    """Why a session ends."""

    DELETED = "deleted"
    IDLE = "idle"
    CLIENT_GONE = "client-gone"
    SHUTDOWN = "shutdown"
    NOT_STORED = "not-stored"


class Liveness:
    """Clock of one session; its methods may be called from any thread."""

    def __init__(
        self,
        idle_timeout_s: float,
        client_grace_s: float,
        clock_s: Callable[[], float] = time.monotonic,
        *,
        client_awaited: bool = False,
    ) -> None:
        """`client_awaited`: there was a client before this process, which has the grace time to come back."""
        self._idle_timeout_s = idle_timeout_s
        self._client_grace_s = client_grace_s
        self._clock_s = clock_s
        self._active_s = clock_s()
        self._client_gone_s = self._active_s if client_awaited else None

    def touch(self) -> None:
        """A frame or a new pose came."""
        self._active_s = self._clock_s()

    def client_gone(self) -> None:
        """The client's liveliness token is gone."""
        self._client_gone_s = self._clock_s()

    def client_back(self) -> None:
        """A client's liveliness token is there."""
        self._client_gone_s = None

    def expired(self) -> CloseReason | None:
        """Why the session should end now, if it should.

        Frames keep a session whose token is gone alive: someone else may feed it.
        """
        now_s, gone_s = self._clock_s(), self._client_gone_s
        if gone_s is not None and now_s - max(gone_s, self._active_s) >= self._client_grace_s:
            return CloseReason.CLIENT_GONE
        return CloseReason.IDLE if now_s - self._active_s >= self._idle_timeout_s else None

    @property
    def expires_after_s(self) -> float:
        """Seconds until the session ends when nothing comes."""
        return max(0.0, self._idle_timeout_s - (self._clock_s() - self._active_s))

"""Whether the service can track: first starting, then ready or hindered, at last stopping; never back."""

import threading

from service.rejections import HinderedError, NotReadyError

STARTING = "models are being loaded: try again in a few seconds"
STOPPING = "the service stops: try again when it is back"
PASSING = (STARTING, STOPPING)


class Readiness:
    """What stands in the way of tracking, if anything does; its methods may be called from any thread."""

    def __init__(self) -> None:
        self._obstacle: str | None = STARTING
        self._prepared = threading.Event()
        self._lock = threading.RLock()  # a signal handler may interrupt whoever holds it

    def prepared(self, obstacle: str | None = None) -> None:
        """Preparation has ended; with an obstacle that remains, or without."""
        with self._lock:
            if self._obstacle is STARTING:
                self._obstacle = obstacle
        self._prepared.set()

    def stopping(self) -> None:
        """No new work from now on."""
        with self._lock:
            self._obstacle = STOPPING

    @property
    def is_ready(self) -> bool:
        """Whether nothing stands in the way."""
        return self._obstacle is None

    def check(self) -> None:
        """Do nothing when ready.

        Raises:
            NotReadyError: it starts or stops.
            HinderedError: something else stands in the way, which waiting does not change.
        """
        obstacle = self._obstacle
        if obstacle in PASSING:
            raise NotReadyError(obstacle)
        if obstacle is not None:
            raise HinderedError(obstacle)

    def check_takes_sessions(self) -> None:
        """Do nothing between start and stop; where something else stands in the way, opening one tells what.

        Raises:
            NotReadyError: it starts or stops.
        """
        obstacle = self._obstacle
        if obstacle in PASSING:
            raise NotReadyError(obstacle)

    def wait_prepared(self, timeout_s: float | None = None) -> bool:
        """Wait until preparation has ended, well or badly; whether it has."""
        return self._prepared.wait(timeout_s)

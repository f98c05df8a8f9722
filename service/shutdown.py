"""The end of a process: probes hear of it while frames in hand are finished, and whatever hangs is left behind."""

import logging
import os
import signal
import threading
import time
from collections.abc import Callable
from types import FrameType

from service.http_server import HttpServer
from service.tracking_service import TrackingService

logger = logging.getLogger(__name__)

SIGNALS = (signal.SIGTERM, signal.SIGINT)
FORCE_AFTER_S = 1.0
"""Time for everything else, once the frames in hand have had theirs."""
STORE_WITHIN_S = 0.5
"""How long a forced end waits for the disk."""


class Shutdown:
    """Ends this process on request.

    Its two threads wait for that from the beginning, since a signal handler must not wait for anything. The one that
    forces the end is a daemon: with the process gone in time, it is gone too.
    """

    def __init__(
        self, service: TrackingService, server: HttpServer, end_process: Callable[[int], None] = os._exit
    ) -> None:
        """`end_process` ends the process at once with an exit status, whatever its other threads do."""
        self._service = service
        self._server = server
        self._end_process = end_process
        self._begun = threading.Event()
        for work in (self._drain, self._force):
            threading.Thread(target=work, name=f"captra-shutdown{work.__name__}", daemon=True).start()

    def on_signals(self) -> None:
        """Begin on the first SIGTERM or SIGINT; a second one ends the process at once."""

        def begin(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - signal handlers take both
            self.begin()
            for each in SIGNALS:
                signal.signal(each, signal.SIG_DFL)

        for each in SIGNALS:
            signal.signal(each, begin)

    def begin(self) -> None:
        """Not ready from now on; the server stops when the frames in hand are finished."""
        self._service.readiness.stopping()
        self._begun.set()

    def _drain(self) -> None:
        self._begun.wait()
        end_s = time.monotonic() + self._service.settings.shutdown_timeout_s
        try:
            self._service.drain()
        except Exception:  # the server has to stop all the same
            logger.exception("frames in hand not finished")
        self._server.stop(max(0.0, end_s - time.monotonic()))  # frames and requests have one time together

    def _force(self) -> None:
        self._begun.wait()
        time.sleep(self._service.settings.shutdown_timeout_s + FORCE_AFTER_S)
        logger.error("something hangs: the process is ended by force")
        storing = threading.Thread(target=self._service.store_state, daemon=True)
        storing.start()
        storing.join(STORE_WITHIN_S)
        self._end_process(int(storing.is_alive()))

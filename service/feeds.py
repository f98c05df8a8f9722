"""Newest wins: a thread that takes the newest sample of a key whenever it is done with the last one."""

import threading
import time
from collections.abc import Callable

import zenoh

LONGEST_WAIT_S = 60.0
"""A sample that seems to have waited longer was stamped before somebody set the clock."""


class Feed:
    """Calls `take` with the newest sample; those that come meanwhile replace each other."""

    def __init__(self, zenoh_session: zenoh.Session, key: str, take: Callable[[zenoh.Sample], None], name: str) -> None:
        """`take` is called on a thread of that name, and only with what was put."""
        self._take = take
        self._stopped = False
        self._samples = zenoh_session.declare_subscriber(key, zenoh.handlers.RingChannel(1))
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Take no more; once is enough, more does no harm."""
        if not self._stopped:
            self._stopped = True
            self._samples.undeclare()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the one in hand; whether it was done within `timeout_s`, if that is given."""
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    def _run(self) -> None:
        # The subscriber itself cannot be undeclared while a thread waits in its recv; its handler's recv then ends.
        handler = self._samples.handler
        while True:
            try:
                sample = handler.recv()
            except zenoh.ZError:
                return
            if sample.kind == zenoh.SampleKind.PUT:
                self._take(sample)


def arrival_s(sample: zenoh.Sample, router_id: str) -> float:
    """When a sample reached the router, on the clock of `time.perf_counter`; now, where someone else stamped it."""
    now_s, stamp = time.perf_counter(), sample.timestamp
    if stamp is None or str(stamp.get_id()) != router_id:
        return now_s
    waited_s = time.time() - stamp.get_time().timestamp()
    return now_s - waited_s if 0 <= waited_s <= LONGEST_WAIT_S else now_s

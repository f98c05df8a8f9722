"""How long sessions are without results when the service is killed in mid-stream and started again, and how it ends.

python -m benchmarks.takeover --sessions 64

Clouds keep coming all the while. Ends with status 0 only if every session goes on within three seconds of ready, and if
the service, asked to stop, ends within five with status 0.
"""

import os
import signal
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import typer

from benchmarks.fleet import Tracked, mug_service, open_fleet, play_round
from captra.bench.machine import this_machine
from clients.service_process import ServiceProcess

WITHIN_S = 3.0
END_WITHIN_S = 5.0
GIVE_UP_S = 30.0


@dataclass(frozen=True)
class Takeover:
    """What one kill cost, seconds."""

    down_s: float
    """From the kill until the service was ready again."""
    gaps_s: np.ndarray
    """From ready until each session had its first result since the kill; infinite where none came."""


@contextmanager
def streaming(fleet: Sequence[Tracked], rate_hz: float) -> Iterator[None]:
    """Clouds of all sessions in turn, since a second ago."""
    stop = threading.Event()

    def put() -> None:
        while not stop.is_set():
            for each in fleet:
                each.put()
                if stop.wait(1 / (rate_hz * len(fleet))):
                    return

    putting = threading.Thread(target=put)
    putting.start()
    try:
        time.sleep(1.0)
        yield
    finally:
        stop.set()
        putting.join()


def end(service: ServiceProcess, fleet: Sequence[Tracked], rate_hz: float) -> tuple[int, float]:
    """Ask the service to stop while clouds come: its exit status, and seconds until then."""
    with streaming(fleet, rate_hz):
        started_s = time.monotonic()
        return service.stop(), time.monotonic() - started_s


def take_over(service: ServiceProcess, fleet: Sequence[Tracked], rate_hz: float) -> Takeover:
    """Kill the service while clouds come, start it again, and wait until every session has gone on."""
    with streaming(fleet, rate_hz):
        killed_s = time.monotonic()
        os.kill(service.pid, signal.SIGKILL)
        service.stop()
        first = {each.session.session_id: last_seq(each) + 1 for each in fleet}
        service.__enter__()
        ready_s = time.monotonic()
        gaps_s = dict.fromkeys(first, np.inf)
        while np.inf in gaps_s.values() and time.monotonic() < ready_s + GIVE_UP_S:
            for each in fleet:
                name = each.session.session_id
                if gaps_s[name] == np.inf and last_seq(each) >= first[name]:
                    gaps_s[name] = time.monotonic() - ready_s
            time.sleep(0.005)
    return Takeover(ready_s - killed_s, np.array(list(gaps_s.values())))


def last_seq(tracked: Tracked) -> int:
    """Number of the newest result, if there is one."""
    return -1 if tracked.session.latest is None else tracked.session.latest.seq


def main(
    sessions: Annotated[int, typer.Option(help="Sessions at the same time.")] = 64,
    rate_hz: Annotated[float, typer.Option(help="Clouds a second of each session.")] = 2.0,
    kills: Annotated[int, typer.Option(help="How often.")] = 3,
) -> None:
    """Kill and measure."""
    with ExitStack() as resources:
        service = resources.enter_context(mug_service(sessions))
        fleet = resources.enter_context(open_fleet(service.url, sessions))
        play_round(fleet, GIVE_UP_S)
        print(this_machine())
        slowest_s = []
        for kill in range(kills):
            found = take_over(service, fleet, rate_hz)
            slowest_s.append(found.gaps_s.max())
            print(
                f"kill {kill + 1}: ready after {found.down_s:.1f} s; {sessions} sessions go on from ready: "
                f"median {np.median(found.gaps_s):.2f} s, last {found.gaps_s.max():.2f} s"
            )
        status, ended_s = end(service, fleet, rate_hz)
        print(f"SIGTERM: ended after {ended_s:.1f} s with status {status}")
    sys.exit(int(max(slowest_s) > WITHIN_S or ended_s > END_WITHIN_S or status != 0))


if __name__ == "__main__":
    typer.run(main)

"""Many sessions at once on one real service, while everything around them goes wrong.

python -m benchmarks.soak                               # 64 sessions, ten minutes
python -m benchmarks.soak --sessions 8 --minutes 2

Each session follows the bundled mug, moved by a distance of its own, through a Zenoh router, against its own ground
truth. Meanwhile malformed clouds come, somebody subscribes to everything and reads nothing, the service is killed, the
router is killed, it freezes for some seconds, and clients are killed. Prints memory and file handles over time and a
table, and ends with status 0 only if every line of that holds.
"""

import json
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack, closing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.console import Console

from benchmarks.faults import FLOODED, Flood, Router, is_open, kill_client, metrics, stalled_watcher
from benchmarks.fleet import ANSWER_WITHIN_S, WRONG_M, Tracked, mug_service, open_fleet, play_round
from benchmarks.verdict import Line, tell
from captra.bench.machine import this_machine
from clients.rest import RestApi
from clients.service_process import ServiceProcess, free_ports

GRACE_S = 30
FROZEN_S = 4.0
GROWTH = 0.10
"""By how much memory and file handles may grow between the second and the last quarter of the quiet time."""
MALFORMED_HZ = 20.0
LINES = 20


@dataclass
class Usage:
    """What a process holds, over time; faults that change it on purpose begin a new series."""

    memory_mib: list[float] = field(default_factory=list)
    handles: list[int] = field(default_factory=list)

    def look(self, pid: int) -> None:
        """One more point of the series."""
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
        self.memory_mib.append(pages * os.sysconf("SC_PAGE_SIZE") / 2**20)
        self.handles.append(len(list(Path(f"/proc/{pid}/fd").iterdir())))

    def restart(self) -> None:
        """Another process has taken over."""
        self.memory_mib.clear()
        self.handles.clear()


def growth_of(values: Sequence[float]) -> float:
    """From the median of the second quarter to that of the last, as a share; the first quarter is for warming up."""
    quarter = max(1, len(values) // 4)
    return float(np.median(values[-quarter:]) / np.median(values[quarter : 2 * quarter])) - 1


@dataclass
class Soak:
    """One run."""

    service: ServiceProcess
    router: Router
    fleet: list[Tracked]
    console: Console
    usage: Usage = field(default_factory=Usage)
    orphans: list[str] = field(default_factory=list)
    """Sessions whose clients were killed."""
    round_s: list[float] = field(default_factory=list)

    def run(self, duration_s: float, faults: Sequence[tuple[float, str, Callable[[], None]]]) -> None:
        """Play rounds, and inject each fault when its share of the time is over; each, however slow the machine."""
        started_s, waiting, told_s = time.monotonic(), list(faults), 0.0
        while (passed_s := time.monotonic() - started_s) < duration_s or waiting:
            if waiting and passed_s >= waiting[0][0] * duration_s:
                _, name, fault = waiting.pop(0)
                self.console.print(f"{passed_s:6.0f} s  {name}")
                fault()
            before_s = time.monotonic()
            play_round(self.fleet, ANSWER_WITHIN_S)
            self.round_s.append(time.monotonic() - before_s)
            self.usage.look(self.service.pid)
            if passed_s >= told_s:
                told_s += duration_s / LINES
                self.tell(passed_s)

    def tell(self, passed_s: float) -> None:
        """How things are."""
        self.console.print(
            f"{passed_s:6.0f} s  {self.usage.memory_mib[-1]:5.0f} MiB  {self.usage.handles[-1]:4d} handles  "
            f"{sum(len(each.errors_m) for each in self.fleet):6d} answers, "
            f"worst {max(max(each.errors_m, default=0.0) for each in self.fleet) * 100:.1f} cm"
        )

    def kill_service(self) -> None:
        """As the kernel does when memory is short."""
        os.kill(self.service.pid, signal.SIGKILL)
        self.service.stop()
        self.service.__enter__()
        self.usage.restart()

    def kill_client(self) -> None:
        """Its session has to go by itself."""
        self.orphans.append(kill_client(self.service.url))

    def orphans_left(self) -> list[str]:
        """Sessions of killed clients that are there long after the grace time."""
        deadline = time.monotonic() + 2 * GRACE_S
        while left := [each for each in self.orphans if is_open(self.service.url, each)]:
            if time.monotonic() > deadline:
                break
            time.sleep(1)
        return left


def verdict(soak: Soak, flood: Flood) -> list[Line]:
    """Each line: what, measured, whether it holds."""
    errors_m = np.concatenate([each.errors_m for each in soak.fleet])
    wrong = int((errors_m > WRONG_M).sum())
    answers = [len(each.errors_m) for each in soak.fleet]
    counted, usage = metrics(soak.service.url), soak.usage
    defects = counted['captra_frames_rejected_total{reason="internal-error"}'] + flood.crashes
    left = soak.orphans_left()
    ended = sum(each.ended for each in soak.fleet)
    opened = counted["captra_sessions_restored_total"], len(soak.fleet) + 1
    memory, handles = growth_of(usage.memory_mib), growth_of(usage.handles)
    return [
        ("sessions, answers", f"{len(answers)}, {len(errors_m)}", min(answers) > 0),
        (f"answers more than {WRONG_M * 100:.0f} cm from their own truth", f"{wrong}", wrong == 0),
        ("distance from it, median / largest", f"{np.median(errors_m):.4f} / {errors_m.max():.3f} m", True),
        ("fewest / most answers of a session", f"{min(answers)} / {max(answers)}", min(answers) > 0.8 * max(answers)),
        ("clouds put again", f"{sum(each.unanswered for each in soak.fleet)}", True),
        ("sessions that ended under their client", f"{ended}", ended == 0),
        ("sessions gone on with after kill -9", f"{opened[0]:.0f} of {opened[1]}", opened[0] == opened[1]),
        ("malformed clouds, defects met", f"{flood.sent}, {defects:.0f}", defects == 0),
        ("sessions of killed clients, still there", f"{len(soak.orphans)}, {len(left)}", not left),
        ("memory, growth", f"{usage.memory_mib[-1]:.0f} MiB, {memory:+.1%}", memory < GROWTH),
        ("file handles, growth", f"{usage.handles[-1]}, {handles:+.1%}", handles < GROWTH),
        ("round of all sessions, median", f"{np.median(soak.round_s):.2f} s", True),
    ]


def main(
    sessions: Annotated[int, typer.Option(help="Sessions at the same time.")] = 64,
    minutes: Annotated[float, typer.Option(help="How long.")] = 10.0,
) -> None:
    """Run, and print what came of it."""
    console = Console(width=110)
    console.print(this_machine())
    with ExitStack() as resources:
        inner = f"tcp/127.0.0.1:{free_ports(1)[0]}"
        router = resources.enter_context(Router(inner))
        settings = {
            "CAPTRA_ZENOH_LISTEN": json.dumps([inner]),
            "CAPTRA_ZENOH_ADVERTISE": json.dumps([router.endpoint]),
            "CAPTRA_CLIENT_GRACE_S": str(GRACE_S),
        }
        service = resources.enter_context(mug_service(sessions + 3, **settings))
        with closing(RestApi(service.url)) as api:
            flooded = api.post_session(FLOODED)["session_id"]
        fleet = resources.enter_context(open_fleet(service.url, sessions))
        flood = resources.enter_context(Flood(service.url, flooded, MALFORMED_HZ))
        soak = Soak(service, router, fleet, console)
        watcher = stalled_watcher(router.endpoint)
        soak.run(
            60 * minutes,
            [
                (0.05, "somebody subscribes to everything and reads nothing", lambda: resources.enter_context(watcher)),
                (0.10, "kill -9 of the service", soak.kill_service),
                (0.25, "kill -9 of the router", router.restart),
                (0.35, f"the router freezes for {FROZEN_S:.0f} s", lambda: router.freeze(FROZEN_S)),
                (0.45, "kill -9 of a client", soak.kill_client),
                (0.50, "kill -9 of another client", soak.kill_client),
            ],
        )
        status = tell(console, verdict(soak, flood))
    sys.exit(status)


if __name__ == "__main__":
    typer.run(main)

"""What viewers of the live page cost: tracking without any and with two, in turns within one run.

python -m benchmarks.viewers

Viewers are processes that open the page's stream, look at the newest session as the page does, and read all they get;
they draw nothing, since a browser does that on somebody else's machine.
"""

import json
import multiprocessing as mp
import statistics
import struct
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from captra.bench.machine import this_machine
from captra.bench.runs import BenchRun
from captra.data.recordings import load_recording
from clients.demo import COFFEE_MUG
from clients.measuring import Load, Setup, measure_load
from clients.service_process import ServiceProcess

ROOT = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class Seen:
    """What one viewer got."""

    clouds: int
    """Binary messages."""
    points: int
    """Of all of them."""
    seconds: float
    """From its first cloud to its last."""


@dataclass(frozen=True)
class Round:
    """One measurement."""

    viewers: int
    """That watched it."""
    run: BenchRun
    """What the service measured."""
    seen: Sequence[Seen]
    """One a viewer."""


def main(
    recording: Annotated[Path, typer.Option(help="Recording to play.")] = COFFEE_MUG,
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = ROOT / "models",
    profile: Annotated[str, typer.Option(help="realtime or paper.")] = "realtime",
    provider: Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")] = "auto",
    viewers: Annotated[int, typer.Option(help="How many watch in every second round.")] = 2,
    rounds: Annotated[int, typer.Option(help="Rounds without viewers, and as many with them.")] = 5,
    frames: Annotated[int, typer.Option(help="Frames timed in a round.")] = 120,
) -> None:
    """Measure in turns and print both side by side."""
    machine = this_machine()
    console = Console(width=120)
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    load = Load(load_recording(recording), streams=1, frames=frames)
    settings = {"CAPTRA_MODELS_DIR": str(models), "CAPTRA_PROFILE": profile, "CAPTRA_PROVIDER": provider}
    measured = []
    with ServiceProcess(settings) as service:
        for number in range(2 * rounds):
            watching = viewers * ((number + number // 2) % 2)  # 0 2 2 0 0 2 …: neither always comes first
            with watched(service.url, watching) as seen:
                run = measure_load(service, Setup(models, profile, provider), load)
            measured.append(Round(watching, run, seen))
    console.print(table(measured, viewers))


@contextmanager
def watched(url: str, viewers: int) -> Iterator[list[Seen]]:
    """Some viewers, connected; what they saw is in the list afterwards."""
    context = mp.get_context("spawn")
    pipes = [context.Pipe() for _ in range(viewers)]
    processes = [context.Process(target=watch, args=(url, theirs)) for _, theirs in pipes]
    for process in processes:
        process.start()
    seen: list[Seen] = []
    try:
        for ours, _ in pipes:
            ours.recv()
        yield seen
        for ours, _ in pipes:
            ours.send("enough")
            seen.append(ours.recv())
    finally:
        for process in processes:
            process.join()


def watch(url: str, pipe: Connection) -> None:
    """Look at the newest session until told that it is enough."""
    looking_at, arrivals_s, points = None, [], 0
    with connect(url.replace("http", "ws", 1) + "/viewer/stream", max_size=None) as socket:
        pipe.send("there")
        while not pipe.poll():
            try:
                message = socket.recv(1.0)
            except TimeoutError:
                continue
            except ConnectionClosed:
                break
            if isinstance(message, bytes):
                arrivals_s.append(time.perf_counter())
                points += (len(message) - 4 - struct.unpack_from("<I", message)[0]) // 6
            elif (news := json.loads(message))["type"] == "overview" and news["sessions"]:
                newest = news["sessions"][-1]["session_id"]
                if newest != looking_at:
                    socket.send(json.dumps({"type": "watch", "session": newest}))
                    looking_at = newest
    pipe.send(Seen(len(arrivals_s), points, arrivals_s[-1] - arrivals_s[0] if arrivals_s else 0.0))


def table(measured: Sequence[Round], viewers: int) -> Table:
    """Without and with viewers, means over rounds."""
    shown = Table(title=f"{measured[0].run.profile}, {measured[0].run.provider}: means over rounds taken in turns")
    for column in ("viewers", "rounds", "FPS", "total ms p50 / p95", "CPU ms a frame", "clouds/s a viewer", "slower"):
        shown.add_column(column, justify="right")
    alone = mean_fps([each for each in measured if each.viewers == 0])
    for count in (0, viewers):
        chosen = [each for each in measured if each.viewers == count]
        seen = [one for each in chosen for one in each.seen if one.seconds > 0]
        rates = [one.clouds / one.seconds for one in seen]
        slower = [1 - each.run.fps / alone for each in chosen]
        shown.add_row(
            str(count),
            str(len(chosen)),
            f"{mean_fps(chosen):.1f} ({min(each.run.fps for each in chosen):.1f} to "
            f"{max(each.run.fps for each in chosen):.1f})",
            " / ".join(f"{statistics.mean(getattr(each.run.total, p) for each in chosen):.1f}" for p in ("p50", "p95")),
            f"{statistics.mean(each.run.cpu_ms_per_frame for each in chosen):.1f}",
            f"{statistics.mean(rates):.1f}" if rates else "–",
            f"{100 * statistics.mean(slower):.1f} %" if count else "–",
        )
    return shown


def mean_fps(rounds: Sequence[Round]) -> float:
    """Frames a second."""
    return statistics.mean(each.run.fps for each in rounds)


if __name__ == "__main__":
    typer.run(main)

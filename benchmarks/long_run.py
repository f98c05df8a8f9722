"""Whether a service stays as large as it is over many frames: HTTP, Zenoh, sessions and store as they are served.

    python -m benchmarks.long_run --frames 100000

Two categories are tracked at a time in one service. Its networks are those that ship, at so few points that a frame
takes few milliseconds, and clouds are small: what a frame leaves behind does not depend on either. Nothing is searched
for, since at so few points tracks do not hold. `--real` takes the profile `realtime` and whole clouds instead. Ends
with status 0 only if memory has not grown by more than the limit after the first tenth.
"""

import json
import sys
import time
from collections.abc import Generator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Annotated
from unittest import mock

import typer

from captra.data.recordings import Recording, load_recording
from captra.sampling import REALTIME, Profile
from clients.measuring import PATIENCE_S, resident_mib
from clients.service_process import ServiceProcess
from clients.session import open_session
from service import bundles
from service.run import run
from service.settings import load_settings

SMALL = Profile(REALTIME.name, 128, (32, 8), ((4, 8, 16), (8, 16)))
EVERY = 20
"""Of so many points of a cloud one is kept."""

RECORDINGS = ("mug__sweethome3d-KatorLegaz__coffee-mug__hand", "can__osrf_gazebo__coke_can__table")
ROWS = 20
LIMIT_MIB = 8.0
SERVE = "serve"


def main(
    frames: Annotated[int, typer.Option(help="So many, over both sessions.")] = 100_000,
    provider: Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")] = "auto",
    real: Annotated[bool, typer.Option("--real", help="The profile and clouds of every day.")] = False,
    recordings: Annotated[Path, typer.Option(help="Folder of the recordings that ship.")] = Path("recordings"),
) -> None:
    """Track a mug and a can again and again and print the memory of the service."""
    played = [load_recording(recordings / f"{name}.npz") for name in RECORDINGS]
    if not real:
        played = [replace(each, clouds=[cloud[::EVERY] for cloud in each.clouds]) for each in played]
    module = ("captra", "serve") if real else ("benchmarks.long_run", SERVE)
    categories = [each.category.name for each in played]
    settings = {"CAPTRA_PROVIDER": provider, "CAPTRA_PRELOAD": json.dumps(categories), "CAPTRA_SEARCH_BUDGET_MS": "0"}
    memory_mib: list[float] = []
    with ServiceProcess(settings, module=module) as service, ThreadPoolExecutor(2) as pool:
        started_s = time.perf_counter()
        rounds = [passes(each, service.url, frames // ROWS // len(played)) for each in played]
        for row in range(ROWS):
            done = sum(pool.map(next, rounds)) * (row + 1)
            memory_mib.append(resident_mib(service.pid))
            rate = done / (time.perf_counter() - started_s)
            print(f"{done:>9} frames: {memory_mib[-1]:.1f} MiB, {rate:.0f} frames a second", flush=True)
        for each in rounds:
            each.close()
    first = memory_mib[ROWS // 10 - 1]
    grown = max(memory_mib[ROWS // 10 :]) - first
    print(f"grown by {grown:.1f} MiB after the first tenth")
    sys.exit(grown > LIMIT_MIB)


def passes(recording: Recording, url: str, frames: int) -> Generator[int]:
    """One session for good, which goes on by so many frames whenever it is asked to, from the start again and again."""
    with open_session(recording.category.name, recording.init, url=url) as session:
        while True:
            done = 0
            while done < frames:
                for _ in session.track(recording.clouds[: frames - done], timeout_s=PATIENCE_S):
                    done += 1
                session.reset(recording.init)
            yield done


def serve_small() -> None:
    """The service as it is, with another budget under the name of the profile that sessions take."""
    with mock.patch.object(bundles, "PROFILES", {SMALL.name: SMALL}):
        run(load_settings(None, {}))


if __name__ == "__main__":
    if sys.argv[1:] == [SERVE]:
        serve_small()
    else:
        typer.run(main)

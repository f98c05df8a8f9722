"""Streams recordings through a service of one's own and collects what it says of its time."""

import json
import os
import re
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import httpx
import numpy as np

from captra.bench.runs import BenchRun, Percentiles, histogram_percentiles
from captra.bench.work import multiply_adds
from captra.categories import Category
from captra.data.recordings import Recording
from captra.runtime.bundle import load_manifest
from captra.runtime.onnx_networks import rotated_points_of
from captra.sampling import PROFILES
from clients.results import Result
from clients.service_process import ServiceProcess
from clients.session import open_session

WARM_UP_FRAMES = 5
PATIENCE_S = 60.0
BUCKET = re.compile(
    r'captra_stage_seconds_bucket\{.*?le="(?P<bound>[^"]+)".*?stage="(?P<stage>[^"]+)"\} (?P<count>\S+)'
)


@dataclass(frozen=True)
class Load:
    """What a service is given to do."""

    recording: Recording
    """Played from its start again and again."""
    streams: int
    """Sessions at the same time."""
    frames: int
    """Timed, of each session."""


@dataclass(frozen=True)
class Setup:
    """How the service that is measured was started."""

    models: Path
    """Folder of bundles."""
    profile: str
    """Of sessions."""
    provider: str
    """Of onnxruntime."""
    ready_s: float = 0.0
    """How long it took to be ready."""
    peak_gflops: float = float("inf")
    """Of matrix products; unknown by default, and so is what the networks reach of it."""


@dataclass(frozen=True)
class Stream:
    """What came back in one session."""

    results: Sequence[Result]
    """In order."""
    done_s: Sequence[float]
    """When each arrived, on the clock of `time.perf_counter`."""


def measure(models: Path, profile: str, provider: str, loads: Sequence[Load], peak_gflops: float) -> list[BenchRun]:
    """Start a service with the categories of the loads and put one load after the other on it.

    Raises:
        ServiceUnreachableError: it does not start, or stops.
    """
    started_s = time.perf_counter()
    categories = sorted({load.recording.category.name for load in loads})
    settings = {"CAPTRA_MODELS_DIR": str(models), "CAPTRA_PROFILE": profile, "CAPTRA_PROVIDER": provider}
    settings["CAPTRA_PRELOAD"] = json.dumps(categories)
    with ServiceProcess(settings) as service:
        setup = Setup(models, profile, provider, time.perf_counter() - started_s, peak_gflops)
        return [measure_load(service, setup, load) for load in loads]


def measure_load(service: ServiceProcess, setup: Setup, load: Load) -> BenchRun:
    """Every frame is sent when the answer to the one before it is there."""
    with ThreadPoolExecutor(load.streams) as pool:
        list(pool.map(lambda _: follow(service.url, load.recording, WARM_UP_FRAMES), range(load.streams)))
        before, cpu_s, started_s = stage_counts(service.url), cpu_seconds(service.pid), time.perf_counter()
        measured = list(pool.map(lambda _: follow(service.url, load.recording, load.frames), range(load.streams)))
        elapsed_s, cpu_s = time.perf_counter() - started_s, cpu_seconds(service.pid) - cpu_s
        after = stage_counts(service.url)
    timings = [result.timing_ms for stream in measured for result in stream.results]
    first_done_s = min(stream.done_s[-1] for stream in measured)
    done = [int(np.searchsorted(stream.done_s, first_done_s, side="right")) for stream in measured]
    return BenchRun(
        category=load.recording.category.name,
        profile=setup.profile,
        provider=setup.provider,
        streams=load.streams,
        frames=len(timings),
        fps=len(timings) / elapsed_s,
        slowest_stream_share=float(min(done) / np.mean(done)),
        total=Percentiles.of([timing.total for timing in timings]),
        queue=Percentiles.of([timing.queue for timing in timings]),
        sample=Percentiles.of([timing.sample for timing in timings]),
        networks=Percentiles.of([timing.infer for timing in timings]),
        fit=Percentiles.of([timing.solve for timing in timings]),
        decode=_between(before, after, "decode"),
        publish=_between(before, after, "publish"),
        cpu_ms_per_frame=1e3 * cpu_s / len(timings),
        resident_mib=resident_mib(service.pid),
        ready_s=setup.ready_s,
        multiply_adds=_multiply_adds(setup, load.recording.category),
        gemm_peak_gflops=setup.peak_gflops,
    )


def _multiply_adds(setup: Setup, category: Category) -> int:
    profile = PROFILES[setup.profile]
    share = load_manifest(setup.models / category.name).rotation_share
    return multiply_adds(category, profile, rotated_points_of(share, profile))


def follow(url: str, recording: Recording, frames: int) -> Stream:
    """A session of its own for so many frames."""
    results, done_s = list[Result](), list[float]()
    with open_session(recording.category.name, recording.init, url=url) as session:
        while len(results) < frames:
            for result in session.track(recording.clouds[: frames - len(results)], timeout_s=PATIENCE_S):
                results.append(result)
                done_s.append(time.perf_counter())
            session.reset(recording.init)
    return Stream(results, done_s)


def stage_counts(url: str) -> dict[str, dict[float, float]]:
    """How many frames took at most so many seconds for each stage, from the service's metrics."""
    counts: dict[str, dict[float, float]] = {}
    for line in httpx.get(f"{url}/metrics").raise_for_status().text.splitlines():
        if found := BUCKET.match(line):
            counts.setdefault(found["stage"], {})[float(found["bound"])] = float(found["count"])
    return counts


def _between(before: dict[str, dict[float, float]], after: dict[str, dict[float, float]], stage: str) -> Percentiles:
    bounds = sorted(after[stage])
    cumulative = [after[stage][bound] - before.get(stage, {}).get(bound, 0.0) for bound in bounds]
    return histogram_percentiles(bounds, np.diff(cumulative, prepend=0.0).tolist())


def cpu_seconds(pid: int) -> float:
    """User and system time that a process has used."""
    fields = Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident_mib(pid: int) -> float:
    """Memory that a process holds."""
    pages = int(Path(f"/proc/{pid}/statm").read_text(encoding="utf-8").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20

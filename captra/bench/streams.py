"""Runs trackers as the service does, one thread a stream on shared networks, and times every stage."""

import resource
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from captra.data.recordings import Recording
from captra.tracker import Networks, StepTiming, Tracker


@dataclass(frozen=True)
class Percentiles:
    """Of one stage, milliseconds."""

    p50: float
    """Median."""
    p95: float
    """95th percentile."""
    p99: float
    """99th percentile."""

    @staticmethod
    def of(values_ms: Sequence[float]) -> "Percentiles":
        """Of some measurements.

        Raises:
            ValueError: without any.
        """
        if len(values_ms) == 0:
            raise ValueError("nothing was measured")
        return Percentiles(*(float(p) for p in np.percentile(values_ms, (50, 95, 99))))


@dataclass(frozen=True)
class BenchRun:
    """One combination measured."""

    category: str
    """Of the object."""
    profile: str
    """Sampling budget."""
    provider: str
    """Of onnxruntime."""
    streams: int
    """Trackers side by side."""
    frames: int
    """Timed, over all streams."""
    fps: float
    """Frames a second, over all streams."""
    slowest_stream_share: float
    """Frames of the slowest stream over an equal share, at the moment when the first one was done."""
    total: Percentiles
    """Cloud in to pose out, milliseconds."""
    sample: Percentiles
    """Crop, farthest points, neighbourhoods."""
    infer: Percentiles
    """Both networks."""
    solve: Percentiles
    """Fits and health."""
    cpu_ms_per_frame: float
    """CPU time of the whole process."""
    resident_mib: float
    """Largest resident set of the process so far."""


def run_streams(
    networks: Networks, recording: Recording, provider: str, streams: int, frames: int, warm_up: int = 5
) -> BenchRun:
    """Track `frames` frames on each of `streams` threads, as fast as they come; each pass starts anew."""
    trackers = [Tracker(networks, recording.init) for _ in range(streams)]
    for tracker in trackers:
        _follow(tracker, recording, warm_up)
    cpu, started = time.process_time(), time.perf_counter()
    with ThreadPoolExecutor(streams) as pool:
        measured = list(pool.map(lambda tracker: _follow(tracker, recording, frames), trackers))
    elapsed, cpu = time.perf_counter() - started, time.process_time() - cpu
    timings = [timing for timing, _ in measured]
    first_done = min(stamps[-1] for _, stamps in measured)
    done = [np.searchsorted(stamps, first_done, side="right") for _, stamps in measured]
    flat = [step for stream in timings for step in stream]
    return BenchRun(
        category=networks.category.name,
        profile=networks.profile.name,
        provider=provider,
        streams=streams,
        frames=len(flat),
        fps=len(flat) / elapsed,
        slowest_stream_share=float(min(done) / np.mean(done)),
        total=Percentiles.of([step.sample_ms + step.infer_ms + step.solve_ms for step in flat]),
        sample=Percentiles.of([step.sample_ms for step in flat]),
        infer=Percentiles.of([step.infer_ms for step in flat]),
        solve=Percentiles.of([step.solve_ms for step in flat]),
        cpu_ms_per_frame=1e3 * cpu / len(flat),
        resident_mib=resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    )


def _follow(tracker: Tracker, recording: Recording, frames: int) -> tuple[list[StepTiming], list[float]]:
    timings, stamps = [], []
    for frame in range(frames):
        index = frame % len(recording)
        if index == 0:
            tracker.reset(recording.init)
        timings.append(tracker.step(recording.clouds[index]).timing)
        stamps.append(time.perf_counter())
    return timings, stamps

"""What one measurement says."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


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
    """One combination measured; every time is the service's own."""

    category: str
    """Of the object."""
    profile: str
    """Sampling budget."""
    provider: str
    """Of onnxruntime."""
    streams: int
    """Sessions side by side."""
    frames: int
    """Timed, over all streams."""
    fps: float
    """Frames a second, over all streams, client and network included."""
    slowest_stream_share: float
    """Frames of the slowest stream over an equal share, at the moment when the first one was done."""
    total: Percentiles
    """Payload in to result out."""
    queue: Percentiles
    """Between arrival and the start of work."""
    sample: Percentiles
    """Crop, farthest points, neighbourhoods."""
    networks: Percentiles
    """Both networks."""
    fit: Percentiles
    """Fits and health."""
    decode: Percentiles
    """From bytes to points; interpolated within the buckets of the service's histogram."""
    publish: Percentiles
    """Handing the result to Zenoh; likewise."""
    cpu_ms_per_frame: float
    """CPU time of the service."""
    resident_mib: float
    """Resident set of the service after the run, with the networks of all categories measured loaded."""
    ready_s: float
    """From the start of the process until it could track."""
    multiply_adds: int
    """Of the networks, a frame."""
    gemm_peak_gflops: float
    """Of both cores with this provider, measured in the same run."""

    @property
    def cores_busy(self) -> float:
        """Cores that the service keeps busy: more streams can win no more than what is idle."""
        return self.cpu_ms_per_frame * self.fps / 1e3

    @property
    def peak_share(self) -> float:
        """What the networks reach of the peak in the median frame; streams side by side share it."""
        return 2e-6 * self.multiply_adds / self.networks.p50 / self.gemm_peak_gflops


@dataclass(frozen=True)
class ScalingRow:
    """One step of a tracker without service, at some number of points; medians in milliseconds."""

    category: str
    """Of the object."""
    parts: int
    """Of the object."""
    points: int
    """Given to the networks, with the groups of the profile `realtime`."""
    provider: str
    """Of onnxruntime."""
    sample_ms: float
    """Crop, farthest points, neighbourhoods."""
    networks_ms: float
    """Both networks."""
    fit_ms: float
    """Fits and health."""
    multiply_adds: int
    """Of the networks."""


@dataclass(frozen=True)
class Hop:
    """Round trips of a payload through a Zenoh router on loopback, there and back."""

    payload_bytes: int
    """Size."""
    round_trip: Percentiles
    """Milliseconds."""


def histogram_percentiles(bounds_s: Sequence[float], counts: Sequence[float]) -> Percentiles:
    """Milliseconds, interpolated evenly within buckets; beyond the last bound its own value.

    Args:
        bounds_s: upper bounds of the buckets, ascending; the last one may be infinite.
        counts: observations in each bucket.

    Raises:
        ValueError: nothing was measured.
    """
    total = sum(counts)
    if not total:
        raise ValueError("nothing was measured")
    edges = np.array([0.0, *bounds_s])
    edges[~np.isfinite(edges)] = edges[np.isfinite(edges)].max()
    reached = np.concatenate([[0.0], np.cumsum(counts)]) / total
    return Percentiles(*(float(1e3 * np.interp(share, reached, edges)) for share in (0.50, 0.95, 0.99)))

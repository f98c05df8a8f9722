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
    decode_mean_ms: float
    """From bytes to points, the mean."""
    publish_mean_ms: float
    """Handing the result to Zenoh, the mean."""
    cpu_ms_per_frame: float
    """CPU time of the service."""
    resident_mib: float
    """Resident set of the service after the run, with every bundle of the folder loaded."""
    ready_s: float
    """From the start of the process until it could track."""

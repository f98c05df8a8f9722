"""How the cost of a step grows with the number of points and of parts, without a service around it."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from captra.bench.runs import ScalingRow
from captra.bench.work import multiply_adds
from captra.data.recordings import Recording
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import REALTIME
from captra.tracker import Tracker

POINTS = (512, 1024, 2048, 4096)
WARM_UP_FRAMES = 3


def scaling(models: Path, provider: str, recordings: Sequence[Recording], frames: int) -> Iterator[ScalingRow]:
    """Track the first frames of each recording at each number of points."""
    for recording in recordings:
        for points in POINTS:
            yield _measured(models, provider, recording, points, frames)


def _measured(models: Path, provider: str, recording: Recording, points: int, frames: int) -> ScalingRow:
    category = recording.category
    profile = replace(REALTIME, name=f"{points} points", points=points)
    networks = OnnxNetworks.load(models / category.name, profile, provider)
    tracker = Tracker(networks, recording.init)
    timings = [tracker.step(cloud).timing for cloud in recording.clouds[: frames + WARM_UP_FRAMES]][WARM_UP_FRAMES:]
    return ScalingRow(
        category.name,
        category.num_parts,
        points,
        provider,
        sample_ms=float(np.median([timing.sample_ms for timing in timings])),
        networks_ms=float(np.median([timing.infer_ms for timing in timings])),
        fit_ms=float(np.median([timing.solve_ms for timing in timings])),
        multiply_adds=multiply_adds(category, profile, networks.rotated_points),
    )

"""Tracks sequences and scores them, wherever the work is done."""

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Protocol

from captra.data.recordings import Recording
from captra.evaluation.scoring import SequenceScore, score
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.workers import Workers
from captra.geometry import Pose
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES, NoPointsError
from captra.tracker import Networks, Tracker


class NetworksSource(Hashable, Protocol):
    """Networks that are not loaded yet; small and hashable, so that other processes can load them."""

    def load(self) -> Networks:
        """Load them."""


@dataclass(frozen=True)
class ExportedNetworks:
    """A bundle and how to run it."""

    bundle: Path
    """Folder of the bundle."""
    profile: str
    """realtime or paper."""
    provider: str
    """cpu, openvino, cuda or auto."""
    threads: int
    """Of one run."""

    def load(self) -> OnnxNetworks:
        """Load both networks."""
        return OnnxNetworks.load(self.bundle, PROFILES[self.profile], self.provider, self.threads)


def track(networks: Networks, recording: Recording) -> list[Pose]:
    """Poses of frames 1, 2, … from the recording's first pose; a frame without points keeps the last pose."""
    tracker = Tracker(networks, recording.init)
    poses = []
    for cloud in recording.clouds[1:]:
        try:
            poses.append(tracker.step(cloud).pose)
        except NoPointsError:
            poses.append(tracker.pose)
    return poses


def evaluate(networks: NetworksSource, sources: Iterable[SequenceSource], workers: Workers) -> Iterator[SequenceScore]:
    """Track and score every sequence with one set of networks; the scores come in the order of the sources."""
    return workers.map(partial(track_and_score, networks), sources)


def track_and_score(networks: NetworksSource, source: SequenceSource) -> SequenceScore:
    """Load, track and score one sequence."""
    sequence = source.load()
    return score(sequence.recording, track(_loaded(networks), sequence.recording), sequence.model)


@lru_cache(maxsize=1)
def _loaded(networks: NetworksSource) -> Networks:
    """The networks of the last sequence, which mostly are those of the next one too."""
    return networks.load()

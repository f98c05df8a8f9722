"""Tracks sequences and scores them, wherever the work is done."""

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache, partial
from pathlib import Path
from typing import Protocol

from captra.evaluation.followers.follower import Follower, Track
from captra.evaluation.followers.served import ONE_LOOK, Served
from captra.evaluation.response import Response, response
from captra.evaluation.scoring import SequenceScore, score
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.summary import Summary, average, summarize
from captra.evaluation.workers import Workers
from captra.looking import Networks
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES

AS_SERVED = Served()


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


@dataclass(frozen=True)
class Outcome:
    """One sequence, followed and scored."""

    source: SequenceSource
    """Where the sequence comes from."""
    track: Track
    """What the follower said."""
    score: SequenceScore
    """How wrong it was."""


def evaluate(
    networks: NetworksSource, sources: Iterable[SequenceSource], workers: Workers, follower: Follower = AS_SERVED
) -> Iterator[Outcome]:
    """Follow and score every sequence with one set of networks; outcomes come in the order of the sources."""
    return workers.map(partial(follow_and_score, networks, follower), sources)


def mean_over(name: str, networks: NetworksSource, sources: Iterable[SequenceSource], workers: Workers) -> Summary:
    """Means over all sequences under a name, without a search: what the networks do by themselves."""
    outcomes = evaluate(networks, sources, workers, ONE_LOOK)
    return average(name, [summarize(outcome.score) for outcome in outcomes])


def follow_and_score(networks: NetworksSource, follower: Follower, source: SequenceSource) -> Outcome:
    """Load, follow and score one sequence."""
    sequence = source.load()
    track = follower(loaded(networks), sequence)
    return Outcome(source, track, score(sequence.recording, track.poses, sequence.model))


def response_of(
    networks: NetworksSource, sources: Iterable[SequenceSource], workers: Workers
) -> Iterator[list[Response]]:
    """The response test on every sequence."""
    return workers.map(partial(_respond, networks), sources)


def _respond(networks: NetworksSource, source: SequenceSource) -> list[Response]:
    return response(loaded(networks), source.load().recording)


@lru_cache(maxsize=1)
def loaded(networks: NetworksSource) -> Networks:
    """The networks of the last sequence, which mostly are those of the next one too."""
    return networks.load()

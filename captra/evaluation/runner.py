"""Runs a tracker over recordings."""

from collections.abc import Callable, Iterable, Sequence

from captra.data.recordings import Recording
from captra.evaluation.scoring import SequenceScore, score
from captra.geometry import Pose
from captra.sampling import NoPointsError
from captra.tracker import Networks, Tracker


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


def evaluate(
    networks: Networks, recordings: Iterable[Recording], progress: Callable[[SequenceScore], None] = lambda _: None
) -> Sequence[SequenceScore]:
    """Track and score every recording with one set of networks."""
    scores = []
    for recording in recordings:
        scores.append(score(recording, track(networks, recording)))
        progress(scores[-1])
    return scores

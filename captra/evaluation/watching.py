"""Tracks incidents and notes, frame by frame, what the tracker said and what was true."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float64

from captra.confidence import FEATURES, features
from captra.evaluation.incidents import Incident
from captra.evaluation.observability import symmetric_frames
from captra.geometry import Pose
from captra.health import State
from captra.metrics import rotation_error_deg, translation_error_cm, within
from captra.sampling import NoPointsError
from captra.tracker import Tracker


@dataclass(frozen=True)
class Watched:
    """One incident as a tracker saw it; frames start with the second one."""

    name: str
    """Of the sequence and what happened in it."""
    kind: str
    """A key of `INCIDENTS`."""
    start: int
    """First frame of the recording that was not as it should be."""
    stop: int
    """First frame that was as it should be again."""
    seen: Bool[np.ndarray, " frames"]
    """Whether the object was in the cloud."""
    states: tuple[State, ...]
    """What the tracker said of each frame."""
    confidence: Float64[np.ndarray, " frames"]
    """How sure it was; 0 for frames without points near the object."""
    rotation_deg: Float64[np.ndarray, "frames parts"]
    """Error of what it published."""
    translation_cm: Float64[np.ndarray, "frames parts"]
    """Error of what it published."""
    features: Float64[np.ndarray, "frames parts features"]
    """What the confidence was computed from; NaN for frames without points near the object."""
    looks_ms: Float64[np.ndarray, " frames"]
    """Time of each step."""

    @property
    def part_correct(self) -> Bool[np.ndarray, "frames parts"]:
        """Whether each part is in the cloud and within 5° and 5 cm: nothing bears out what is not seen."""
        return np.asarray(within(self.rotation_deg, self.translation_cm) & self.seen[:, None])

    @property
    def correct(self) -> Bool[np.ndarray, " frames"]:
        """Whether every part is."""
        return np.asarray(self.part_correct.all(axis=1))


def watch(start: Callable[[Pose], Tracker], incidents: Iterable[Incident]) -> Iterator[Watched]:
    """Track every incident from its recording's first pose."""
    for incident in incidents:
        yield _watch(start(incident.recording.init), incident)


def _watch(tracker: Tracker, incident: Incident) -> Watched:
    recording = incident.recording
    parts, symmetric = recording.category.num_parts, symmetric_frames(recording)
    rows = []
    for frame in range(1, len(recording)):
        try:
            result = tracker.step(recording.clouds[frame], time_s=recording.stamps_ns[frame] * 1e-9)
        except NoPointsError:
            told = (tracker.pose, tracker.health.state, 0.0, np.full((parts, len(FEATURES)), np.nan), 0.0)
        else:
            distinct = result.evidence.distinct_points
            known = np.stack([features(part, distinct) for part in result.evidence.parts])
            told = (result.pose, result.state, result.confidence, known, result.timing.total_ms)
        pose, truth = told[0], recording.truth(frame)
        rotation = rotation_error_deg(pose.rotation, truth.rotation, symmetric=bool(symmetric[frame]))
        rows.append((*told[1:], rotation, translation_error_cm(pose.translation, truth.translation)))
    states, confidence, known, looks_ms, rotation, translation = zip(*rows, strict=True)
    return Watched(
        recording.name,
        incident.kind,
        incident.start,
        incident.stop,
        incident.seen[1:],
        states,
        np.array(confidence),
        np.array(rotation),
        np.array(translation),
        np.array(known),
        np.array(looks_ms),
    )

"""Tracks incidents and notes, frame by frame, what the tracker said and what was true."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float64

from captra.confidence import FEATURES, features
from captra.data.recordings import Recording
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
    found: Bool[np.ndarray, "frames parts"]
    """Whether the look that its evidence comes from found each part within 5° and 5 cm, if the object was in the cloud:
    while a search finds nothing better, an older pose is published."""
    rotation_deg: Float64[np.ndarray, "frames parts"]
    """Error of what it published."""
    translation_cm: Float64[np.ndarray, "frames parts"]
    """Error of what it published."""
    features: Float64[np.ndarray, "frames parts features"]
    """What the confidence was computed from; NaN for frames without points near the object."""
    looks_ms: Float64[np.ndarray, " frames"]
    """Time of each step."""

    @property
    def correct(self) -> Bool[np.ndarray, " frames"]:
        """Whether the object is in the cloud and every part of what was published within 5° and 5 cm.

        Nothing bears out what is not seen.
        """
        return np.asarray(within(self.rotation_deg, self.translation_cm).all(axis=1) & self.seen)


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
            told = (tracker.health.state, 0.0, np.full((parts, len(FEATURES)), np.nan), 0.0)
            published = tracker.pose
        else:
            told = (result.state, result.confidence, features(result.evidence), result.timing.total_ms)
            published = result.pose
        rotation, translation = _errors(published, recording, frame, symmetric=bool(symmetric[frame]))
        looked = within(*_errors(tracker.pose, recording, frame, symmetric=bool(symmetric[frame])))
        rows.append((*told, rotation, translation, looked & incident.seen[frame]))
    states, confidence, evidence, looks_ms, rotations, translations, found = zip(*rows, strict=True)
    return Watched(
        name=recording.name,
        kind=incident.kind,
        start=incident.start,
        stop=incident.stop,
        seen=incident.seen[1:],
        states=states,
        confidence=np.array(confidence),
        found=np.array(found),
        rotation_deg=np.array(rotations),
        translation_cm=np.array(translations),
        features=np.array(evidence),
        looks_ms=np.array(looks_ms),
    )


def _errors(
    pose: Pose, recording: Recording, frame: int, *, symmetric: bool
) -> tuple[Float64[np.ndarray, " parts"], Float64[np.ndarray, " parts"]]:
    """Degrees and centimetres of each part."""
    truth = recording.truth(frame)
    rotation = rotation_error_deg(pose.rotation, truth.rotation, symmetric=symmetric)
    return rotation, translation_error_cm(pose.translation, truth.translation)

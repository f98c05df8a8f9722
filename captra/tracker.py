"""One step of the method: the last pose and a new cloud in, the new pose of every part out (paper, Fig. "pipeline")."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from captra.evidence import Evidence
from captra.geometry import Pose
from captra.health import HealthMonitor, State
from captra.joint_projection import JointProjection
from captra.joints import JointValue, joint_values
from captra.looking import Networks, Sighting, StepTiming, look
from captra.motion import STANDING_STILL, MotionModel
from captra.observations import Observation, PointCloud
from captra.output_filter import UNFILTERED, OutputFilter
from captra.pose_memory import FoundError
from captra.recovery import NO_SEARCH, Search, SearchBudget, most_agreed
from captra.remembering import Remembered
from captra.riding import Standstill, carried, ride_along, rides
from captra.sampling import NoPointsError
from captra.segmentation import NOTHING_KNOWN, Segmentation
from captra.size_memory import GIVEN_ERROR, SizeMemory
from captra.solving import hold_gauge
from captra.visibility import Visibility

CONVINCING = 0.5
"""Confidence of one look by itself over which it is believed wherever it was: it is right more likely than not."""

LOOKS_AT_START = 2
"""What the first look leaves of a given pose's error is put down to the networks unless another follows."""


@dataclass(frozen=True)
class TrackResult:
    """What one frame told."""

    pose: Pose
    """Pose of every part, in the frame of the cloud."""
    state: State
    """Whether the track holds."""
    confidence: float
    """Probability in [0, 1] that this pose is within 5° and 5 cm."""
    joints: tuple[JointValue, ...]
    """Joint states in the order of the category's joints."""
    evidence: Evidence
    """What the confidence was computed from."""
    timing: StepTiming
    """Milliseconds per stage."""


@dataclass(frozen=True)
class TrackerOptions:
    """What a track may do beyond the paper's method; each has a null object, which is the default."""

    motion: MotionModel = STANDING_STILL
    """Where to look next, while the track holds."""
    search: SearchBudget = NO_SEARCH
    """How many looks a frame may take while the track does not hold."""
    projection: JointProjection | None = None
    """What joints allow; by default what the networks come with."""
    output_filter: OutputFilter = UNFILTERED
    """Smooths what is published; never fed back."""
    given_size_error: float = GIVEN_ERROR
    """Standard deviation of the logarithm of the size of a given pose; at 0 it is taken for known."""
    found_error: FoundError | None = None
    """Of poses as networks find them: the larger, the more of the difference to the given pose is remembered; by
    default what the networks come with."""


class Tracker:
    """Follows one object; not thread-safe: one tracker belongs to one stream."""

    def __init__(
        self,
        networks: Networks,
        pose: Pose,
        health: HealthMonitor | None = None,
        options: TrackerOptions | None = None,
    ) -> None:
        self._networks = networks
        self._options = options or TrackerOptions()
        self._category = networks.category
        self._health = health or HealthMonitor()
        self._looks = 1
        self.reset(pose)

    @property
    def pose(self) -> Pose:
        """The last pose."""
        return self._pose

    @property
    def size(self) -> SizeMemory:
        """What is remembered of the object's size."""
        return self._remembered.size

    @property
    def health(self) -> HealthMonitor:
        """State and confidence after the last frame."""
        return self._health

    @property
    def looks(self) -> int:
        """How many looks the last frame might take; given again with the same frames, they lead to the same poses."""
        return self._looks

    def reset(self, pose: Pose) -> None:
        """Start again from `pose`.

        Raises:
            ValueError: when the pose has another number of parts than the category.
        """
        if pose.num_parts != self._category.num_parts:
            raise ValueError(
                f"{self._category.name} has {self._category.num_parts} parts ({', '.join(self._category.parts)}), "
                f"but the pose has {pose.num_parts}"
            )
        self._pose = pose
        self._given = True  # and rough: the first look may well find the object elsewhere
        found_error = self._options.found_error or self._networks.found_error
        self._remembered = Remembered.of(pose, self._category, self._options.given_size_error, found_error)
        self._visibility, self._standstill = Visibility(), Standstill.of(self._category)
        self._health = self._health.restarted()
        self._motion = self._options.motion.restarted(pose)
        self._search = Search(pose)
        self._filter = self._options.output_filter.restarted()

    def displace(self, pose: Pose) -> None:
        """Take `pose` for where the object was last, without forgetting its size or the track's health."""
        self._pose = pose
        self._motion = self._options.motion.restarted(pose)

    def step(
        self,
        observed: Observation | Float[np.ndarray, "all 3"],
        segmentation: Segmentation = NOTHING_KNOWN,
        time_s: float | None = None,
        looks: int | None = None,
    ) -> TrackResult:
        """Find the object in what a sensor saw, given where it was.

        Args:
            observed: a cloud as an array, metres, or any other observation.
            segmentation: what is known beforehand of which points belong to the object; it overrules CoordinateNet.
            time_s: when it was seen, seconds since anything; without it frames count as equally far apart.
            looks: how many poses may be looked around while the track does not hold; by default what the search allows.

        Raises:
            NoPointsError: nothing was seen near the object; the pose stays as it was.
        """
        observation = PointCloud.of(observed) if isinstance(observed, np.ndarray) else observed
        self._looks = self._options.search.looks() if looks is None else looks
        best = self._choose(self._look(observation, segmentation, self._hypotheses(time_s)))
        self._health = self._health.updated(self._health.confidence_of(best.evidence))
        self._pose, self._given = self._placed(best), False
        self._standstill = self._standstill.updated(best.evidence, trusted=self._health.trusted)
        if self._health.trusted:
            self._visibility = self._visibility.updated(best.evidence)
        self._motion = self._motion.observed(self._pose, time_s, trusted=self._health.trusted)
        self._search = self._search.updated(self._pose, self._health.state, self._looks)
        published, self._filter = self._filter.filtered(self._published(), time_s)
        joints = joint_values(published, self._category)
        return TrackResult(published, self._health.state, self._health.confidence, joints, best.evidence, best.timing)

    def _hypotheses(self, time_s: float | None) -> Iterable[Pose]:
        """Where to look: around a given pose, and later where the object is expected."""
        if self._given:
            return self._search.starts(self._category.perturbation.translation_m, self._looks)
        return self._search.hypotheses(self._motion.expected(time_s), self._health.state, self._looks)

    def _look(self, observation: Observation, segmentation: Segmentation, around: Iterable[Pose]) -> Sequence[Sighting]:
        """Look around every pose near which there are points; beside a given pose only if it leads nowhere itself."""
        sightings, refusal = list[Sighting](), NoPointsError()
        for pose in around:
            try:
                sightings.append(self._settle(observation, segmentation, pose))
            except NoPointsError as error:
                refusal = error
            if self._given and (not sightings or self._told(sightings[0]) >= CONVINCING):
                break
        if not sightings:
            self._health, self._standstill = self._health.missed(), self._standstill.missed()
            self._search = self._search.updated(self._pose, self._health.state, self._looks)
            raise refusal
        return sightings

    def _settle(self, observation: Observation, segmentation: Segmentation, around: Pose) -> Sighting:
        """Look once; around a given pose, which is rough, again from where the look before led."""
        found = self._look_once(observation, segmentation, around)
        for _ in range(LOOKS_AT_START - 1 if self._given else 0):
            before, (around, _) = found.timing, self._sized(found)
            found = self._look_once(observation, segmentation, around)
            found = replace(found, timing=StepTiming.sum([before, found.timing]))
        return found

    def _look_once(self, observation: Observation, segmentation: Segmentation, around: Pose) -> Sighting:
        """Look around one pose, on the search's time."""
        found = look(self._networks, observation, around, segmentation, self._options.projection)
        self._options.search.spent(found.timing.total_ms)
        return replace(found, evidence=self._beside_the_past(found.pose, found.evidence))

    def _beside_the_past(self, pose: Pose, evidence: Evidence) -> Evidence:
        """How much less is seen than usual, and which parts go with others: none beside a pose that was given."""
        judged = self._visibility.judged(evidence)
        if self._given:
            return judged
        return replace(judged, rides=self._standstill.judged(rides(pose, evidence, self._category), self._category))

    def _choose(self, sightings: Sequence[Sighting]) -> Sighting:
        """The best one if it convinces, else the first, which goes on from the last pose; with the time of all of them.

        Among poses that nobody would trust the best is no better than chance, and would lead astray a track that is
        only doubted. Around a given pose the best is the one that most starts lead to.
        """
        told = np.array([self._told(sighting) for sighting in sightings])
        centres_m = np.array([sighting.pose.translation.mean(axis=0) for sighting in sightings])
        chosen = most_agreed(told, centres_m, self._pose.scale.max()) if self._given else int(np.argmax(told))
        best = sightings[chosen if told[chosen] >= CONVINCING else 0]
        evidence = best.evidence.without_jumps() if self._given else best.evidence
        return replace(best, evidence=evidence, timing=StepTiming.sum(sighting.timing for sighting in sightings))

    def _told(self, sighting: Sighting) -> float:
        """Confidence of one look by itself, wherever it looked."""
        return self._health.confidence_of(sighting.evidence.without_jumps())

    def _sized(self, found: Sighting) -> tuple[Pose, Remembered]:
        """What was found, in the gauge, at the size that the track would remember after it, around the points."""
        pose, remembered = hold_gauge(found.pose, self._pose, self._category), self._remembered
        if self._credible:
            remembered = remembered.measured(pose, found.evidence)
        return remembered.sized(pose, found.evidence), remembered

    def _placed(self, found: Sighting) -> Pose:
        """Where the object is believed to be: what was found, and what is remembered that cannot be seen."""
        evidence = found.evidence
        pose, remembered = self._sized(found)
        if not self._given:
            pose = carried(pose, self._pose, evidence.fitted * evidence.explained_points)
        elif self._credible:
            remembered = remembered.beside(self._pose, pose, evidence)
        if self._credible:
            last = remembered.place(pose, evidence) if self._given else self._pose
            remembered = remembered.updated(pose, last, evidence)
        self._remembered = remembered
        return ride_along(remembered.place(pose, evidence), evidence, self._pose, self._category)

    @property
    def _credible(self) -> bool:
        """Whether a find tells of the object; the first one after a given pose does, however late it comes."""
        return self._given or self._health.state in (State.TRACKING, State.UNCERTAIN)

    def _published(self) -> Pose:
        """The last pose, or the last trusted one as long as a search has found nothing better.

        An object that comes alone in its cloud is where the cloud is, whatever the confidence thinks of its pose.
        """
        held = self._health.state is State.LOST and self._looks > 1 and self._category.background
        return self._search.trusted if held else self._pose

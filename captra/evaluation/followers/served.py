"""The tracker as it is served, also with its poses disturbed as the paper does to test robustness."""

import zlib
from dataclasses import dataclass

import numpy as np

from captra.evaluation.followers.follower import Track, follow
from captra.evaluation.sequences import Sequence
from captra.geometry import Pose
from captra.health import HealthMonitor, State
from captra.looking import Networks
from captra.motion import STANDING_STILL, MotionModel
from captra.perturbation import perturb
from captra.recovery import NO_SEARCH, LookBudget, SearchBudget
from captra.runtime.onnx_networks import OnnxNetworks
from captra.size_memory import GIVEN_ERROR
from captra.tracker import Tracker, TrackerOptions

AS_SEARCHED = LookBudget(4)
"""What the time that the service searches by default is worth on two cores, on any machine."""


@dataclass(frozen=True)
class Served:
    """The tracker as the service runs it: calibrated, and looking around while the track does not hold.

    By default the object is expected where it was, as in the paper; the service expects it where its velocity carries
    it, which `captra health` measures beside this.
    """

    label: str = "captra"
    """As tables name it."""
    start_noise: float = 0.0
    """Pose noise added to the given pose, which has the category's noise once already; in units of that noise."""
    frame_noise: float = 0.0
    """Pose noise added to the last pose before every step, in the same units."""
    given_size_error: float = GIVEN_ERROR
    """Standard deviation of the logarithm of the size of the given pose."""
    motion: MotionModel = STANDING_STILL
    """Where the next pose is expected."""
    search: SearchBudget = AS_SEARCHED
    """Looks a frame while the track does not hold."""

    def __call__(self, networks: Networks, sequence: Sequence) -> Track:
        """Follow the object; the noise is the same in every run."""
        recording = sequence.recording
        rng = np.random.default_rng(zlib.crc32(recording.name.encode()))
        start = _disturbed(recording.init, networks, rng, self.start_noise)
        options = TrackerOptions(motion=self.motion, search=self.search, given_size_error=self.given_size_error)
        tracker = Tracker(networks, start, _health_of(networks), options)
        states: list[State] = [State.TRACKING]

        def step(cloud: np.ndarray, frame: int, last: Pose) -> Pose:
            if self.frame_noise:
                tracker.displace(_disturbed(last, networks, rng, self.frame_noise))
            states.append(State.TRACKING)
            try:
                return tracker.step(cloud, time_s=1e-9 * recording.stamps_ns[frame]).pose
            finally:
                states[-1] = tracker.health.state  # also of a frame that shows nothing

        return Track(follow(sequence, start, step), tuple(states[1:]))


def _health_of(networks: Networks) -> HealthMonitor:
    """As the bundle says; uncalibrated for networks that come from elsewhere."""
    return HealthMonitor.calibrated(networks.manifest.health if isinstance(networks, OnnxNetworks) else {})


def _disturbed(pose: Pose, networks: Networks, rng: np.random.Generator, noise: float) -> Pose:
    return perturb(pose, networks.category, rng, noise) if noise else pose


ROBUSTNESS = (
    Served("Init x1", start_noise=1),
    Served("Init x2", start_noise=2),
    Served("All x1", frame_noise=1),
    Served("All x2", frame_noise=2),
)
"""The settings of the paper's table "Robustness to pose errors"."""

FIXED_SCALE = Served("scale fixed at its start", given_size_error=0.0)
"""What becomes of a track whose size is taken for known."""

ONE_LOOK = Served("one look a frame", search=NO_SEARCH)
"""What the networks do by themselves, whatever the confidence thinks of it."""

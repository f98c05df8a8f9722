"""What a training run is to do, stage by stage."""

from dataclasses import dataclass, field
from typing import Literal

from captra.sampling import REALTIME, InputSampling, Profile

NetworkName = Literal["coordinate", "rotation"]

COORDINATE: NetworkName = "coordinate"
ROTATION: NetworkName = "rotation"

TINY = Profile("tiny", 512, (128, 32), ((8, 16, 32), (16, 32)))
"""Half of `SMALL`'s points at its groups: where a run starts, twice as many samples in the same time."""

SMALL = Profile("small", 1024, (256, 64), ((8, 16, 32), (16, 32)))
"""Groups cut to a quarter: what most samples are trained at, since weights depend on neither points nor group sizes."""

PAPER_LIGHT = Profile("paper-light", 4096, (512, 128), ((16, 32, 64), (32, 64)))
"""The density of `paper` at half its groups."""


@dataclass(frozen=True)
class Stage:
    """A stretch of training on one mix of densities."""

    until: float
    """Share of the plan's samples after which the stage ends."""
    profiles: tuple[Profile, ...]
    """One is drawn for each batch."""


@dataclass(frozen=True)
class Plan:
    """One category's run."""

    samples: int = 60_000
    """Samples that each network sees before the run ends."""
    batch_size: int = 18
    """Samples a step."""
    learning_rate: float = 1e-3
    """Of Adam and, matched to it, of Muon at the start."""
    halvings: float = 5.0
    """How often the rate has halved at the end, evenly."""
    weight_decay: float = 1e-4
    """Of what Adam trains; batch norm makes the scale of all other layers meaningless."""
    averaging: float = 0.997
    """Decay of the moving average of the weights, a step; the average is what is exported."""
    head_start: float = 0.12
    """Share of the samples for which CoordinateNet trains alone; RotationNet then starts from its backbone."""
    rotation_share: float = 0.25
    """Share of the points, the first ones, that RotationNet's heads are run on."""
    least_object_points: int = 200
    """Views that show less of the object are left out: they cost as much as others and teach little."""
    density: InputSampling = field(default_factory=lambda: InputSampling(surroundings_weight=0.4, margin=0.1))
    """How clouds are sampled, in training and by the tracker."""
    stages: tuple[Stage, ...] = (
        Stage(until=0.6, profiles=(TINY,)),
        Stage(until=0.88, profiles=(TINY, SMALL)),
        Stage(until=0.96, profiles=(SMALL, REALTIME)),
        Stage(until=1.0, profiles=(REALTIME, REALTIME, PAPER_LIGHT)),
    )
    """Few points and small groups first, the mix of what is served last."""
    networks: tuple[NetworkName, ...] = (COORDINATE, ROTATION)
    """What is trained; the other one stays as it is."""
    anew: bool = False
    """Whether RotationNet starts from the backbone of the CoordinateNet to start from, not from its own weights."""
    seed: int = 1
    """Of weights, views and perturbations."""

    def stage_at(self, samples: int) -> Stage:
        """The stage that the sample belongs to."""
        progress = samples / self.samples
        return next((stage for stage in self.stages if progress < stage.until), self.stages[-1])

    def learning_rate_at(self, samples: int) -> float:
        """Halved evenly over the run."""
        return float(self.learning_rate * 0.5 ** (self.halvings * min(1.0, samples / self.samples)))

"""What predicting the next pose does at different frame rates."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from captra.evaluation.followers.served import Served
from captra.evaluation.runner import NetworksSource, evaluate
from captra.evaluation.sequences import Sequence as Scene
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.workers import Workers
from captra.motion import STANDING_STILL, ConstantVelocity

EVERY = (1, 3)
"""Of frames taken at 30 Hz: all of them, and every third one."""

FOLLOWERS = (Served("none", motion=STANDING_STILL), Served("constant velocity", motion=ConstantVelocity()))
"""Ways to expect the next pose."""


@dataclass(frozen=True)
class EveryNth:
    """A sequence as a slower camera would have taken it."""

    source: SequenceSource
    """The sequence."""
    step: int
    """One frame of so many is kept."""

    @property
    def name(self) -> str:
        """Of the recording."""
        return self.source.name

    def load(self) -> Scene:
        """Read or simulate it, and thin it out."""
        scene, every = self.source.load(), slice(None, None, self.step)
        r = scene.recording
        thinned = replace(
            r,
            stamps_ns=r.stamps_ns[every],
            clouds=r.clouds[every],
            labels=r.labels[every],
            rotation=r.rotation[every],
            translation=r.translation[every],
            joint_values=r.joint_values[every],
        )
        return replace(scene, recording=thinned)


@dataclass(frozen=True)
class Rate:
    """How well tracks go at one rate with one way to expect the next pose."""

    name: str
    """Of the category."""
    hertz: float
    """Frames per second."""
    prediction: str
    """How the next pose is expected."""
    frames: int
    """Tracked."""
    within_5deg_5cm_percent: float
    """Share of poses with both errors within bounds."""
    rotation_deg: float
    """Mean error."""
    translation_cm: float
    """Mean error."""


def rates(name: str, networks: NetworksSource, sources: Sequence[SequenceSource], workers: Workers) -> Iterable[Rate]:
    """Every rate with every way to expect the next pose."""
    for step in EVERY:
        thinned = [EveryNth(source, step) for source in sources]
        for follower in FOLLOWERS:
            scores = [outcome.score for outcome in evaluate(networks, thinned, workers, follower)]
            rotation_deg = np.concatenate([score.rotation_deg for score in scores])
            yield Rate(
                name=name,
                hertz=30 / step,
                prediction=follower.label,
                frames=len(rotation_deg),
                within_5deg_5cm_percent=float(100 * np.mean(np.concatenate([s.within_5deg_5cm for s in scores]))),
                rotation_deg=float(rotation_deg.mean()),
                translation_cm=float(np.concatenate([score.translation_cm for score in scores]).mean()),
            )


def pooled(found: Iterable[Rate]) -> Iterator[Rate]:
    """Several categories as one, in which every frame counts the same."""
    of_settings = defaultdict[tuple[float, str], list[Rate]](list)
    for one in found:
        of_settings[one.hertz, one.prediction].append(one)
    for (hertz, prediction), some in of_settings.items():
        frames = [one.frames for one in some]
        figures = np.array([[one.within_5deg_5cm_percent, one.rotation_deg, one.translation_cm] for one in some])
        yield Rate("all", hertz, prediction, sum(frames), *np.average(figures, axis=0, weights=frames).tolist())

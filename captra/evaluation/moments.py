"""The worst moments of many sequences, as pictures: what was seen, what was true, what was said."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from captra.evaluation.picture import draw_pose
from captra.evaluation.runner import Outcome

APART = 15
"""Frames between two moments of one sequence: a track that is lost is wrong for long."""
VIEW = np.array([[600.0, 0, 0], [0, 600.0, 0], [0, 0, 1]])
"""Camera matrix that clouds are drawn with."""
MARGIN_PX = 70


@dataclass(frozen=True)
class Moment:
    """One bad frame."""

    outcome: Outcome
    """Of the sequence that it belongs to."""
    frame: int
    """Number within the recording."""
    part: int
    """The part that is worst."""
    badness: float
    """Errors in units of 5° and 5 cm, added up."""


def worst_moments(outcomes: Sequence[Outcome], count: int = 10) -> list[Moment]:
    """The frames with the largest errors of any part, no two of one sequence close together."""
    moments: list[Moment] = []
    for outcome in outcomes:
        badness = outcome.score.rotation_deg / 5 + outcome.score.translation_cm / 5
        worst = badness.max(axis=1)
        free = np.ones(len(worst), bool)
        while free.any():
            index = int(np.where(free, worst, -1).argmax())
            moments.append(Moment(outcome, index + 1, int(badness[index].argmax()), float(worst[index])))
            free[max(0, index - APART) : index + APART] = False
    return sorted(moments, key=lambda moment: -moment.badness)[:count]


def draw_moment(moment: Moment, picture: Path) -> None:
    """The cloud as the camera sees it, true box in green and tracked one in orange, from two sides."""
    from matplotlib.figure import Figure

    recording = moment.outcome.source.load().recording
    cloud, labels = recording.clouds[moment.frame], recording.labels[moment.frame]
    truth, said = recording.truth(moment.frame), moment.outcome.track.poses[moment.frame - 1]
    score = moment.outcome.score
    figure = Figure(figsize=(11, 5.4), layout="constrained")
    center = truth.translation[moment.part]
    for axes, turn in zip(figure.subplots(1, 2), (np.eye(3), _from_the_side()), strict=True):
        seen = (cloud - center) @ turn.T + [0, 0, center[2]]
        pixels = seen[:, :2] / seen[:, 2:] * VIEW[0, 0]
        axes.scatter(*pixels.T, s=1.5, c=np.where(labels < len(truth.scale), labels, -1), cmap="tab10", vmin=-1, vmax=8)
        for pose, colour in ((truth, "limegreen"), (said, "darkorange")):
            moved = (pose.translation - center) @ turn.T + [0, 0, center[2]]
            draw_pose(axes, replace(pose, rotation=turn @ pose.rotation, translation=moved), VIEW, colour)
        radius = VIEW[0, 0] * truth.scale.max() / center[2] * 0.6 + MARGIN_PX
        axes.set(xlim=(-radius, radius), ylim=(radius, -radius), aspect="equal", xticks=[], yticks=[])
    rotation, translation = score.rotation_deg[moment.frame - 1], score.translation_cm[moment.frame - 1]
    part = recording.category.parts[moment.part]
    errors = f"{rotation[moment.part]:.1f}°, {translation[moment.part]:.1f} cm"
    figure.suptitle(f"{score.name}, frame {moment.frame}, {part}: {errors} (true green, tracked orange)")
    figure.savefig(picture, dpi=80)


def _from_the_side() -> np.ndarray:
    """A quarter turn about the camera's y axis: the camera looks along x."""
    return np.array([[0.0, 0, 1], [0, 1, 0], [-1, 0, 0]])

"""Errors over time, with the state that the tracker was in."""

from pathlib import Path

import numpy as np

from captra.categories import get_category
from captra.evaluation.runner import Outcome
from captra.evaluation.state_bands import PART_COLOURS, legend_of, shade


def plot_timeline(outcome: Outcome, picture: Path) -> None:
    """Draw rotation error, translation error and oriented IoU of every part over the frames, states behind them."""
    from matplotlib.figure import Figure

    score, states = outcome.score, outcome.track.states
    figure = Figure(figsize=(10, 6.5), layout="constrained")
    panels = (
        (score.rotation_deg, "rotation error, °", 5.0),
        (score.translation_cm, "translation error, cm", 5.0),
        (100 * score.iou, "IoU, %", None),
    )
    frames = np.arange(1, len(score.symmetric) + 1)
    parts = get_category(score.category).parts
    for axes, (values, label, bound) in zip(figure.subplots(3, 1, sharex=True), panels, strict=True):
        shade(axes, states, first=1)
        for part, name in enumerate(parts):
            axes.plot(frames, values[:, part], color=PART_COLOURS[part], linewidth=1.4, label=name)
        if bound is not None:
            axes.axhline(bound, color="black", linewidth=0.8, linestyle=":")
        axes.set(ylabel=label, xlim=(0.5, len(frames) + 0.5), ylim=(0, None))
    named = legend_of(states)
    figure.axes[0].legend(handles=[*figure.axes[0].lines[: len(parts)], *named], fontsize="small", ncols=4)
    figure.axes[0].set_title(score.name)
    figure.axes[-1].set_xlabel("frame")
    figure.savefig(picture, dpi=90)

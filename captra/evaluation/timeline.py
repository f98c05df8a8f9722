"""Errors over time, with the state that the tracker was in."""

from pathlib import Path

import numpy as np

from captra.categories import get_category
from captra.evaluation.runner import Outcome
from captra.health import State

COLOURS = {State.TRACKING: "#d9f2d9", State.UNCERTAIN: "#fff2cc", State.RECOVERING: "#d6e6ff", State.LOST: "#f8d0d0"}
PART_COLOURS = ("tab:blue", "tab:orange", "tab:green", "tab:red")


def plot_timeline(outcome: Outcome, picture: Path) -> None:
    """Draw rotation error, translation error and oriented IoU of every part over the frames, states behind them."""
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

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
        for first, last, state in stretches(states):
            axes.axvspan(first + 0.5, last + 1.5, color=COLOURS[state], linewidth=0)
        for part, name in enumerate(parts):
            axes.plot(frames, values[:, part], color=PART_COLOURS[part], linewidth=1.4, label=name)
        if bound is not None:
            axes.axhline(bound, color="black", linewidth=0.8, linestyle=":")
        axes.set(ylabel=label, xlim=(0.5, len(frames) + 0.5), ylim=(0, None))
    named = [Patch(color=COLOURS[state], label=state.value) for state in State if state in states]
    figure.axes[0].legend(handles=[*figure.axes[0].lines[: len(parts)], *named], fontsize="small", ncols=4)
    figure.axes[0].set_title(score.name)
    figure.axes[-1].set_xlabel("frame")
    figure.savefig(picture, dpi=90)


def stretches(states: tuple[State, ...]) -> list[tuple[int, int, State]]:
    """First and last index of every run of the same state."""
    found: list[tuple[int, int, State]] = []
    for index, state in enumerate(states):
        if found and found[-1][2] is state:
            found[-1] = (found[-1][0], index, state)
        else:
            found.append((index, index, state))
    return found

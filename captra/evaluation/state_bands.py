"""The states that a track was in, as bands of colour behind its curves."""

from collections.abc import Sequence
from typing import Any

from captra.health import State

COLOURS = {State.TRACKING: "#d9f2d9", State.UNCERTAIN: "#fff2cc", State.RECOVERING: "#d6e6ff", State.LOST: "#f8d0d0"}
PART_COLOURS = ("tab:blue", "tab:orange", "tab:green", "tab:red")


def stretches(states: Sequence[State]) -> list[tuple[int, int, State]]:
    """First and last index of every run of the same state."""
    found: list[tuple[int, int, State]] = []
    for index, state in enumerate(states):
        if found and found[-1][2] is state:
            found[-1] = (found[-1][0], index, state)
        else:
            found.append((index, index, state))
    return found


def shade(axes: Any, states: Sequence[State], first: float) -> None:
    """Colour the background; state i reaches half a frame to both sides of `first` + i."""
    for start, stop, state in stretches(states):
        axes.axvspan(start + first - 0.5, stop + first + 0.5, color=COLOURS[state], linewidth=0)


def legend_of(states: Sequence[State]) -> list[Any]:
    """Entries of a legend for the states that occur."""
    from matplotlib.patches import Patch

    return [Patch(color=COLOURS[state], label=state.value) for state in State if state in states]

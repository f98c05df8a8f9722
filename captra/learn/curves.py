"""Learning curves from a run's log."""

import json
from pathlib import Path

import numpy as np

SMOOTHING = 50
"""Steps that one point of a curve averages."""


def plot_curves(log: Path, picture: Path) -> None:
    """Draw each loss term over the samples seen, on a logarithmic scale; a log that is too short gives no picture."""
    from matplotlib.figure import Figure

    rows = [json.loads(line) for line in log.read_text().splitlines()]
    if len(rows) < 2 * SMOOTHING:
        return
    names = list(dict.fromkeys(name for row in rows for name in row if name != "samples"))
    figure = Figure(figsize=(9, 5), layout="constrained")
    axes = figure.subplots()
    for name in names:
        samples, values = np.array([(row["samples"], row[name]) for row in rows if name in row]).T
        blocks = len(values) // SMOOTHING
        if blocks:
            shape = (blocks, SMOOTHING)
            axes.plot(
                samples[: blocks * SMOOTHING].reshape(shape).mean(axis=1),
                values[: blocks * SMOOTHING].reshape(shape).mean(axis=1),
                label=name,
            )
    axes.set(xlabel="samples", ylabel="weighted loss", yscale="log")
    axes.legend(fontsize="small")
    figure.savefig(picture, dpi=110)


def plot_scores(log: Path, picture: Path) -> None:
    """Draw the validation score over the samples seen: training goes on for as long as it rises."""
    from matplotlib.figure import Figure

    samples, scores = np.array([list(json.loads(line).values()) for line in log.read_text().splitlines()]).T
    figure = Figure(figsize=(7, 4), layout="constrained")
    axes = figure.subplots()
    axes.plot(samples, scores, marker="o")
    axes.set(xlabel="samples", ylabel="validation score, %", xlim=(0, None))
    figure.savefig(picture, dpi=110)

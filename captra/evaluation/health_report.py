"""The figures of `captra health` as tables, Markdown, JSON and a reliability diagram."""

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from rich.table import Table

from captra.evaluation.health_figures import DEADLINE, HealthFigures, Share
from captra.evaluation.prediction_rates import Rate

RATE_COLUMNS = ("category", "Hz", "prediction", "frames", "5°5cm %", "rotation °", "translation cm")

OVERALL = "all"
"""The name of the figures over all categories."""

KIND_COLUMNS = (
    "what goes wrong",
    "incidents",
    "AUROC",
    "in sight",
    f"told within {DEADLINE}",
    "delay p50 / p95",
    "good called lost",
    "recovered",
    "… within 5° and 5 cm",
)

OCCLUSIONS = {"occlusion": "≥ 80 %", "occlusion, moved": "≥ 60 %"}
"""What recovery from 30 frames of occlusion should reach."""


def rows(found: Sequence[HealthFigures]) -> Iterator[tuple[str, ...]]:
    """What was measured, its bar, and a cell for each category."""

    def row(what: str, bar: str, cells: list[str]) -> tuple[str, ...]:
        return (what, bar, *cells)

    yield row("incidents", "", [str(one.incidents) for one in found])
    yield row("frames within 5° and 5 cm", "", [str(one.right) for one in found])
    yield row("AUROC of the confidence", "≥ 0.95", [_number(one.auroc) for one in found])
    yield row("… while the object is in sight", "", [_number(one.auroc_in_sight) for one in found])
    yield row("mean calibration error", "", [f"{one.calibration_error:.3f}" for one in found])
    yield row(f"losses told within {DEADLINE} frames", "≥ 95 %", [str(one.told_in_time) for one in found])
    yield row("delay p50 / p95, frames", "", [_delays(one) for one in found])
    yield row("good frames called lost", "≤ 1 %", [str(one.good_called_lost) for one in found])
    for kind in dict.fromkeys(kind for one in found for kind in one.recovered):
        cells = [str(one.recovered.get(kind, Share(0, 0))) for one in found]
        yield row(f"recovered: {kind}", OCCLUSIONS.get(kind, ""), cells)
        yield row("… within 5° and 5 cm", "", [str(one.recovered_well.get(kind, Share(0, 0))) for one in found])


def kind_rows(kinds: Sequence[HealthFigures]) -> Iterator[tuple[str, ...]]:
    """One row for each kind of incident."""
    for one in kinds:
        aurocs = (_number(one.auroc), _number(one.auroc_in_sight))
        back = (sum(shares.values(), Share(0, 0)) for shares in (one.recovered, one.recovered_well))
        told = (str(one.told_in_time), _delays(one), str(one.good_called_lost))
        yield (one.name, str(one.incidents), *aurocs, *told, *map(str, back))


def rate_rows(rates: Sequence[Rate]) -> Iterator[tuple[str, ...]]:
    """One row for each rate and way to expect the next pose."""
    for one in rates:
        errors = (f"{one.within_5deg_5cm_percent:.1f}", f"{one.rotation_deg:.2f}", f"{one.translation_cm:.2f}")
        yield (one.name, f"{one.hertz:.0f}", one.prediction, str(one.frames), *errors)


@dataclass(frozen=True)
class HealthReport:
    """Everything that one run found."""

    categories: Sequence[HealthFigures]
    """One entry a category, and one of all where there are several."""
    kinds: Sequence[HealthFigures]
    """One entry a kind of incident, over all categories."""
    rates: Sequence[Rate] = ()
    """With and without a prediction of the next pose."""


def tables(found: HealthReport) -> Iterator[Table]:
    """For the terminal."""
    for title, columns, body in _sections(found):
        yield _table(title, columns, body)


def markdown(found: HealthReport) -> str:
    """The same tables in Markdown."""
    return "\n\n".join(_markdown(columns, body) for _, columns, body in _sections(found)) + "\n"


def as_json(found: HealthReport) -> dict[str, Any]:
    """All figures as plain values; what could not be measured is null."""
    return {
        "health": [_plain(asdict(one)) for one in found.categories],
        "kinds": [_plain(asdict(one)) for one in found.kinds],
        "rates": [_plain(asdict(one)) for one in found.rates],
    }


def _sections(found: HealthReport) -> Iterator[tuple[str, tuple[str, ...], Iterator[tuple[str, ...]]]]:
    """Title, columns and rows of every table."""
    yield "how the tracker takes what goes wrong", _columns(found.categories), rows(found.categories)
    yield "by what goes wrong, over all categories", KIND_COLUMNS, kind_rows(found.kinds)
    if found.rates:
        yield "with and without a prediction of the next pose", RATE_COLUMNS, rate_rows(found.rates)


def draw_reliability(found: Sequence[HealthFigures], picture: Path) -> None:
    """Share of right frames over the confidence, a line a category; a dot's area tells how many frames it holds.

    Black is what holds over all categories.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.4, 5.0), layout="constrained")
    axes = figure.subplots()
    axes.plot([0, 1], [0, 1], color="black", linewidth=0.8, linestyle=":")
    for one in found:
        x, y = [b.confidence for b in one.reliability], [b.right.percent / 100 for b in one.reliability]
        style = {"color": "black", "linewidth": 2.0} if one.name == OVERALL else {"linewidth": 1.0}
        (line,) = axes.plot(x, y, label=f"{one.name}, AUROC {one.auroc:.3f}", **style)
        sizes = [8 + 150 * b.right.whole / one.right.whole for b in one.reliability]
        axes.scatter(x, y, s=sizes, color=line.get_color(), alpha=0.6)
    axes.set(xlim=(0, 1), ylim=(0, 1), xlabel="confidence", ylabel="share of poses within 5° and 5 cm", aspect="equal")
    figure.legend(fontsize="small", loc="outside right upper")
    figure.savefig(picture, dpi=110)


def _delays(one: HealthFigures) -> str:
    return f"{_number(one.delay_p50_frames, 0)} / {_number(one.delay_p95_frames, 0)}"


def _number(value: float, digits: int = 3) -> str:
    return f"{value:.{digits}f}" if np.isfinite(value) else "—"


def _columns(found: Sequence[HealthFigures]) -> tuple[str, ...]:
    return ("figure", "bar", *(one.name for one in found))


def _table(title: str, columns: Sequence[str], body: Iterator[tuple[str, ...]]) -> Table:
    result = Table(title=title)
    for index, column in enumerate(columns):
        result.add_column(column, justify="left" if index == 0 else "right", no_wrap=True)
    for cells in body:
        result.add_row(*cells)
    return result


def _markdown(columns: Sequence[str], body: Iterator[tuple[str, ...]]) -> str:
    rule = ["---", *["---:"] * (len(columns) - 1)]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in (columns, rule, *body))


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(inner) for inner in value]
    return None if isinstance(value, float) and not np.isfinite(value) else value

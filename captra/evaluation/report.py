"""Everything that an evaluation finds out, group by group, and the forms that it is told in."""

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from captra.evaluation import comparison, summary
from captra.evaluation.comparison import Comparison, compare, over_categories
from captra.evaluation.followers import Follower
from captra.evaluation.moments import draw_moment, worst_moments
from captra.evaluation.response import Response
from captra.evaluation.runner import NetworksSource, Outcome, evaluate, response_of
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.summary import Summary, average, average_of_parts, summarize
from captra.evaluation.table import comparison_table, response_table, table
from captra.evaluation.timeline import plot_timeline
from captra.evaluation.workers import Workers

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table


@dataclass
class Report:
    """Fills up while sequences are tracked."""

    rows: list[Summary] = field(default_factory=list)
    """Sequences, parts and means of the tracker as served."""
    others: list[Summary] = field(default_factory=list)
    """Means under noise and of the baselines."""
    compared: list[Comparison] = field(default_factory=list)
    """Beside the paper's figures."""
    responses: list[tuple[str, list[Response]]] = field(default_factory=list)
    """By category and group."""
    outcomes: list[Outcome] = field(default_factory=list)
    """All sequences as served."""
    _means: dict[str, dict[str, Summary]] = field(default_factory=dict)

    @property
    def is_empty(self) -> bool:
        """Whether no sequence was there to track."""
        return not self.outcomes

    def measure(
        self,
        networks: NetworksSource,
        category: str,
        group: str,
        sources: Sequence[SequenceSource],
        others: Sequence[Follower],
        workers: Workers,
        console: "Console",
        *,
        with_response: bool,
    ) -> None:
        """Track a group of sequences of one category, also with the other followers; nothing happens without any."""
        if not sources:
            return
        outcomes = []
        for outcome in evaluate(networks, sources, workers):
            outcomes.append(outcome)
            console.print(f"tracked {outcome.score.name}: 5°5cm {100 * outcome.score.within_5deg_5cm.mean():.1f} %")
        scores = [outcome.score for outcome in outcomes]
        found = [summarize(score) for score in scores]
        mean = average(f"{category}: mean of {len(found)} {group}", found)
        self.rows += [*found, *average_of_parts(scores), mean]
        self.outcomes += outcomes
        self.compared += compare(group, scores)
        self._means.setdefault(category, {})[group] = mean
        for follower in others:
            rows = [summarize(outcome.score) for outcome in evaluate(networks, sources, workers, follower)]
            self.others.append(average(f"{category}, {group}: {follower.label}", rows))
            console.print(f"{self.others[-1].name}: 5°5cm {self.others[-1].within_5deg_5cm_percent:.1f} %")
        if with_response:
            answers = list(response_of(networks, sources, workers))
            self.responses.append((f"{category}, {group}", joined(answers)))

    def means(self, category: str) -> dict[str, Summary]:
        """Means of a category by group."""
        return self._means.get(category, {})

    def tables(self, title: str) -> Iterator["Table"]:
        """For the terminal."""
        yield table(self.rows, title)
        yield comparison_table([*self.compared, *over_categories(self.compared)])
        if self.others:
            yield table(self.others, "the same sequences under noise, and by other methods")
        for name, responses in self.responses:
            yield response_table(name, responses)

    def markdown(self) -> str:
        """All tables in Markdown."""
        parts = [
            summary.markdown(self.rows),
            "Here, and as the paper reports for its own test data (rigid: NOCS-REAL275, articulated: SAPIEN):",
            comparison.markdown([*self.compared, *over_categories(self.compared)]),
        ]
        if self.others:
            parts += ["The same sequences under noise, and by other methods:", summary.markdown(self.others)]
        if self.responses:
            lines = ["| sequences | part | axis | left | frames |", "| --- | --- | --- | ---: | ---: |"]
            lines += [
                f"| {name} | {one.part} | {one.axis} | {one.median_left:.2f} | {len(one.left)} |"
                for name, responses in self.responses
                for one in responses
            ]
            parts += ["Share of a turn of ±5 … 15° that one step leaves:", "\n".join(lines)]
        return "\n\n".join(parts) + "\n"

    def as_json(self) -> dict[str, object]:
        """All rows as plain values."""
        return {
            "sequences": summary.as_json(self.rows),
            "paper": [asdict(row) for row in [*self.compared, *over_categories(self.compared)]],
            "others": summary.as_json(self.others),
            "response": [
                {"group": name, "part": one.part, "axis": one.axis, "left": one.median_left, "frames": len(one.left)}
                for name, responses in self.responses
                for one in responses
            ],
        }

    def draw(self, folder: Path) -> None:
        """Errors over time of every sequence, and the ten worst moments of all."""
        folder.mkdir(parents=True, exist_ok=True)
        for outcome in self.outcomes:
            plot_timeline(outcome, folder / f"time_{outcome.score.name}.png")
        for rank, moment in enumerate(worst_moments(self.outcomes), 1):
            draw_moment(moment, folder / f"worst_{rank:02d}_{moment.outcome.score.name}_{moment.frame}.png")


def joined(answers: Sequence[Sequence[Response]]) -> list[Response]:
    """The responses of several sequences of one category, part by part and axis by axis."""
    frames: dict[tuple[str, str], list[np.ndarray]] = {}
    for one in (one for answer in answers for one in answer):
        frames.setdefault((one.part, one.axis), []).append(one.left)
    return [Response(part, axis, np.concatenate(left)) for (part, axis), left in frames.items()]

"""Measured figures beside the paper's own, averaged as the paper does: over parts first, then over categories."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from captra.categories import Category, get_category
from captra.evaluation.paper import ARTICULATED_MEAN, CATEGORY_FIGURES, RIGID_MEAN, Figures, mean_figures
from captra.evaluation.scoring import SequenceScore
from captra.evaluation.summary import Summary, average, shown, summarize

COLUMNS = ("5°5cm %", "mIoU %", "R °", "T cm", "θ °", "d cm")


@dataclass(frozen=True)
class Comparison:
    """One row: what was measured, and what the paper reports."""

    group: str
    """Of sequences, e.g. `procedural`."""
    category: str
    """Of the objects; `rigid` or `articulated` for the mean over categories."""
    part: str
    """Name of the part; `mean` for the mean over parts."""
    measured: Figures
    """On these sequences."""
    paper: Figures
    """On the paper's: NOCS-REAL275 or SAPIEN."""


def compare(group: str, scores: Sequence[SequenceScore]) -> list[Comparison]:
    """Rows of one category: each part, and their mean; one row for an object of a single part."""
    category = get_category(scores[0].category)
    papers = CATEGORY_FIGURES[category.name].ours
    parts = [
        figures_of(average(name, [summarize(score, part) for score in scores]), category)
        for part, name in enumerate(category.parts)
    ]
    rows = [
        Comparison(group, category.name, name, measured, paper)
        for name, measured, paper in zip(category.parts, parts, papers, strict=True)
    ]
    return [
        *(rows if len(rows) > 1 else ()),
        Comparison(group, category.name, "mean", *map(mean_figures, (parts, papers))),
    ]


def over_categories(rows: Sequence[Comparison]) -> list[Comparison]:
    """The means of the rigid and of the articulated categories that were measured, beside the paper's over all."""
    means = [row for row in rows if row.part == "mean"]
    found = []
    for group in dict.fromkeys(row.group for row in means):
        for label, paper in (("rigid", RIGID_MEAN), ("articulated", ARTICULATED_MEAN)):
            chosen = [r.measured for r in means if r.group == group and _kind(get_category(r.category)) == label]
            if chosen:
                found.append(Comparison(group, label, f"mean of {len(chosen)}", mean_figures(chosen), paper))
    return found


def _kind(category: Category) -> str:
    return "rigid" if category.background else "articulated"


def figures_of(summary: Summary, category: Category) -> Figures:
    """The paper's measures of a summary: the NOCS form of IoU for rigid objects, the oriented one for others."""
    return Figures(
        within_5deg_5cm_percent=summary.within_5deg_5cm_percent,
        iou_percent=summary.iou_nocs_percent if category.background else summary.iou_oriented_percent,
        rotation_deg=summary.rotation_deg,
        translation_cm=summary.translation_cm,
        joint_deg=summary.joint_deg,
        joint_cm=summary.joint_cm,
    )


def cells(row: Comparison) -> list[str]:
    """`measured | paper` under `COLUMNS`."""
    digits = (1, 1, 2, 2, 2, 2)
    pairs = zip(vars(row.measured).values(), vars(row.paper).values(), digits, strict=True)
    return ["" if a is None and b is None else f"{shown(a, d)} | {shown(b, d)}" for a, b, d in pairs]


def markdown(rows: Iterable[Comparison]) -> str:
    """A table in Markdown; each cell holds what was measured and what the paper reports."""
    lines = ["| sequences | category | part | " + " | ".join(f"{name}: here / paper" for name in COLUMNS) + " |"]
    lines.append("| --- | --- | --- |" + " ---: |" * len(COLUMNS))
    for row in rows:
        figures = [cell.replace(" | ", " / ") for cell in cells(row)]
        lines.append("| " + " | ".join([row.group, row.category, row.part, *figures]) + " |")
    return "\n".join(lines)

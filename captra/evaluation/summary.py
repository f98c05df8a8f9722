"""Means over sequences, as the paper's tables have them."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass

import numpy as np

from captra.categories import JointKind, get_category
from captra.evaluation.scoring import SequenceScore


@dataclass(frozen=True)
class Summary:
    """One row of a table."""

    name: str
    """Of the sequence, or of the group or part it averages."""
    sequences: int
    """How many are averaged."""
    frames: int
    """Frames scored."""
    symmetric_frames: int
    """Of these, frames scored as symmetric about y."""
    within_5deg_5cm_percent: float
    """Share of poses with both errors within bounds."""
    iou_oriented_percent: float
    """Mean IoU of the boxes as they stand."""
    iou_nocs_percent: float
    """Mean IoU of their axis-aligned bounds."""
    rotation_deg: float
    """Mean error."""
    translation_cm: float
    """Mean error."""
    scale_percent: float
    """Mean relative error."""
    joint_deg: float | None
    """Mean error of revolute joints; None without any."""
    joint_cm: float | None
    """Mean error of prismatic joints; None without any."""
    ad10_percent: float | None
    """Share of poses whose model points are within a tenth of the diameter of where they belong; None if unknown."""


def summarize(score: SequenceScore, part: int | None = None) -> Summary:
    """Means over the frames of one sequence, and over its parts or of one of them (with the joint that moves it)."""
    chosen = slice(None) if part is None else slice(part, part + 1)
    category = get_category(score.category)

    def joint(kind: JointKind) -> float | None:
        wanted = [joint.kind == kind and part in {None, joint.child} for joint in category.joints]
        errors = score.joint_error[:, wanted] if wanted else np.zeros(0)
        return float(errors.mean()) if errors.size else None

    return Summary(
        name=score.name if part is None else category.parts[part],
        sequences=1,
        frames=len(score.symmetric),
        symmetric_frames=int(score.symmetric.sum()),
        within_5deg_5cm_percent=100 * float(score.within_5deg_5cm[:, chosen].mean()),
        iou_oriented_percent=100 * float(score.iou[:, chosen].mean()),
        iou_nocs_percent=100 * float(score.iou_nocs[:, chosen].mean()),
        rotation_deg=float(score.rotation_deg[:, chosen].mean()),
        translation_cm=float(score.translation_cm[:, chosen].mean()),
        scale_percent=float(score.scale_percent[:, chosen].mean()),
        joint_deg=joint("revolute"),
        joint_cm=joint("prismatic"),
        ad10_percent=100 * float(score.within_ad10[:, chosen].mean()) if score.within_ad10.size else None,
    )


def average(name: str, rows: Sequence[Summary]) -> Summary:
    """Mean of several rows, each counting the same.

    Raises:
        ValueError: without any row.
    """
    if not rows:
        raise ValueError(f"nothing to average for {name}")

    def mean(field: str) -> float:
        return float(np.mean([getattr(row, field) for row in rows]))

    def mean_of_known(field: str) -> float | None:
        known = [value for row in rows if (value := getattr(row, field)) is not None]
        return float(np.mean(known)) if known else None

    return Summary(
        name=name,
        sequences=sum(row.sequences for row in rows),
        frames=sum(row.frames for row in rows),
        symmetric_frames=sum(row.symmetric_frames for row in rows),
        within_5deg_5cm_percent=mean("within_5deg_5cm_percent"),
        iou_oriented_percent=mean("iou_oriented_percent"),
        iou_nocs_percent=mean("iou_nocs_percent"),
        rotation_deg=mean("rotation_deg"),
        translation_cm=mean("translation_cm"),
        scale_percent=mean("scale_percent"),
        joint_deg=mean_of_known("joint_deg"),
        joint_cm=mean_of_known("joint_cm"),
        ad10_percent=mean_of_known("ad10_percent"),
    )


def average_of_parts(scores: Sequence[SequenceScore]) -> list[Summary]:
    """One row a part, each the mean over all sequences of one category; none for an object of a single part."""
    parts = get_category(scores[0].category).parts
    if len(parts) == 1:
        return []
    return [average(name, [summarize(score, part) for score in scores]) for part, name in enumerate(parts)]


COLUMNS = ("5°5cm %", "mIoU %", "NOCS mIoU %", "R °", "T cm", "scale %", "θ °", "d cm", "AD10 %", "frames", "symmetric")


def cells(row: Summary) -> list[str]:
    """A row's figures under `COLUMNS`."""
    return [
        f"{row.within_5deg_5cm_percent:.1f}",
        f"{row.iou_oriented_percent:.1f}",
        f"{row.iou_nocs_percent:.1f}",
        f"{row.rotation_deg:.2f}",
        f"{row.translation_cm:.2f}",
        f"{row.scale_percent:.2f}",
        shown(row.joint_deg, 2),
        shown(row.joint_cm, 2),
        shown(row.ad10_percent, 1),
        str(row.frames),
        str(row.symmetric_frames),
    ]


def shown(value: float | None, digits: int) -> str:
    """A figure, or nothing where there is none."""
    return "" if value is None else f"{value:.{digits}f}"


def markdown(rows: Iterable[Summary]) -> str:
    """A table in Markdown."""
    lines = ["| sequence | " + " | ".join(COLUMNS) + " |", "| --- |" + " ---: |" * len(COLUMNS)]
    lines += ["| " + " | ".join([row.name, *cells(row)]) + " |" for row in rows]
    return "\n".join(lines)


def as_json(rows: Iterable[Summary]) -> list[dict[str, object]]:
    """Rows as plain values."""
    return [asdict(row) for row in rows]

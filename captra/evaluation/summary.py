"""Means over sequences, as the paper's tables have them."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass

import numpy as np

from captra.evaluation.scoring import SequenceScore


@dataclass(frozen=True)
class Summary:
    """One row of a table."""

    name: str
    """Of the sequence, or of the group it averages."""
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
    joint_error: float | None
    """Mean error, degrees or centimetres; None for rigid objects."""


def summarize(score: SequenceScore) -> Summary:
    """Means over the frames and parts of one sequence."""
    return Summary(
        name=score.name,
        frames=len(score.symmetric),
        symmetric_frames=int(score.symmetric.sum()),
        within_5deg_5cm_percent=100 * float(score.within_5deg_5cm.mean()),
        iou_oriented_percent=100 * float(score.iou.mean()),
        iou_nocs_percent=100 * float(score.iou_nocs.mean()),
        rotation_deg=float(score.rotation_deg.mean()),
        translation_cm=float(score.translation_cm.mean()),
        scale_percent=float(score.scale_percent.mean()),
        joint_error=float(score.joint_error.mean()) if score.joint_error.size else None,
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

    joints = [row.joint_error for row in rows if row.joint_error is not None]
    return Summary(
        name=name,
        frames=sum(row.frames for row in rows),
        symmetric_frames=sum(row.symmetric_frames for row in rows),
        within_5deg_5cm_percent=mean("within_5deg_5cm_percent"),
        iou_oriented_percent=mean("iou_oriented_percent"),
        iou_nocs_percent=mean("iou_nocs_percent"),
        rotation_deg=mean("rotation_deg"),
        translation_cm=mean("translation_cm"),
        scale_percent=mean("scale_percent"),
        joint_error=float(np.mean(joints)) if joints else None,
    )


COLUMNS = ("5°5cm %", "mIoU %", "NOCS mIoU %", "R °", "T cm", "scale %", "joints", "frames", "symmetric")


def cells(row: Summary) -> list[str]:
    """A row's figures under `COLUMNS`."""
    joints = "" if row.joint_error is None else f"{row.joint_error:.2f}"
    return [
        f"{row.within_5deg_5cm_percent:.1f}",
        f"{row.iou_oriented_percent:.1f}",
        f"{row.iou_nocs_percent:.1f}",
        f"{row.rotation_deg:.2f}",
        f"{row.translation_cm:.2f}",
        f"{row.scale_percent:.2f}",
        joints,
        str(row.frames),
        str(row.symmetric_frames),
    ]


def markdown(rows: Iterable[Summary]) -> str:
    """A table in Markdown."""
    lines = ["| sequence | " + " | ".join(COLUMNS) + " |", "| --- |" + " ---: |" * len(COLUMNS)]
    lines += ["| " + " | ".join([row.name, *cells(row)]) + " |" for row in rows]
    return "\n".join(lines)


def as_json(rows: Iterable[Summary]) -> list[dict[str, object]]:
    """Rows as plain values."""
    return [asdict(row) for row in rows]

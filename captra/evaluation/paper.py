"""The paper's own figures, as its tables print them; none of them is measured here.

Rigid objects were measured on NOCS-REAL275, articulated ones on held-out instances from SAPIEN: they say what the
method reached there, not on the sequences beside whose figures they stand.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

RIGID_TABLE = "Per-category results of category-level rigid object pose tracking on NOCS-REAL275"
ARTICULATED_TABLE = "Per-part, per-category results of category-level articulated object pose tracking (SAPIEN)"
ROBUSTNESS_TABLE = "Robustness to pose errors"


@dataclass(frozen=True)
class Figures:
    """One entry of a table."""

    within_5deg_5cm_percent: float
    """5°5cm."""
    iou_percent: float
    """mIoU; of axis-aligned bounds for rigid objects."""
    rotation_deg: float
    """R_err."""
    translation_cm: float
    """T_err."""
    joint_deg: float | None = None
    """θ_err of the joint that moves the part, or the mean over joints."""
    joint_cm: float | None = None
    """d_err, likewise."""


@dataclass(frozen=True)
class CategoryFigures:
    """What the paper reports of one category."""

    table: str
    """Caption of the table."""
    ours: tuple[Figures, ...]
    """The method's, one entry a part."""
    oracle_icp: tuple[Figures, ...]
    """Those of ICP on the true model, likewise."""


_SAPIEN = ARTICULATED_TABLE

CATEGORY_FIGURES: Mapping[str, CategoryFigures] = MappingProxyType(
    {
        "bottle": CategoryFigures(
            RIGID_TABLE, (Figures(79.46, 72.11, 3.29, 2.60),), (Figures(0.28, 10.72, 44.03, 8.28),)
        ),
        "bowl": CategoryFigures(
            RIGID_TABLE, (Figures(79.20, 79.64, 3.50, 1.43),), (Figures(0.45, 11.54, 30.31, 6.65),)
        ),
        "camera": CategoryFigures(
            RIGID_TABLE, (Figures(0.41, 2.50, 17.82, 35.53),), (Figures(0.60, 19.62, 36.09, 7.23),)
        ),
        "can": CategoryFigures(RIGID_TABLE, (Figures(64.70, 62.47, 3.43, 5.69),), (Figures(0.49, 10.50, 43.85, 8.48),)),
        "laptop": CategoryFigures(
            RIGID_TABLE, (Figures(94.03, 87.20, 2.24, 1.48),), (Figures(1.60, 22.11, 14.39, 8.41),)
        ),
        "mug": CategoryFigures(RIGID_TABLE, (Figures(55.17, 80.70, 5.36, 0.79),), (Figures(0.48, 13.63, 73.02, 7.21),)),
        "glasses": CategoryFigures(
            _SAPIEN,
            (
                Figures(97.7, 81.8, 1.72, 0.27, joint_deg=0.94),
                Figures(95.3, 81.4, 1.93, 0.26, joint_deg=0.97),
                Figures(99.6, 57.2, 1.22, 0.14),
            ),
            (
                Figures(46.9, 65.8, 11.00, 2.10, joint_deg=5.25),
                Figures(46.1, 67.2, 10.22, 2.82, joint_deg=4.25),
                Figures(78.4, 56.0, 4.66, 1.98),
            ),
        ),
        "scissors": CategoryFigures(
            _SAPIEN,
            (Figures(99.0, 65.6, 1.60, 0.12), Figures(99.4, 71.9, 1.17, 0.14, joint_deg=1.85)),
            (Figures(25.7, 19.9, 19.85, 7.80), Figures(28.3, 26.8, 17.30, 4.82, joint_deg=13.14)),
        ),
        "laptop_articulated": CategoryFigures(
            _SAPIEN,
            (Figures(97.1, 76.2, 0.62, 0.32), Figures(97.2, 53.5, 1.22, 0.35, joint_deg=1.33)),
            (Figures(81.4, 52.5, 6.85, 2.00), Figures(92.4, 62.7, 1.70, 0.90, joint_deg=3.74)),
        ),
        "drawers": CategoryFigures(
            _SAPIEN,
            (
                Figures(99.6, 85.1, 0.18, 0.59, joint_cm=0.37),
                Figures(99.6, 86.4, 0.18, 0.60, joint_cm=0.36),
                Figures(99.6, 89.8, 0.19, 0.38, joint_cm=0.28),
                Figures(99.7, 94.2, 0.23, 0.29),
            ),
            (
                Figures(65.8, 73.8, 8.45, 3.33, joint_cm=1.33),
                Figures(79.7, 80.8, 5.40, 2.51, joint_cm=1.00),
                Figures(79.9, 82.3, 2.69, 1.48, joint_cm=0.82),
                Figures(96.4, 93.3, 0.80, 1.07),
            ),
        ),
    }
)
"""Tables "Per-category results …" and "Per-part, per-category results …"."""

RIGID_MEAN = Figures(62.16, 64.10, 5.94, 7.92)
"""Table "Results of category-level rigid object pose tracking on NOCS-REAL275", ours."""
ARTICULATED_MEAN = Figures(98.35, 74.00, 1.03, 0.29, joint_deg=1.38, joint_cm=0.34)
"""Table "Experiment results and ablation studies of articulated object pose tracking", ours."""

ROBUSTNESS: Mapping[str, tuple[Figures, Figures]] = MappingProxyType(
    {
        "Orig.": (Figures(62.16, 64.10, 5.94, 7.92), Figures(98.35, 74.00, 1.03, 0.29)),
        "Init x1": (Figures(59.64, 61.40, 5.95, 10.23), Figures(98.40, 74.00, 1.03, 0.29)),
        "Init x2": (Figures(55.94, 57.56, 5.93, 10.78), Figures(97.75, 73.68, 1.18, 0.32)),
        "All x1": (Figures(59.83, 61.30, 5.81, 9.82), Figures(98.45, 74.05, 1.01, 0.29)),
        "All x2": (Figures(58.69, 60.40, 5.89, 13.08), Figures(97.68, 75.53, 1.39, 0.39)),
    }
)
"""Table "Robustness to pose errors": rigid, articulated."""


def mean_figures(rows: Sequence[Figures]) -> Figures:
    """Mean over parts or categories; joint errors over those that have the joint."""

    def known(values: Sequence[float | None]) -> float | None:
        there = [value for value in values if value is not None]
        return float(np.mean(there)) if there else None

    return Figures(
        within_5deg_5cm_percent=float(np.mean([row.within_5deg_5cm_percent for row in rows])),
        iou_percent=float(np.mean([row.iou_percent for row in rows])),
        rotation_deg=float(np.mean([row.rotation_deg for row in rows])),
        translation_cm=float(np.mean([row.translation_cm for row in rows])),
        joint_deg=known([row.joint_deg for row in rows]),
        joint_cm=known([row.joint_cm for row in rows]),
    )

"""What a step knows of itself: everything that tells how far to trust its pose."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Float64

from captra.geometry import Pose


@dataclass(frozen=True)
class PartEvidence:
    """How well one part's fit explains the points."""

    points: int
    """Points labelled as the part."""
    centroid: Float64[np.ndarray, "3"]
    """Their mean, metres, in the frame of the cloud; the part's centre for a part that could not be fitted."""
    residual: float
    """RMS distance between fitted coordinates and points, in units of the scale."""
    inliers: float
    """Fraction of the part's points that agree with the fit."""
    disagreement_rad: float
    """Angle between RotationNet's rotation and that of the full Umeyama fit."""
    rotation_jump_rad: float
    """Angle to the pose that was expected."""
    translation_jump: float
    """Distance to it, in units of its scale."""
    scale_jump: float
    """Absolute logarithm of the ratio to its scale."""
    spread: float
    """How far the points' own rotations are from agreeing: 0 for all the same, 1 for none alike."""
    shape_jump: float
    """Largest absolute logarithm of the ratio of the box's sides to those expected."""
    share: float
    """Share of the network's points that are labelled as the part."""
    filled: float
    """Share of the points in the expected box that are labelled as the part."""
    certainty: float
    """Mean probability of the part over the points labelled so."""
    outside: float
    """Share of the part's points that lie outside the box that was found, by more than a tenth of its sides."""
    thickness: float
    """Standard deviation of the part's points along the direction in which they spread least, in units of the scale:
    a board that stands before the object has none."""
    diagonal_error: float
    """Absolute logarithm of the ratio of the found box's diagonal to the scale: coordinates that shrink to the middle
    are those of networks that do not know."""

    @staticmethod
    def missing(points: int, centre: Float64[np.ndarray, "3"]) -> "PartEvidence":
        """Evidence of a part that could not be fitted and keeps its centre."""
        return PartEvidence(
            points=points,
            centroid=centre,
            residual=1.0,
            inliers=0.0,
            disagreement_rad=np.pi,
            rotation_jump_rad=0.0,
            translation_jump=0.0,
            scale_jump=0.0,
            spread=1.0,
            shape_jump=1.0,
            share=0.0,
            filled=0.0,
            certainty=0.0,
            outside=1.0,
            thickness=0.0,
            diagonal_error=1.0,
        )


@dataclass(frozen=True)
class Evidence:
    """Everything that confidence is computed from."""

    parts: tuple[PartEvidence, ...]
    """One entry a part."""
    foreground: float
    """Mean probability, over the network's points, of belonging to the object."""
    distinct_points: int
    """Points given to the networks, without repetitions: a sparse cloud has fewer than the profile asks for."""

    @property
    def centroid(self) -> Float64[np.ndarray, "parts 3"]:
        """Mean of each part's points."""
        return np.stack([part.centroid for part in self.parts])


def shape_jump(size: Float[np.ndarray, "3"], expected: Float[np.ndarray, "3"]) -> float:
    """Largest absolute logarithm of the ratio of two boxes' sides."""
    return float(np.abs(np.log(np.maximum(size, SMALLEST_SIDE_M) / np.maximum(expected, SMALLEST_SIDE_M))).max())


SMALLEST_SIDE_M = 1e-4
BOX_MARGIN = 0.1
"""Share of a box's sides that noise may carry its points beyond it."""


def thickness(points: Float[np.ndarray, "points 3"]) -> float:
    """Standard deviation of points along the direction in which they spread least, in their own unit."""
    return float(np.sqrt(max(0.0, float(np.linalg.eigvalsh(np.cov(points.T))[0]))))


def share_outside(points_part: Float[np.ndarray, "points 3"], size: Float[np.ndarray, "3"]) -> float:
    """Share of points in a part's own frame that lie outside its box, by more than a tenth of its sides."""
    return float(1 - (np.abs(points_part) <= (0.5 + BOX_MARGIN) * size).all(axis=-1).mean())


def inside_box(points: Float[np.ndarray, "points 3"], part: Pose) -> Bool[np.ndarray, " points"]:
    """Which points lie in the box of a pose of one part."""
    own = (points - part.translation[0]) @ part.rotation[0]
    return np.asarray((np.abs(own) <= part.size[0] / 2).all(axis=-1))

"""What a step knows of itself: everything that tells how far to trust its pose."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Float64, Int64

from captra.compiled import compiled
from captra.geometry import Pose
from captra.moments import Moments, doubles


@dataclass(frozen=True)
class PartEvidence:
    """How well one part's fit explains the points."""

    points: int
    """Points labelled as the part."""
    centroid: Float64[np.ndarray, "3"]
    """Their mean, metres, in the frame of the cloud; the part's centre for a part that could not be fitted."""
    explained: Float64[np.ndarray, "explained 3"]
    """Those of them that agree with the fit, metres, in the frame of the cloud; none of a part that keeps its pose."""
    residual: float
    """RMS distance between fitted coordinates and points, in units of the scale, but for the worst points."""
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
    guessed_turn: float
    """How far the turn about y is guesswork, since no point tells it."""
    diagonal_error: float
    """Absolute logarithm of the ratio of the found box's diagonal to the scale: coordinates that shrink to the middle
    are those of networks that do not know."""

    @staticmethod
    def missing(points: int, centre: Float64[np.ndarray, "3"]) -> "PartEvidence":
        """Evidence of a part that could not be fitted and keeps its centre."""
        return PartEvidence(
            points=points,
            centroid=centre,
            explained=np.zeros((0, 3)),
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
            guessed_turn=0.0,
            diagonal_error=1.0,
        )


@dataclass(frozen=True)
class Ride:
    """A part whose pose is told by another's as well, by way of the joint between them."""

    part: int
    """The one that goes along."""
    by: int
    """The one that it goes with."""
    joint: int
    """Which of the category's joints."""
    turned: float
    """Share of its turn about the joint's axis that is its own, as it was found."""
    seen: float
    """Likewise of the rest of its pose."""
    stood: float = 0.0
    """Frames, about, for which nothing has told whether the joint stands where it stood; 0 for slides."""


@dataclass(frozen=True)
class Evidence:
    """Everything that confidence is computed from."""

    parts: tuple[PartEvidence, ...]
    """One entry a part."""
    foreground: float
    """Mean probability, over the network's points, of belonging to the object."""
    distinct_points: int
    """Points given to the networks, without repetitions: a sparse cloud has fewer than the profile asks for."""
    visible: float = 0.0
    """How much of the object is seen: points of the cloud that the fits explain, times their distance² in m²."""
    vanished: float = 0.0
    """Logarithm of how many times less that is than the track is used to; 0 if it is not less."""
    rides: tuple[Ride, ...] = ()
    """Parts that go with others, as far as little tells how they stand themselves; those that others go with first."""

    def without_jumps(self) -> "Evidence":
        """The same for a look that was not expected to find the object just where it looked."""
        parts = (replace(part, rotation_jump_rad=0.0, translation_jump=0.0, scale_jump=0.0) for part in self.parts)
        return replace(self, parts=tuple(parts))

    def keeping(self, kept: Bool[np.ndarray, " parts"]) -> "Evidence":
        """The same where some parts keep their last pose, whatever was found."""
        nothing = np.zeros((0, 3))
        parts = (
            replace(part, explained=nothing) if keep else part for part, keep in zip(self.parts, kept, strict=True)
        )
        return replace(self, parts=tuple(parts))

    @property
    def explained_points(self) -> Int64[np.ndarray, " parts"]:
        """How many points each part's fit explains."""
        return np.array([len(part.explained) for part in self.parts])

    @property
    def fitted(self) -> Bool[np.ndarray, " parts"]:
        """Which parts have a pose that explains points of this frame."""
        return self.explained_points > 0

    @property
    def centroid(self) -> Float64[np.ndarray, "parts 3"]:
        """Mean of each part's points."""
        return np.stack([part.centroid for part in self.parts])


def shape_jump(size: Float[np.ndarray, "3"], expected: Float[np.ndarray, "3"]) -> float:
    """Largest absolute logarithm of the ratio of two boxes' sides."""
    return float(np.abs(np.log(np.maximum(size, SMALLEST_SIDE_M) / np.maximum(expected, SMALLEST_SIDE_M))).max())


SMALLEST_SIDE_M = 1e-4
COUNTED = 0.95
"""Share of a part's points whose distances count towards the residual."""
COUNTED_SQUARE = 0.877
"""Mean square of these, of a normal distribution in space, over that of all: P(χ²₅ < q) / P(χ²₃ < q) at q of 95 %."""
BOX_MARGIN = 0.1
"""Share of a box's sides that noise may carry its points beyond it."""


def thickness(points: Float[np.ndarray, "points 3"]) -> float:
    """Standard deviation of points along the direction in which they spread least, in their own unit."""
    covariance = Moments.of(points, points).products / max(len(points) - 1, 1)
    return float(np.sqrt(max(0.0, float(np.linalg.eigvalsh(covariance)[0]))))


def agreement(
    fitted: Float[np.ndarray, "points 3"], points: Float[np.ndarray, "points 3"], tolerance: float
) -> tuple[float, Bool[np.ndarray, " points"]]:
    """RMS distance between corresponding points, in their unit, and which of them are nearer than `tolerance`.

    The worst twentieth, which strays may be, does not count towards the first: it is what the others would lead to if
    distances were those of a normal distribution.
    """
    squares, near = _agreement(doubles(fitted), doubles(points), tolerance * tolerance)
    counted = int(np.ceil(COUNTED * len(squares)))
    if counted == len(squares):
        return float(np.sqrt(squares.mean())), near
    smallest = np.partition(squares, counted - 1)[:counted]
    return float(np.sqrt(smallest.mean() / COUNTED_SQUARE)), near


def share_outside(points_part: Float[np.ndarray, "points 3"], size: Float[np.ndarray, "3"]) -> float:
    """Share of points in a part's own frame that lie outside its box, by more than a tenth of its sides."""
    inside = _inside(doubles(points_part), np.zeros(3), np.eye(3), doubles((0.5 + BOX_MARGIN) * size))
    return 1 - np.count_nonzero(inside) / len(points_part)


def inside_box(points: Float[np.ndarray, "points 3"], part: Pose) -> Bool[np.ndarray, " points"]:
    """Which points lie in the box of a pose of one part."""
    centre, rotation, half = part.translation[0], part.rotation[0], part.size[0] / 2
    return np.asarray(_inside(doubles(points), doubles(centre), doubles(rotation), doubles(half)))


def warm_up() -> None:
    """Compile or load the kernels."""
    points = np.zeros((2, 3))
    thickness(points)
    agreement(points, points, 1.0)
    share_outside(points, np.ones(3))


@compiled
def _agreement(
    fitted: Float64[np.ndarray, "points 3"], points: Float64[np.ndarray, "points 3"], squared_tolerance: float
) -> tuple[Float64[np.ndarray, " points"], Bool[np.ndarray, " points"]]:
    squares, near = np.empty(len(points)), np.empty(len(points), np.bool_)
    for i in range(len(points)):
        square = 0.0
        for axis in range(3):
            difference = fitted[i, axis] - points[i, axis]
            square += difference * difference
        squares[i] = square
        near[i] = square < squared_tolerance
    return squares, near


@compiled
def _inside(
    points: Float64[np.ndarray, "points 3"],
    centre: Float64[np.ndarray, "3"],
    rotation: Float64[np.ndarray, "3 3"],
    half: Float64[np.ndarray, "3"],
) -> Bool[np.ndarray, " points"]:
    inside = np.empty(len(points), np.bool_)
    for i in range(len(points)):
        x, y, z = points[i, 0] - centre[0], points[i, 1] - centre[1], points[i, 2] - centre[2]
        within = True
        for axis in range(3):
            own = x * rotation[0, axis] + y * rotation[1, axis] + z * rotation[2, axis]
            within &= abs(own) <= half[axis]
        inside[i] = within
    return inside

"""Parts whose joint is hardly seen go with what they hang on: a drawer that nothing is seen of moves with its cabinet.

A pose that a handful of points tell is mostly noise, and a pose that is kept while the object moves on is wrong; that
a joint stands as it last stood is the better guess. So it is of the turn of a laptop's base that is seen from its front
edge: points along a line that is parallel to the hinge tell where that line is, but the base can be turned about it in
any way.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float64, Int

from captra.categories import Category, Joint
from captra.evidence import Evidence, Ride
from captra.geometry import Pose, project_to_rotation, rotation_from_vector, rotation_vector

FEW_POINTS = 30
"""Of a part: found from so many, its joint is half way between where it stood and where it was found."""

SPREAD_ENOUGH = 0.15
"""Distance from their middle and across the joint's axis, in units of the scale, at which points tell the turn about it
in full: that of points all over a board."""


@dataclass(frozen=True)
class Standstill:
    """For how long nothing has told how hinges stand, since the track began or was taken up again.

    Slides are left out: drawers that are not seen mostly rest.
    """

    frames: Float64[np.ndarray, " joints"]
    """Of every joint; a frame that tells half of its turn halves them."""

    @staticmethod
    def of(category: Category) -> "Standstill":
        """All hinges were just told."""
        return Standstill(np.zeros(len(category.joints)))

    def judged(self, rides: Iterable[Ride], category: Category) -> tuple[Ride, ...]:
        """Rides with how long each has lasted."""
        return tuple(
            replace(ride, stood=float((1 - ride.turned) * (self.frames[ride.joint] + 1)))
            if category.joints[ride.joint].kind == "revolute"
            else ride
            for ride in rides
        )

    def updated(self, evidence: Evidence, *, trusted: bool) -> "Standstill":
        """After one more frame, which tells nothing unless it can be trusted."""
        frames = self.frames.copy()
        for ride in evidence.rides:
            frames[ride.joint] = ride.stood if trusted else max(ride.stood, frames[ride.joint])
        return Standstill(frames)

    def missed(self) -> "Standstill":
        """After a frame in which nothing was seen."""
        return Standstill(self.frames + 1)


def rides(pose: Pose, evidence: Evidence, category: Category) -> Iterator[Ride]:
    """Which parts of a pose as found go with which, a part after the one that it goes with; one ride a joint.

    The less tells how a joint stands, the more the part that is seen worse goes with the other: a child with its
    parent, or the root with the child that is seen best.
    """
    if not category.joints:
        return
    children = [_told(pose, evidence, joint, joint.child) for joint in category.joints]
    best = int(np.argmax(children))
    leading = category.joints[best]
    root = _told(pose, evidence, leading, leading.parent)
    root_rides = leading.parent == category.root and root < children[best]
    if root_rides:
        yield _ride(evidence, best, leading.parent, leading.child, root)
    for index, (joint, told) in enumerate(zip(category.joints, children, strict=True)):
        if not (root_rides and index == best):
            yield _ride(evidence, index, joint.child, joint.parent, told)


def _ride(evidence: Evidence, joint: int, part: int, by: int, told: float) -> Ride:
    return Ride(part, by, joint, _share(told), _share(len(evidence.parts[part].explained)))


def _told(pose: Pose, evidence: Evidence, joint: Joint, part: int) -> float:
    """How many points tell how a part stands on a joint, as if they were spread as far from its axis as is enough."""
    points = evidence.parts[part].explained
    if joint.kind == "prismatic" or len(points) == 0:
        return float(len(points))
    axis = pose.rotation[part] @ np.array(joint.axis)
    own = points - points.mean(axis=0)
    away = own - np.outer(own @ axis, axis)
    squared_spread = np.square(away).sum(axis=1).mean() / pose.scale[part] ** 2
    return float(len(points) * min(1.0, squared_spread / SPREAD_ENOUGH**2))


def carried(pose: Pose, last: Pose, seen: Int[np.ndarray, " parts"]) -> Pose:
    """The pose with every part of which no point is seen moved from where it last was as the one most is seen of."""
    leader, hidden = int(np.argmax(seen)), (seen == 0)[:, None]
    rotation, centre = _taken_along(pose.rotation[leader], pose.translation[leader], last, leader)
    return replace(
        pose,
        rotation=np.where(hidden[..., None], project_to_rotation(rotation), pose.rotation),
        translation=np.where(hidden, centre, pose.translation),
    )


def _taken_along(
    rotation: Float64[np.ndarray, "3 3"], centre: Float64[np.ndarray, "3"], last: Pose, by: int
) -> tuple[Float64[np.ndarray, "parts 3 3"], Float64[np.ndarray, "parts 3"]]:
    """Where all parts are, as they last stood, once one of them is turned and placed like that."""
    moved = rotation @ last.rotation[by].T
    return moved @ last.rotation, centre + (last.translation - last.translation[by]) @ moved.T


def _share(told: float) -> float:
    return told / (told + FEW_POINTS)


def ride_along(pose: Pose, evidence: Evidence, last: Pose, category: Category) -> Pose:
    """The pose with every part that rides the nearer to where another takes it, the less of it was found.

    What is seen of a part stays where it is seen while the part is turned.
    """
    rotation, translation = np.array(pose.rotation), np.array(pose.translation)
    for ride in evidence.rides:
        part, by = ride.part, ride.by
        expected, expected_centre = (of_all[part] for of_all in _taken_along(rotation[by], translation[by], last, by))
        turn: Float64[np.ndarray, "3"] = rotation_vector(expected.T @ rotation[part])
        axis = np.array(category.joints[ride.joint].axis)
        about = (turn @ axis) * axis
        # Projected, since products of rounded rotations, each made from the one before, drift off ever faster.
        turned = project_to_rotation(expected @ rotation_from_vector(ride.turned * about + ride.seen * (turn - about)))
        points = evidence.parts[part].explained
        middle = points.mean(axis=0) if len(points) else translation[part]
        centre = middle + turned @ rotation[part].T @ (translation[part] - middle)
        rotation[part] = turned
        translation[part] = expected_centre + ride.seen * (centre - expected_centre)
    return replace(pose, rotation=rotation, translation=translation)

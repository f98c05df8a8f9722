"""Parts whose joint is hardly seen go with what they hang on: a drawer that nothing is seen of moves with its cabinet.

A pose that a handful of points tell is mostly noise, and a pose that is kept while the object moves on is wrong; that
a joint stands as it last stood is the better guess. So it is of a laptop's base that is seen from its front edge:
however many points there are, they lie along the hinge, and the base could be turned about it in any way.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float64

from captra.categories import Category, Joint
from captra.evidence import Evidence, Ride
from captra.geometry import Pose, project_to_rotation, rotation_from_vector, rotation_vector

FEW_POINTS = 30
"""Of a part: found from so many, its joint is half way between where it stood and where it was found."""

SPREAD_ENOUGH = 0.2
"""Distance from their middle and across the joint's axis, in units of the scale, at which points count as one each."""


@dataclass(frozen=True)
class Standstill:
    """For how long nothing has told how parts stand on their hinges; a drawer that is not seen to move rarely does."""

    frames: Float64[np.ndarray, " parts"]
    """Of every part; a frame that tells half of its pose halves them."""

    @staticmethod
    def of(num_parts: int) -> "Standstill":
        """All hinges were just told."""
        return Standstill(np.zeros(num_parts))

    def judged(self, rides: Iterable[Ride], category: Category) -> tuple[Ride, ...]:
        """Rides with how long each has lasted."""
        hinged = {part for joint in category.joints if joint.kind == "revolute" for part in (joint.parent, joint.child)}
        return tuple(replace(ride, stood=self._stood(ride)) if ride.part in hinged else ride for ride in rides)

    def _stood(self, ride: Ride) -> float:
        return float((1 - ride.found) * (self.frames[ride.part] + 1))

    def updated(self, evidence: Evidence) -> "Standstill":
        """After one more frame; parts that did not ride in it were told."""
        frames = np.zeros(len(self.frames))
        for ride in evidence.rides:
            frames[ride.part] = ride.stood
        return Standstill(frames)


def rides(pose: Pose, evidence: Evidence, category: Category) -> Iterator[Ride]:
    """Which parts of a pose as found go with which, a part after the one that it goes with.

    The less tells how a joint stands, the more the part that is seen worse goes with the other: a child with its
    parent, or the root with the child that is seen best.
    """
    children = [_told(pose, evidence, joint, joint.child) for joint in category.joints]
    leading = None
    if category.joints:
        best = int(np.argmax(children))
        joint = category.joints[best]
        told = _told(pose, evidence, joint, joint.parent)
        if joint.parent == category.root and told < children[best]:
            leading = joint
            yield Ride(joint.parent, joint.child, _share(told))
    for joint, told in zip(category.joints, children, strict=True):
        if joint is not leading:
            yield Ride(joint.child, joint.parent, _share(told))


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


def _share(told: float) -> float:
    return told / (told + FEW_POINTS)


def ride_along(pose: Pose, evidence: Evidence, last: Pose) -> Pose:
    """The pose with every part that rides the nearer to where another takes it, the less of it was found."""
    rotation, translation = np.array(pose.rotation), np.array(pose.translation)
    for ride in evidence.rides:
        part, by = ride.part, ride.by
        moved = rotation[by] @ last.rotation[by].T
        expected = moved @ last.rotation[part]
        expected_centre = translation[by] + moved @ (last.translation[part] - last.translation[by])
        turn: Float64[np.ndarray, "3"] = rotation_vector(expected.T @ rotation[part])
        # Projected, since products of rounded rotations, each made from the one before, drift off ever faster.
        rotation[part] = project_to_rotation(expected @ rotation_from_vector(ride.found * turn))
        translation[part] = expected_centre + ride.found * (translation[part] - expected_centre)
    return replace(pose, rotation=rotation, translation=translation)

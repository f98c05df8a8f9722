"""What the given pose tells that networks cannot see.

How far a cabinet reaches behind its front is not seen, nor how much the temples of folded glasses splay; networks are
off there, and in the same way frame after frame. Whoever gave the first pose knew, within an error of their own: a part
of the difference is worth remembering.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Bool, Float64

from captra.categories import Category
from captra.evidence import Evidence
from captra.geometry import Pose, rotation_from_vector, rotation_vector

CAUTION = 1.2
"""How much worse than in the protocol a given pose is taken to be: what people give is not all of one kind."""

FEW_POINTS = 40
"""Of a part: found from so many, its centre's error has twice the usual variance."""

PerAxis = tuple[tuple[float, float, float], ...]
"""A number for x, y and z of every part; a single row is that of all parts."""

PerPart = tuple[tuple[float], ...]
"""A number for every part; a single row is that of all parts."""


@dataclass(frozen=True)
class FoundError:
    """By how much networks err on one object however often they look: standard deviations, along or about each axis.

    They differ widely: of a drawer only the front tells the depth, while its height is plain to see.
    """

    centre: PerAxis = ((0.02, 0.02, 0.02),)
    """In units of the part's scale."""
    rotation_deg: PerAxis = ((1.5, 1.5, 1.5),)
    """Degrees."""
    scale: PerPart = ((0.03,),)
    """Of its logarithm."""
    side: PerAxis = ((0.04, 0.04, 0.04),)
    """Of the lengths of the box's sides, in units of the scale: sides that are not seen are guessed."""

    @staticmethod
    def measured(calibration: Mapping[str, Any]) -> "FoundError":
        """What a manifest's `found_error` describes; the usual one where it was never measured."""
        return FoundError(**{name: tuple(tuple(row) for row in rows) for name, rows in calibration.items()})

    def seen_by(self, evidence: Evidence) -> "FoundError":
        """The error of centres found from as many points as there are: of few, most may be another part's."""
        points = evidence.explained_points
        if len(points) == 1:
            return self
        more = np.sqrt(1 + FEW_POINTS / np.maximum(points, 1))[:, None]
        centre = more * np.broadcast_to(self.centre, (len(points), 3))
        return replace(self, centre=tuple(map(tuple, centre.tolist())))

    @property
    def calibration(self) -> dict[str, Any]:
        """What a manifest keeps: the inverse of `measured`."""
        return asdict(self)


NO_ERROR = FoundError(((0.0, 0.0, 0.0),), ((0.0, 0.0, 0.0),))
"""Of networks that are taken at their word."""

USUAL_ERROR = FoundError()
"""Of networks that were not measured: chosen on validation sequences of several categories."""


@dataclass(frozen=True)
class PoseMemory:
    """Where parts are, as against where they are found."""

    offset_part: Float64[np.ndarray, "parts 3"]
    """From the centre as found to the true one, metres, in each part's own frame as found."""
    turn_part: Float64[np.ndarray, "parts 3"]
    """From the rotation as found to the true one: rotation vectors, radians, likewise."""

    @staticmethod
    def nothing_known(num_parts: int) -> "PoseMemory":
        """Parts are where they are found."""
        return PoseMemory(np.zeros((num_parts, 3)), np.zeros((num_parts, 3)))

    @staticmethod
    def between(given: Pose, found: Pose, category: Category, error: FoundError = USUAL_ERROR) -> "PoseMemory":
        """From a given pose and where the networks find the object at the same time.

        Both count by the inverse of their variance: that of given poses is the one that the category's networks were
        trained for (paper, Sec. "Implementation details").
        """
        to_part = np.swapaxes(found.rotation, -1, -2)
        offset = (to_part @ (given.translation - found.translation)[..., None])[..., 0]
        turn = rotation_vector(to_part @ given.rotation)
        usual = category.perturbation
        centre_error, rotation_error = np.array(error.centre) * given.scale[:, None], np.radians(error.rotation_deg)
        offset_share = _share(offset, centre_error, CAUTION * usual.translation_m)
        turn_share = _share(turn, rotation_error, given_rotation_error_rad(category))
        return PoseMemory(offset_share * offset, turn_share * turn)

    def apply(self, found: Pose, fitted: Bool[np.ndarray, " parts"]) -> Pose:
        """The pose with its parts where they are believed to be; those that were not fitted stay."""
        offset = (found.rotation @ self.offset_part[..., None])[..., 0]
        turned = found.rotation @ rotation_from_vector(self.turn_part)
        return replace(
            found,
            rotation=np.where(fitted[:, None, None], turned, found.rotation),
            translation=np.where(fitted[:, None], found.translation + offset, found.translation),
        )


def given_rotation_error_rad(category: Category) -> float:
    """Standard deviation of the angle by which a given pose is taken to be off."""
    return float(CAUTION * np.radians(category.perturbation.rotation_deg))


def _share(
    difference: Float64[np.ndarray, "parts 3"], found_error: Float64[np.ndarray, "#parts 3"], given_error: float
) -> Float64[np.ndarray, "parts 3"]:
    """How much of a difference to put down to the networks; one that is too large for both is the given pose's fault.

    Args:
        difference: along or about each axis.
        found_error: standard deviation of what networks find, along or about each axis.
        given_error: standard deviation of the length of the error of a given pose.
    """
    found_variance, usual_variance = np.square(found_error), given_error**2 / 3
    expected = (found_variance + usual_variance).sum(axis=1, keepdims=True)
    given_variance = usual_variance * (1 + np.square(difference).sum(axis=1, keepdims=True) / (4 * expected))
    return np.asarray(found_variance / (found_variance + given_variance))

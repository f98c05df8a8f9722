"""Whose word counts for a part's rotation: RotationNet's alone, or also that of the fit to the coordinates."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Protocol

import numpy as np
from jaxtyping import Float64

from captra.fitting import angle_about_axis, mean_rotation
from captra.geometry import axis_angle


class RotationFusion(Protocol):
    """Chooses one rotation from two."""

    def __call__(
        self, from_rotation_net: Float64[np.ndarray, "3 3"], from_coordinates: Float64[np.ndarray, "3 3"]
    ) -> Float64[np.ndarray, "3 3"]:
        """The rotation R_camera_part to go on with, from RotationNet's and from that of the full Umeyama fit."""


class RotationNetAlone:
    """As the paper has it."""

    def __call__(
        self,
        from_rotation_net: Float64[np.ndarray, "3 3"],
        from_coordinates: Float64[np.ndarray, "3 3"],  # noqa: ARG002 - asked for by the protocol
    ) -> Float64[np.ndarray, "3 3"]:
        """RotationNet's."""
        return from_rotation_net


class CoordinatesAlone:
    """The rotation of the full Umeyama fit: the paper's CoordinateNet baseline on canonical clouds."""

    def __call__(
        self,
        from_rotation_net: Float64[np.ndarray, "3 3"],  # noqa: ARG002 - asked for by the protocol
        from_coordinates: Float64[np.ndarray, "3 3"],
    ) -> Float64[np.ndarray, "3 3"]:
        """The fit's."""
        return from_coordinates


class HalfWay:
    """Both count the same: their errors have different causes and partly cancel."""

    def __call__(
        self, from_rotation_net: Float64[np.ndarray, "3 3"], from_coordinates: Float64[np.ndarray, "3 3"]
    ) -> Float64[np.ndarray, "3 3"]:
        """The Euclidean mean of the two."""
        return mean_rotation(np.stack([from_rotation_net, from_coordinates]))


@dataclass(frozen=True)
class TurnFromCoordinates:
    """RotationNet's tilt, but the turn about one object axis from the coordinates, or from both.

    The turn of an upright object that one small feature tells, a mug's handle, is what a regression over all points
    learns last, while each point on the feature speaks for it in the coordinates.
    """

    axis: tuple[float, float, float]
    """Unit axis in the part's frame."""
    share: float = 1.0
    """How far to turn to where the coordinates are: half way where RotationNet knows the turn as well."""

    def __call__(
        self, from_rotation_net: Float64[np.ndarray, "3 3"], from_coordinates: Float64[np.ndarray, "3 3"]
    ) -> Float64[np.ndarray, "3 3"]:
        """RotationNet's, turned about its own axis towards where the coordinates are closest."""
        axis = np.array(self.axis)
        difference = angle_about_axis(from_rotation_net.T @ from_coordinates, axis)
        return np.asarray(from_rotation_net @ axis_angle(axis, self.share * difference))


ROTATION_NET_ALONE: RotationFusion = RotationNetAlone()

ROTATION_FUSIONS: Mapping[str, RotationFusion] = MappingProxyType(
    {
        "rotation-net": ROTATION_NET_ALONE,
        "turn-about-y-from-coordinates": TurnFromCoordinates((0.0, 1.0, 0.0)),
        "turn-about-y-half-way": TurnFromCoordinates((0.0, 1.0, 0.0), share=0.5),
        "coordinates": CoordinatesAlone(),
        "mean": HalfWay(),
    }
)
"""By the names that manifests use."""

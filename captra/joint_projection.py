"""Keeps the rotations of jointed parts on their joints (the paper's Rot. Proj.)."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Protocol

import numpy as np
from jaxtyping import Float, Float64, Int

from captra.categories import Category
from captra.fitting import mean_rotation, rotation_about_axis


class JointProjection(Protocol):
    """Changes rotations that no joint allows."""

    def __call__(
        self, rotation: Float64[np.ndarray, "parts 3 3"], seen: Int[np.ndarray, " parts"], category: Category
    ) -> Float64[np.ndarray, "parts 3 3"]:
        """R_camera_part of every part, as the joints allow it, given how many points are seen of each."""


class Unprojected:
    """Every part turns as it likes."""

    def __call__(
        self,
        rotation: Float64[np.ndarray, "parts 3 3"],
        seen: Int[np.ndarray, " parts"],  # noqa: ARG002 - asked for by the protocol
        category: Category,  # noqa: ARG002 - asked for by the protocol
    ) -> Float64[np.ndarray, "parts 3 3"]:
        """What came in."""
        return rotation


UNPROJECTED: JointProjection = Unprojected()


@dataclass(frozen=True)
class OntoAxes:
    """Moving parts turn about their joint's axis only; those on slides do not turn at all."""

    axes: Mapping[str, tuple[float, float, float]] = field(default_factory=dict)
    """Joint name → its axis in the parent's frame; the category's own axis where a joint is not named."""

    def __call__(
        self,
        rotation: Float64[np.ndarray, "parts 3 3"],
        seen: Int[np.ndarray, " parts"],  # noqa: ARG002 - asked for by the protocol
        category: Category,
    ) -> Float64[np.ndarray, "parts 3 3"]:
        """Each child's rotation, replaced by the nearest one that its joint allows; parents come first."""
        projected = np.array(rotation, np.float64)
        for joint in category.joints:
            parent = projected[joint.parent]
            axis: Float[np.ndarray, "3"] = np.array(self.axes.get(joint.name, joint.axis))
            relative = parent.T @ projected[joint.child]
            turn = rotation_about_axis(relative, axis) if joint.kind == "revolute" else np.eye(3)
            projected[joint.child] = parent @ turn
        return projected


@dataclass(frozen=True)
class Pooled:
    """All parts have a say in the root's rotation, each by way of its joint; then parts turn about their axes only.

    Meant for parts whose errors have causes of their own, however many points are seen of them.
    """

    rounds: int = 3
    """How often the turns of the joints and the root's rotation are found from each other."""

    def __call__(
        self, rotation: Float64[np.ndarray, "parts 3 3"], seen: Int[np.ndarray, " parts"], category: Category
    ) -> Float64[np.ndarray, "parts 3 3"]:
        """The joints' turns with the root's rotation that has most votes; every joint hangs on the root."""
        found = ALONG_AXES(rotation, seen, category)
        weights = self._votes(seen)[[category.root, *(joint.child for joint in category.joints)]]
        for _ in range(self.rounds):
            votes = [rotation[category.root]]
            for joint in category.joints:
                turn = found[joint.parent].T @ found[joint.child]
                votes.append(rotation[joint.child] @ turn.T)
            pooled = np.array(rotation, np.float64)
            pooled[category.root] = mean_rotation(np.stack(votes), weights)
            found = ALONG_AXES(pooled, seen, category)
        return found

    def _votes(self, seen: Int[np.ndarray, " parts"]) -> Int[np.ndarray, " parts"]:
        return np.ones_like(seen)


class PooledByPoints(Pooled):
    """Every point has a say instead: a part of which little is seen does not turn away one that is plain to see."""

    def _votes(self, seen: Int[np.ndarray, " parts"]) -> Int[np.ndarray, " parts"]:
        return np.asarray(np.maximum(seen, 1))


ALONG_AXES: JointProjection = OntoAxes()

JOINT_PROJECTIONS: Mapping[str, JointProjection] = MappingProxyType(
    {"free": UNPROJECTED, "along-axes": ALONG_AXES, "pooled": Pooled(), "pooled-by-points": PooledByPoints()}
)
"""By the names that manifests use."""

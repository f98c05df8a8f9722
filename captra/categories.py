"""The ten categories: parts, kinematic tree, symmetry and training perturbation (paper, Table "Statistics")."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from captra.errors import UserError

JointKind = Literal["revolute", "prismatic"]

MINUS_X_AXIS = (-1.0, 0.0, 0.0)
MINUS_Y_AXIS = (0.0, -1.0, 0.0)
Y_AXIS = (0.0, 1.0, 0.0)
Z_AXIS = (0.0, 0.0, 1.0)


class UnknownCategoryError(UserError, ValueError):
    """The name belongs to none of the categories."""


@dataclass(frozen=True)
class Joint:
    """One degree of freedom between two parts."""

    name: str
    """What the joint does, e.g. `hinge`."""
    kind: JointKind
    """Revolute joints report radians, prismatic ones metres; both are zero at rest."""
    child: int
    """Index of the moving part."""
    parent: int
    """Index of the part it moves against."""
    axis: tuple[float, float, float]
    """Unit axis in the object frame at rest, such that opening, folding and pulling out are positive."""


@dataclass(frozen=True)
class Perturbation:
    """Standard deviations of the pose noise around the truth, in training and for the first pose."""

    scale: float
    """Relative: scale is multiplied by 1 + N(0, scale)."""
    rotation_deg: float
    """Angle about a random axis."""
    translation_m: float
    """Length along a random direction."""


@dataclass(frozen=True)
class Category:
    """What is known of an object before it is seen."""

    name: str
    """As clients write it."""
    parts: tuple[str, ...]
    """Part names; their order is the order of every per-part array."""
    root: int
    """The part whose last pose canonicalizes CoordinateNet's input."""
    joints: tuple[Joint, ...]
    """Empty for rigid objects."""
    symmetric: bool
    """Whether the rotation about y carries no information."""
    background: bool
    """Whether clouds come with their surroundings (rigid) or already segmented (articulated)."""
    perturbation: Perturbation
    """Noise of the first pose and of training."""

    @property
    def num_parts(self) -> int:
        """P."""
        return len(self.parts)

    @property
    def slides(self) -> tuple[Joint, ...]:
        """The prismatic joints."""
        return tuple(joint for joint in self.joints if joint.kind == "prismatic")

    @property
    def num_classes(self) -> int:
        """Classes of the segmentation; with a background it is the last one."""
        return self.num_parts + int(self.background)


def _rigid(name: str, *, symmetric: bool) -> Category:
    return Category(
        name=name,
        parts=(name,),
        root=0,
        joints=(),
        symmetric=symmetric,
        background=True,
        perturbation=Perturbation(scale=0.02, rotation_deg=5.0, translation_m=0.03),
    )


def _articulated(
    name: str, parts: tuple[str, ...], root: int, joints: tuple[Joint, ...], perturbation: Perturbation
) -> Category:
    return Category(name, parts, root, joints, symmetric=False, background=False, perturbation=perturbation)


_ALL = (
    _rigid("bottle", symmetric=True),
    _rigid("bowl", symmetric=True),
    _rigid("camera", symmetric=False),
    _rigid("can", symmetric=True),
    _rigid("laptop", symmetric=False),
    _rigid("mug", symmetric=False),
    _articulated(
        "glasses",
        ("right_temple", "left_temple", "base"),
        root=2,
        joints=(
            Joint("right_hinge", "revolute", child=0, parent=2, axis=MINUS_Y_AXIS),
            Joint("left_hinge", "revolute", child=1, parent=2, axis=Y_AXIS),
        ),
        perturbation=Perturbation(scale=0.02, rotation_deg=5.0, translation_m=0.02),
    ),
    _articulated(
        "scissors",
        ("right_half", "left_half"),
        root=0,
        joints=(Joint("pivot", "revolute", child=1, parent=0, axis=Y_AXIS),),
        perturbation=Perturbation(scale=0.01, rotation_deg=3.0, translation_m=0.01),
    ),
    _articulated(
        "laptop_articulated",
        ("base", "display"),
        root=0,
        joints=(Joint("hinge", "revolute", child=1, parent=0, axis=MINUS_X_AXIS),),
        perturbation=Perturbation(scale=0.015, rotation_deg=3.0, translation_m=0.02),
    ),
    _articulated(
        "drawers",
        ("lowest", "middle", "top", "base"),
        root=3,
        joints=(
            Joint("lowest_slide", "prismatic", child=0, parent=3, axis=Z_AXIS),
            Joint("middle_slide", "prismatic", child=1, parent=3, axis=Z_AXIS),
            Joint("top_slide", "prismatic", child=2, parent=3, axis=Z_AXIS),
        ),
        perturbation=Perturbation(scale=0.02, rotation_deg=3.0, translation_m=0.02),
    ),
)

CATEGORIES: Mapping[str, Category] = MappingProxyType({category.name: category for category in _ALL})


def get_category(name: str) -> Category:
    """Return the category called `name`.

    Raises:
        UnknownCategoryError: with the names that exist.
    """
    try:
        return CATEGORIES[name]
    except KeyError:
        known = ", ".join(CATEGORIES)
        raise UnknownCategoryError(f"unknown category {name!r}: choose one of {known}") from None

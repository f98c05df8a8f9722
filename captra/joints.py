"""Joint states read off the parts' poses (METHOD, "Evaluation")."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.categories import Category, Joint, JointKind
from captra.fitting import angle_about_axis
from captra.geometry import Pose


@dataclass(frozen=True)
class JointValue:
    """State of one joint."""

    name: str
    """As in the category."""
    kind: JointKind
    """`revolute` or `prismatic`."""
    value: float
    """Radians about the joint's axis, or metres along it; see `joint_value`."""


def joint_value(joint: Joint, pose: Pose) -> float:
    """Rotation about the axis of the child against its parent, or the child's offset along it in the parent's frame.

    A prismatic value contains the constant offset between the two box centres at rest, which a pose alone cannot tell.
    """
    axis = np.array(joint.axis)
    if joint.kind == "revolute":
        return angle_about_axis(pose.rotation[joint.parent].T @ pose.rotation[joint.child], axis)
    return float(axis @ offset_from_parent(joint, pose))


def offset_from_parent(joint: Joint, pose: Pose) -> Float64[np.ndarray, "3"]:
    """From the parent's centre to the child's, metres, in the parent's frame."""
    offset = pose.translation[joint.child] - pose.translation[joint.parent]
    return np.asarray(offset @ pose.rotation[joint.parent])


def joint_values(pose: Pose, category: Category) -> tuple[JointValue, ...]:
    """All joints of an object, in the category's order."""
    return tuple(JointValue(joint.name, joint.kind, joint_value(joint, pose)) for joint in category.joints)

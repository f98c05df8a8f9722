"""Where the parts of a shape are once its joints have moved."""

import numpy as np
from jaxtyping import Float, Float64

from captra.categories import get_category
from captra.data.shapes.shape import Shape
from captra.geometry import axis_angle


def part_motions(
    shape: Shape, joint_values: Float[np.ndarray, " J"]
) -> tuple[Float64[np.ndarray, "P 3 3"], Float64[np.ndarray, "P 3"]]:
    """Rotation and translation that carry each part from rest to these joint values, in the object frame.

    Joints are applied in the category's order, so a parent's joint stands before its child's.
    """
    count = len(shape.parts)
    rotation, translation = np.tile(np.eye(3), (count, 1, 1)), np.zeros((count, 3))
    for joint, origin, value in zip(
        get_category(shape.category).joints, shape.joint_origins, joint_values, strict=True
    ):
        axis = np.asarray(joint.axis)
        if joint.kind == "revolute":
            turn = axis_angle(axis, float(value))
            shift = origin - turn @ origin
        else:
            turn, shift = np.eye(3), axis * float(value)
        rotation[joint.child] = rotation[joint.parent] @ turn
        translation[joint.child] = rotation[joint.parent] @ shift + translation[joint.parent]
    return rotation, translation

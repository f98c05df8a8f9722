import numpy as np
import pytest

from captra.categories import get_category
from captra.geometry import Pose, axis_angle
from captra.joints import joint_values


def test_hinge_angle_is_signed_and_independent_of_where_the_object_is() -> None:
    base = axis_angle(np.array([1.0, 2, 3]), 0.7)
    display = base @ axis_angle(np.array([1.0, 0, 0]), -0.9)
    pose = Pose.from_size(np.stack([base, display]), np.ones((2, 3)), np.ones((2, 3)))
    (hinge,) = joint_values(pose, get_category("laptop_articulated"))
    assert (hinge.name, hinge.kind) == ("hinge", "revolute")
    assert hinge.value == pytest.approx(-0.9)


def test_slide_is_the_offset_along_z_of_the_base() -> None:
    rotation = axis_angle(np.array([0.0, 1, 0]), 0.4)
    offsets = np.array([[0, -0.1, 0.05], [0, 0, 0.1], [0, 0.1, 0.2], [0, 0, 0]])
    pose = Pose.from_size(np.stack([rotation] * 4), offsets @ rotation.T + 1, np.ones((4, 3)))
    values = joint_values(pose, get_category("drawers"))
    assert [value.kind for value in values] == ["prismatic"] * 3
    np.testing.assert_allclose([value.value for value in values], [0.05, 0.1, 0.2])


def test_rigid_objects_have_no_joints() -> None:
    pose = Pose.from_size(np.eye(3)[None], np.zeros((1, 3)), np.ones((1, 3)))
    assert joint_values(pose, get_category("mug")) == ()

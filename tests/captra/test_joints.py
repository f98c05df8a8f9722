from pathlib import Path

import numpy as np
import pytest

from captra.categories import get_category
from captra.data.recordings import load_recording
from captra.data.shapes import make_shape
from captra.data.shapes.kinematics import part_motions
from captra.geometry import Pose, axis_angle
from captra.joints import joint_values


def test_hinge_angle_is_signed_and_independent_of_where_the_object_is() -> None:
    base = axis_angle(np.array([1.0, 2, 3]), 0.7)
    display = base @ axis_angle(np.array([1.0, 0, 0]), -0.9)
    pose = Pose.from_size(np.stack([base, display]), np.ones((2, 3)), np.ones((2, 3)))
    (hinge,) = joint_values(pose, get_category("laptop_articulated"))
    assert (hinge.name, hinge.kind) == ("hinge", "revolute")
    assert hinge.value == pytest.approx(0.9)


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


RECORDINGS = sorted((Path(__file__).parents[2] / "recordings").glob("*.npz"))
ARTICULATED = [path for path in RECORDINGS if get_category(path.name.split("__")[0]).joints]


@pytest.mark.parametrize("path", ARTICULATED, ids=lambda path: path.stem)
def test_values_are_those_of_the_recordings_but_for_the_offset_of_drawers(path: Path) -> None:
    recording = load_recording(path)
    found = np.array(
        [[joint.value for joint in joint_values(recording.truth(f), recording.category)] for f in range(len(recording))]
    )
    difference = found - recording.joint_values
    for joint, apart in zip(recording.category.joints, difference.T, strict=True):
        np.testing.assert_allclose(apart, apart[0], atol=1e-4)
        if joint.kind == "revolute":
            np.testing.assert_allclose(apart, 0, atol=1e-4)


@pytest.mark.parametrize("name", ["glasses", "scissors", "laptop_articulated", "drawers"])
def test_simulated_joints_count_like_recorded_ones(name: str) -> None:
    """Zero at rest; opening, folding and pulling out are positive."""
    shape = make_shape(name, np.random.default_rng(2))
    assert (shape.joint_limits >= 0).all()
    rotation, translation = part_motions(shape, shape.joint_limits[:, 1])
    centers = np.einsum("pij,pj->pi", rotation, shape.centers) + translation
    pose = Pose.from_size(rotation, centers, shape.sizes)
    rest = Pose.from_size(np.tile(np.eye(3), (len(rotation), 1, 1)), shape.centers, shape.sizes)
    values, at_rest = (np.array([j.value for j in joint_values(p, get_category(name))]) for p in (pose, rest))
    np.testing.assert_allclose(values - at_rest, shape.joint_limits[:, 1], atol=1e-5)

"""Views and sequences of articulated objects."""

import numpy as np
import pytest

from captra.categories import get_category
from captra.data.recordings import Recording
from captra.data.sequences import Motion, make_sequence
from captra.data.shapes import make_shape
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.shape import Shape
from captra.data.view import View
from captra.data.views import ViewOptions, farthest_distance, make_view
from captra.joints import joint_value

CATEGORIES = ["drawers", "glasses", "laptop_articulated", "scissors"]


def draw_view(category: str, seed: int, stray_share: float = 0.05) -> tuple[Shape, View]:
    rng = np.random.default_rng([31, seed])
    shape = make_shape(category, rng)
    return shape, make_view(shape, rng, ViewOptions(stray_share=stray_share))


def outside(view: View, part: int) -> np.ndarray:
    own = (view.points[view.labels == part] - view.translation[part]) @ view.rotation[part]
    return np.asarray(np.linalg.norm(np.maximum(np.abs(own) - view.size[part] / 2, 0), axis=1))


@pytest.mark.parametrize("category", CATEGORIES)
@pytest.mark.parametrize("seed", range(4))
def test_labels_pose_and_joints_agree(category: str, seed: int) -> None:
    shape, view = draw_view(category, seed)
    kinematics = get_category(category)
    parts = kinematics.num_parts
    assert (view.labels < parts).sum() >= 60
    assert (view.labels == parts).mean() <= 0.05
    for part in range(parts):
        if (view.labels == part).sum() > 20:
            assert np.quantile(outside(view, part), 0.8) < 0.015
    rotation, translation = part_motions(shape, view.joint_values)
    root = kinematics.root
    centers = np.einsum("pij,pj->pi", rotation, shape.centers) + translation
    relative = (view.translation - view.translation[root]) @ view.rotation[root]
    np.testing.assert_allclose(relative, centers - centers[root], atol=1e-5)
    for index, joint in enumerate(kinematics.joints):
        measured = joint_value(joint, view.pose)
        if joint.kind == "revolute":
            assert measured == pytest.approx(view.joint_values[index], abs=1e-4)
        else:
            at_rest = shape.centers[joint.child, 2] - shape.centers[joint.parent, 2]
            assert measured - at_rest == pytest.approx(view.joint_values[index], abs=1e-4)


@pytest.mark.parametrize("category", CATEGORIES)
def test_clouds_are_pre_segmented_and_depend_on_their_seed_only(category: str) -> None:
    (_, first), (_, again) = (draw_view(category, 5, stray_share=0.0) for _ in range(2))
    np.testing.assert_array_equal(first.points, again.points)
    np.testing.assert_array_equal(first.labels, again.labels)
    assert first.labels.max() < get_category(category).num_parts


def test_the_largest_cabinets_stay_within_what_shards_store() -> None:
    for seed in range(6):
        shape, view = draw_view("drawers", seed)
        assert np.abs(view.points).max() < 3.27
        assert view.translation[3, 2] < farthest_distance(shape) + shape.scale / 2


@pytest.mark.parametrize("category", CATEGORIES)
def test_sequences_move_the_joints_and_start_with_every_part_in_sight(category: str) -> None:
    motion: Motion = "hand" if category in {"glasses", "scissors"} else "table"
    recording: Recording = make_sequence(make_shape(category, np.random.default_rng(6)), 2, 4, motion)
    kinematics = get_category(category)
    counts = np.bincount(recording.labels[0], minlength=kinematics.num_parts)
    assert counts.min() >= 12
    assert len(counts) == kinematics.num_parts, "sequences have no strays"
    assert (np.abs(np.diff(recording.joint_values, axis=0)).max(0) > 0).all()
    for frame in range(4):
        truth = recording.truth(frame)
        for index, joint in enumerate(kinematics.joints):
            if joint.kind == "revolute":
                assert joint_value(joint, truth) == pytest.approx(recording.joint_values[frame, index], abs=1e-4)

"""Errors of tracked poses, frame by frame and in the mean; the first frame is given and not scored."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float64

from captra import metrics
from captra.data.recordings import Recording
from captra.evaluation.model_points import ModelPoints
from captra.evaluation.observability import symmetric_frames
from captra.geometry import Pose, rotation_angle


@dataclass(frozen=True)
class SequenceScore:
    """Errors of one sequence; frames start with the second one."""

    name: str
    """Of the recording."""
    category: str
    """Of the object."""
    rotation_deg: Float64[np.ndarray, "frames parts"]
    """Rotation error; of the y axis where the frame is scored as symmetric."""
    translation_cm: Float64[np.ndarray, "frames parts"]
    """Distance of the box centres."""
    iou: Float64[np.ndarray, "frames parts"]
    """Of the oriented boxes."""
    iou_nocs: Float64[np.ndarray, "frames parts"]
    """Of their axis-aligned bounds, as the NOCS benchmark does."""
    scale_percent: Float64[np.ndarray, "frames parts"]
    """Relative error of the scale."""
    joint_error: Float64[np.ndarray, "frames joints"]
    """Degrees (revolute) or centimetres (prismatic)."""
    symmetric: Bool[np.ndarray, " frames"]
    """Frames scored as symmetric."""
    within_ad10: Bool[np.ndarray, "frames known_parts"]
    """AD-10 %; no column where the true surface is unknown."""

    @property
    def within_5deg_5cm(self) -> Bool[np.ndarray, "frames parts"]:
        """5°5cm of each frame and part."""
        return metrics.within(self.rotation_deg, self.translation_cm)


def score(recording: Recording, poses: Sequence[Pose], model: ModelPoints = ()) -> SequenceScore:
    """Compare the poses of frames 1, 2, … with the truth.

    Args:
        recording: what was tracked.
        poses: one for each frame but the first.
        model: true surface of each part, for AD-10 %.

    Raises:
        ValueError: when there is not one pose for each frame but the first.
    """
    if len(poses) != len(recording) - 1:
        raise ValueError(
            f"{recording.name} has {len(recording)} frames: give {len(recording) - 1} poses, not {len(poses)}"
        )
    symmetric = symmetric_frames(recording)[1:]
    rows = [
        _frame(pose, recording, frame + 1, model, symmetric=bool(symmetric[frame])) for frame, pose in enumerate(poses)
    ]
    rotation, translation, iou, iou_nocs, scale, joints, ad10 = (np.array(column) for column in zip(*rows, strict=True))
    return SequenceScore(
        recording.name, recording.category.name, rotation, translation, iou, iou_nocs, scale, joints, symmetric, ad10
    )


def _frame(
    pose: Pose, recording: Recording, frame: int, model: ModelPoints, *, symmetric: bool
) -> tuple[np.ndarray, ...]:
    truth = recording.truth(frame)
    parts = [(pose.part(part), truth.part(part)) for part in range(pose.num_parts)]
    return (
        metrics.rotation_error_deg(pose.rotation, truth.rotation, symmetric=symmetric),
        metrics.translation_error_cm(pose.translation, truth.translation),
        np.array([metrics.iou_oriented(a, b, symmetric=symmetric) for a, b in parts]),
        np.array([metrics.iou_nocs(a, b, symmetric=symmetric) for a, b in parts]),
        metrics.scale_error_percent(pose, truth),
        joint_errors(pose, truth, recording),
        np.array(
            [
                metrics.average_distance_accuracy(points, estimate, true, symmetric=symmetric)
                for points, (estimate, true) in zip(model, parts, strict=False)
            ],
            bool,
        ),
    )


def joint_errors(pose: Pose, truth: Pose, recording: Recording) -> Float64[np.ndarray, " joints"]:
    """Revolute: degrees between true and estimated angle of child against parent. Prismatic: cm along the axis."""
    errors = []
    for joint in recording.category.joints:
        relative, true_relative = (p.rotation[joint.parent].T @ p.rotation[joint.child] for p in (pose, truth))
        if joint.kind == "revolute":
            errors.append(np.degrees(abs(rotation_angle(relative) - rotation_angle(true_relative))))
            continue
        offset, true_offset = (
            p.rotation[joint.parent].T @ (p.translation[joint.child] - p.translation[joint.parent])
            for p in (pose, truth)
        )
        errors.append(100 * abs(float(np.array(joint.axis) @ (offset - true_offset))))
    return np.array(errors, np.float64)

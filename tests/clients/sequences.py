"""Recordings made on the spot: a blob of points that drifts to the right, its truth at the middle."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from captra.categories import get_category
from captra.data.recordings import Recording, save_recording
from captra.geometry import Pose

FRAMES = 8
DRIFT_M = 0.01
SIZE = np.full((1, 3), 0.1)


def drifting_mug(frames: int = FRAMES) -> Recording:
    rng = np.random.default_rng(0)
    blob = rng.uniform(-0.04, 0.04, (400, 3))
    blob -= blob.mean(axis=0)
    translation = np.array([[[0.02 + DRIFT_M * frame, 0.0, 0.6]] for frame in range(frames)], np.float32)
    return Recording(
        category=get_category("mug"),
        name="mug__blob__drift",
        stamps_ns=np.arange(frames, dtype=np.int64) * 20_000_000,
        clouds=tuple((blob + centre).astype(np.float32) for centre in translation),
        labels=tuple(np.zeros(400, np.uint8) for _ in range(frames)),
        rotation=np.tile(np.eye(3, dtype=np.float32), (frames, 1, 1, 1)),
        translation=translation,
        size=SIZE.astype(np.float32),
        init=Pose.from_size(np.eye(3)[None], translation[0], SIZE),
        joint_values=np.zeros((frames, 0), np.float32),
    )


def without_a_cloud(recording: Recording, frame: int) -> Recording:
    """The same, but one cloud is far from the object."""
    clouds = list(recording.clouds)
    clouds[frame] = clouds[frame] + np.float32(2)
    return replace(recording, clouds=tuple(clouds))


def first_frames(recording: Recording, count: int) -> Recording:
    """The beginning of a recording."""
    return replace(
        recording,
        stamps_ns=recording.stamps_ns[:count],
        clouds=recording.clouds[:count],
        labels=recording.labels[:count],
        rotation=recording.rotation[:count],
        translation=recording.translation[:count],
        joint_values=recording.joint_values[:count],
    )


def saved(recording: Recording, folder: Path) -> Path:
    path = folder / f"{recording.name}.npz"
    save_recording(path, recording)
    return path

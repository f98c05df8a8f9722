"""Recorded sequences with ground truth, as files of compressed arrays."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from zipfile import is_zipfile

import numpy as np
from jaxtyping import Float32, Int64, UInt8

from captra.categories import Category, get_category
from captra.errors import UserError
from captra.geometry import Pose

UNIT_M = 1e-4
"""Points are stored as int16 multiples of it."""


class RecordingError(UserError, ValueError):
    """A file is not a recording."""


@dataclass(frozen=True)
class Recording:
    """F frames of one object of P parts, camera frame (x right, y down, z forward), metres."""

    category: Category
    """What the object is."""
    name: str
    """Of the object and its motion; the file's name without its ending."""
    stamps_ns: Int64[np.ndarray, " F"]
    """Capture times."""
    clouds: Sequence[Float32[np.ndarray, "N 3"]]
    """One cloud a frame."""
    labels: Sequence[UInt8[np.ndarray, " N"]]
    """True part of each point; P is background."""
    rotation: Float32[np.ndarray, "F P 3 3"]
    """True R_camera_part."""
    translation: Float32[np.ndarray, "F P 3"]
    """True centres of the parts' tight boxes."""
    size: Float32[np.ndarray, "P 3"]
    """True extents of the parts' boxes."""
    init: Pose
    """The first pose to give to a tracker: the truth of frame 0, perturbed."""
    joint_values: Float32[np.ndarray, "F J"]
    """True joint states, rad or m; zero at rest."""

    def __len__(self) -> int:
        return len(self.clouds)

    def truth(self, frame: int) -> Pose:
        """The true pose of all parts in a frame."""
        return Pose.from_size(self.rotation[frame], self.translation[frame], self.size)


_ARRAYS = ("points", "offsets", "labels", "stamp_ns", "rotation", "translation", "size")
_INIT = ("init_rotation", "init_translation", "init_size")


def load_recording(path: Path | str) -> Recording:
    """Read a recording.

    Raises:
        FileNotFoundError: if there is no such file.
        RecordingError: if it lacks an array; the message names it.
        UnknownCategoryError: if its category is none of the known ones.
    """
    path = Path(path)
    if path.exists() and not is_zipfile(path):
        raise RecordingError(f"{path} is no recording: it is not an .npz archive; record or download it again")
    with np.load(path, allow_pickle=False) as stored:
        missing = [name for name in (*_ARRAYS, *_INIT) if name not in stored.files]
        if missing:
            raise RecordingError(f"{path} is no recording: it lacks {', '.join(missing)}; record or download it again")
        arrays = {name: stored[name] for name in stored.files}
    category = str(arrays["category"]) if "category" in arrays else path.stem.split("__")[0]
    offsets, frames = arrays["offsets"], len(arrays["stamp_ns"])
    points = arrays["points"].astype(np.float32) * np.float32(UNIT_M)
    spans = [slice(int(start), int(stop)) for start, stop in pairwise(offsets)]
    return Recording(
        category=get_category(category),
        name=path.stem,
        stamps_ns=arrays["stamp_ns"].astype(np.int64),
        clouds=tuple(points[span] for span in spans),
        labels=tuple(arrays["labels"][span] for span in spans),
        rotation=arrays["rotation"].astype(np.float32),
        translation=arrays["translation"].astype(np.float32),
        size=arrays["size"].astype(np.float32),
        init=Pose.from_size(*(arrays[name].astype(np.float64) for name in _INIT)),
        joint_values=arrays.get("joint_values", np.zeros((frames, 0), np.float32)).astype(np.float32),
    )


def save_recording(path: Path | str, recording: Recording) -> None:
    """Write a recording; the file appears under its name only once it is complete. Points are rounded to 0.1 mm."""
    path = Path(path)
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    points = np.concatenate(recording.clouds) if len(recording) else np.zeros((0, 3), np.float32)
    with partial.open("wb") as file:
        np.savez_compressed(
            file,
            points=np.rint(points / UNIT_M).clip(-32768, 32767).astype(np.int16),
            offsets=np.cumsum([0, *(len(cloud) for cloud in recording.clouds)], dtype=np.int64),
            labels=np.concatenate(recording.labels).astype(np.uint8) if len(recording) else np.zeros(0, np.uint8),
            stamp_ns=recording.stamps_ns.astype(np.int64),
            rotation=recording.rotation.astype(np.float32),
            translation=recording.translation.astype(np.float32),
            size=recording.size.astype(np.float32),
            init_rotation=recording.init.rotation.astype(np.float32),
            init_translation=recording.init.translation.astype(np.float32),
            init_size=recording.init.size.astype(np.float32),
            joint_values=recording.joint_values.astype(np.float32),
            category=np.array(recording.category.name),
        )
    partial.rename(path)

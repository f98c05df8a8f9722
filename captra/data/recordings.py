"""Recorded sequences with ground truth, as files of compressed arrays."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
from jaxtyping import Float32, Int64, UInt8

from captra.archives import ArchiveError, read_arrays
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
        RecordingError: if it is damaged, lacks an array, or its arrays do not go together; the message says which.
        UnknownCategoryError: if its category is none of the known ones.
    """
    path = Path(path)
    try:
        arrays = read_arrays(path)
    except ArchiveError as error:
        raise _none(path, "it is not an .npz archive, or damaged") from error
    if missing := [name for name in (*_ARRAYS, *_INIT) if name not in arrays]:
        raise _none(path, f"it lacks {', '.join(missing)}")
    category = get_category(str(arrays["category"]) if "category" in arrays else path.stem.split("__")[0])
    _check(path, arrays, category.num_parts)
    offsets, frames = arrays["offsets"], len(arrays["stamp_ns"])
    points = arrays["points"].astype(np.float32) * np.float32(UNIT_M)
    spans = [slice(int(start), int(stop)) for start, stop in pairwise(offsets)]
    return Recording(
        category=category,
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


def _none(path: Path, why: str) -> RecordingError:
    return RecordingError(f"{path} is no recording: {why}; record or download it again")


def _check(path: Path, arrays: Mapping[str, np.ndarray], parts: int) -> None:
    """Raises RecordingError where arrays are not of one recording of so many parts."""
    frames, points = arrays["stamp_ns"].size, len(np.atleast_1d(arrays["points"]))
    shapes: dict[str, tuple[int, ...]] = {
        "stamp_ns": (frames,),
        "offsets": (frames + 1,),
        "points": (points, 3),
        "labels": (points,),
        "rotation": (frames, parts, 3, 3),
        "translation": (frames, parts, 3),
        "size": (parts, 3),
        "init_rotation": (parts, 3, 3),
        "init_translation": (parts, 3),
        "init_size": (parts, 3),
    }
    if "joint_values" in arrays:
        shapes["joint_values"] = (frames, np.atleast_1d(arrays["joint_values"]).shape[-1])
    for name, shape in shapes.items():
        if arrays[name].shape != shape or arrays[name].dtype.kind not in "iuf":
            raise _none(
                path,
                f"{name} is {arrays[name].dtype} {arrays[name].shape}, where {frames} stamps, {points} points and "
                f"{parts} part(s) want numbers {shape}",
            )
    offsets = arrays["offsets"].astype(np.float64)
    if (offsets[0], offsets[-1]) != (0, points) or not (np.diff(offsets) >= 0).all():
        raise _none(path, f"offsets do not rise from 0 to its {points} points")
    if not all(np.isfinite(arrays[name]).all() for name in _INIT):
        raise _none(path, "the pose to begin with holds NaN or infinity")


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

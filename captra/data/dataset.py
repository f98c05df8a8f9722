"""Simulated views on disk: shards that are written once, whole, and read by memory mapping."""

import os
import shutil
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float32, Int16, Int64, UInt8

from captra.data.view import View

UNIT_M = 1e-4
"""Points are stored as int16 multiples of it."""
SHARD_PATTERN = "seed-*_shard-*"


@dataclass(frozen=True)
class ViewShard:
    """Views one after the other; points and labels stay on disk until they are read."""

    points: Int16[np.ndarray, "total 3"]
    """Camera frame, 0.1 mm."""
    labels: UInt8[np.ndarray, " total"]
    """Part of each point; P is background."""
    offsets: Int64[np.ndarray, " views_plus_one"]
    """View i is points[offsets[i]:offsets[i + 1]]."""
    rotation: Float32[np.ndarray, "views P 3 3"]
    """R_camera_part."""
    translation: Float32[np.ndarray, "views P 3"]
    """Centres of the parts' tight boxes, metres."""
    size: Float32[np.ndarray, "views P 3"]
    """Extents of the parts' boxes, metres."""
    joint_values: Float32[np.ndarray, "views J"]
    """Joint states, rad or m."""

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def view(self, index: int) -> View:
        """Read one view."""
        chosen = slice(int(self.offsets[index]), int(self.offsets[index + 1]))
        return View(
            points=self.points[chosen].astype(np.float32) * np.float32(UNIT_M),
            labels=np.array(self.labels[chosen]),
            rotation=np.array(self.rotation[index]),
            translation=np.array(self.translation[index]),
            size=np.array(self.size[index]),
            joint_values=np.array(self.joint_values[index]),
        )


_FIELDS = ("points", "labels", "offsets", "rotation", "translation", "size", "joint_values")


def pack(views: Sequence[View]) -> ViewShard:
    """Join views into a shard; points are rounded to 0.1 mm."""
    offsets = np.cumsum([0, *(len(view.points) for view in views)], dtype=np.int64)
    points = np.concatenate([view.points for view in views])
    return ViewShard(
        points=np.rint(points / UNIT_M).clip(-32768, 32767).astype(np.int16),
        labels=np.concatenate([view.labels for view in views]),
        offsets=offsets,
        rotation=np.stack([view.rotation for view in views]),
        translation=np.stack([view.translation for view in views]),
        size=np.stack([view.size for view in views]),
        joint_values=np.stack([view.joint_values for view in views]),
    )


def write_shard(folder: Path, shard: ViewShard) -> None:
    """Write a shard so that it appears under its name only once it is complete; one that is there already is kept."""
    partial = folder.with_name(f".{folder.name}.{os.getpid()}")
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir(parents=True)
    for field in _FIELDS:
        np.save(partial / f"{field}.npy", getattr(shard, field))
    try:
        partial.rename(folder)
    except OSError:
        shutil.rmtree(partial)
        if not folder.exists():
            raise


def read_shard(folder: Path) -> ViewShard:
    """Open a shard; points and labels are memory-mapped."""
    mapped = ("points", "labels")
    return ViewShard(
        **{field: np.load(folder / f"{field}.npy", mmap_mode="r" if field in mapped else None) for field in _FIELDS}
    )


class ViewDataset:
    """All views of folders, in the order in which their shards were found; a second process may be adding to them."""

    def __init__(self, *folders: Path) -> None:
        self._folders = folders
        self._shards: list[ViewShard] = []
        self._known: set[Path] = set()
        self._starts = np.zeros(1, np.int64)
        self.refresh()

    def refresh(self) -> int:
        """Look for new shards; views found before keep their index. Returns how many views there are now."""
        for path in (path for folder in self._folders for path in sorted(folder.glob(SHARD_PATTERN))):
            if path not in self._known:
                self._known.add(path)
                self._shards.append(read_shard(path))
        self._starts = np.cumsum([0, *(len(shard) for shard in self._shards)], dtype=np.int64)
        return len(self)

    def __len__(self) -> int:
        return int(self._starts[-1])

    def __getitem__(self, index: int) -> View:
        if not 0 <= index < len(self):
            raise IndexError(f"view {index} of {len(self)}: call refresh() if new shards were written")
        shard = int(np.searchsorted(self._starts, index, side="right")) - 1
        return self._shards[shard].view(index - int(self._starts[shard]))

    def __iter__(self) -> Iterator[View]:
        return (self[index] for index in range(len(self)))

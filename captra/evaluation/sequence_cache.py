"""Simulated sequences on disk: each is simulated once for each version of the simulation."""

import hashlib
import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import captra
from captra.data.recordings import Recording, load_recording, save_recording
from captra.data.shapes.shape import Shape

PACKAGE = Path(captra.__file__).parent
GENERATOR = ("data/**/*.py", "categories.py", "geometry.py", "perturbation.py")
"""What a simulated sequence depends on, besides its shape and seed."""
VERSIONS_KEPT = 2
"""This one and the one before; those of older versions are removed: a hundred frames take some four megabytes."""


def generator_version(package: Path = PACKAGE) -> str:
    """Digest of the sources that simulate sequences."""
    digest = hashlib.sha256()
    for path in sorted(path for pattern in GENERATOR for path in package.glob(pattern)):
        digest.update(path.relative_to(package).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def shape_digest(shape: Shape) -> str:
    """Digest of a shape's meshes and joints."""
    digest = hashlib.sha256()
    for array in (*(a for part in shape.parts for a in part), shape.joint_origins, shape.joint_limits):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()[:16]


@dataclass(frozen=True)
class SequenceCache:
    """A folder of simulated sequences of one version; processes may share it."""

    folder: Path
    """Holds one folder a version."""
    version: str
    """As `generator_version` gives it."""

    @staticmethod
    def open(folder: Path) -> "SequenceCache":
        """The cache of the simulation as it is now; what versions long gone have left is removed."""
        cache = SequenceCache(folder, generator_version())
        own = folder / cache.version
        own.mkdir(parents=True, exist_ok=True)
        os.utime(own)
        others = sorted((path for path in folder.iterdir() if path.is_dir() and path != own), key=_modified)
        for path in others[: len(others) - VERSIONS_KEPT + 1]:
            shutil.rmtree(path, ignore_errors=True)
        return cache

    def get(self, name: str, key: str, make: Callable[[], Recording]) -> Recording:
        """The sequence called `name` under `key`, made if it is not there; points are rounded to 0.1 mm either way."""
        path = self.folder / self.version / key / f"{name}.npz"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            save_recording(path, make())
        return load_recording(path)


def _modified(path: Path) -> float:
    return path.stat().st_mtime

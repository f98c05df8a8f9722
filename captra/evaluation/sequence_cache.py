"""Simulated sequences on disk: each is simulated once for each version of the simulation."""

import hashlib
import os
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import captra
from captra.data.recordings import Recording, load_recording, save_recording
from captra.data.shapes.shape import Shape
from captra.errors import UserError

PACKAGE = Path(captra.__file__).parent
GENERATOR = ("data/**/*.py", "categories.py", "geometry.py", "perturbation.py")
"""What a simulated sequence depends on, besides its shape and seed."""
VERSIONS_KEPT = 2
"""This one and the one before; those of older versions are removed: a hundred frames take some four megabytes."""
VERSION = re.compile(r"[0-9a-f]{16}")
KEY = re.compile(r"[0-9a-f]{16}-\d+-\d+")
SEQUENCE = re.compile(r"\w+__.+\.npz|\.\w+__.+\.npz\.\d+")
"""With such as somebody is writing, or was when he died."""


class CacheError(UserError):
    """A folder cannot keep sequences."""


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
        """The cache of the simulation as it is now; what versions long gone have left is removed, and nothing else.

        Raises:
            CacheError: nothing can be written there.
        """
        cache = SequenceCache(folder, generator_version())
        own = folder / cache.version
        try:
            own.mkdir(parents=True, exist_ok=True)
            os.utime(own)
        except OSError as error:
            raise CacheError(
                f"cannot keep sequences in {folder} ({error.strerror}): name a folder that can be written by --cache"
            ) from error
        others = sorted((path for path in folder.iterdir() if path != own and is_version(path)), key=_modified)
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


def is_version(folder: Path) -> bool:
    """Whether this is surely what a version of the simulation left: whoever keeps other things there keeps them."""
    return _is_folder(folder, VERSION) and all(
        _is_folder(key, KEY) and all(_is_file(path, SEQUENCE) for path in key.iterdir()) for key in folder.iterdir()
    )


def _is_folder(path: Path, name: re.Pattern[str]) -> bool:
    return name.fullmatch(path.name) is not None and path.is_dir() and not path.is_symlink()


def _is_file(path: Path, name: re.Pattern[str]) -> bool:
    return name.fullmatch(path.name) is not None and path.is_file()


def _modified(path: Path) -> float:
    return path.stat().st_mtime

"""Named arrays in .npz files, as people hand them over: whole, damaged, or something else by that name."""

import struct
import zlib
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

DAMAGE = (
    BadZipFile,
    zlib.error,
    struct.error,
    EOFError,
    LookupError,
    MemoryError,
    OSError,
    OverflowError,
    RuntimeError,
    TypeError,
    ValueError,
)
"""What reading raises where bits have flipped, in lengths, names, compressed data or the headers of arrays."""


class ArchiveError(ValueError):
    """A file holds no arrays that can be read."""


def read_arrays(path: Path) -> dict[str, np.ndarray]:
    """All arrays of an .npz file by name.

    Raises:
        FileNotFoundError: there is no such file.
        ArchiveError: it is none, or damaged.
    """
    with path.open("rb") as file:
        try:
            with np.load(file, allow_pickle=False) as stored:
                return {name: np.asarray(stored[name]) for name in stored.files}
        except DAMAGE as error:
            raise ArchiveError(f"{path} is no .npz archive, or damaged") from error

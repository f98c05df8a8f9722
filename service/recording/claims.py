"""Who is writing a file: a lock that ends with its process, so that no other service takes the file for left behind."""

import fcntl
import os
from pathlib import Path
from typing import BinaryIO


class Claim:
    """Holds a file; until it is released nobody else can claim it, in this process or another."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file

    def release(self) -> None:
        """Let go of it; once is enough, more does no harm."""
        self._file.close()


def claim(path: Path) -> Claim | None:
    """Claim a file; None where somebody else holds it.

    On file systems without locks every claim succeeds.

    Raises:
        OSError: it cannot be opened.
    """
    file = os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK), "rb")  # waits for nobody, whatever is there
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        return None
    except OSError:
        pass
    return Claim(file)

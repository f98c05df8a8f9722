"""Records a session that this client opened."""

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from captra.data.recordings import Recording, RecordingError
from captra.recording.writer import SessionWriter
from clients.packing import Packed
from clients.results import Result

ENDING = ".mcap"


class McapRecorder:
    """One file of one session; its methods may be called from any thread. Close it, or the file has no index.

    A file that is there already is replaced only once there is a session to record.
    """

    def __init__(self, path: Path) -> None:
        """Raises RecordingError where the file cannot be written, or is not called *.mcap."""
        if path.suffix != ENDING or path.is_dir():
            raise RecordingError(f"cannot record into {path}: name a file that ends in {ENDING}")
        self._path = path
        self._partial: Path | None = path.with_name(f".{path.name}.{os.getpid()}")
        with recording_into(path):
            self._file = SessionWriter(self._partial)

    def session(self, body: Mapping[str, Any]) -> None:
        """The body of the POST that opened the session."""
        self._file.session(body)

    def frame(self, packed: Packed, seq: int, stamp_ns: int) -> None:
        """A frame as it was sent, and what it shows."""
        self._file.frame(seq, stamp_ns, packed.media_type, packed.payload, packed.region, packed.shown())

    def result(self, payload: bytes, result: Result) -> None:
        """A result as it came, byte for byte."""
        self._file.result(payload, result)

    def event(self, payload: bytes) -> None:
        """An event as it came."""
        self._file.event(payload)

    def reset(self, body: Mapping[str, Any]) -> None:
        """The body of a PUT that started the track again."""
        self._file.reset(body)

    def truth(self, recording: Recording) -> None:
        """Where the object really is in every frame that will be played."""
        for frame, stamp_ns in enumerate(recording.stamps_ns.tolist()):
            self._file.truth(stamp_ns, recording.truth(frame))

    def keep(self) -> None:
        """The session is open: give the file its name.

        Raises:
            RecordingError: it cannot have it.
        """
        if self._partial is not None:
            with recording_into(self._path):
                self._partial.replace(self._path)
            self._partial = None

    def close(self) -> None:
        """Write the index; what comes later is not recorded. A file that was not to be kept goes."""
        self._file.close()
        if self._partial is not None:
            self._partial.unlink(missing_ok=True)


class NullRecorder:
    """Records nothing."""

    def session(self, body: Mapping[str, Any]) -> None:
        """Nothing to do."""

    def frame(self, packed: Packed, seq: int, stamp_ns: int) -> None:
        """Nothing to do."""

    def result(self, payload: bytes, result: Result) -> None:
        """Nothing to do."""

    def event(self, payload: bytes) -> None:
        """Nothing to do."""

    def reset(self, body: Mapping[str, Any]) -> None:
        """Nothing to do."""

    def truth(self, recording: Recording) -> None:
        """Nothing to do."""

    def keep(self) -> None:
        """Nothing to do."""

    def close(self) -> None:
        """Nothing to do."""


Recorder = McapRecorder | NullRecorder


def recorder_for(path: Path | str | None) -> Recorder:
    """A recorder into a file, or one that records nothing."""
    return NullRecorder() if path is None else McapRecorder(Path(path))


@contextmanager
def recording_into(path: Path) -> Iterator[None]:
    """Raises RecordingError where the file cannot be written."""
    try:
        yield
    except OSError as error:
        raise RecordingError(
            f"cannot record into {path} ({error.strerror}): name a file in a folder that is there and can be written"
        ) from error

"""The folder of recordings, and how much may be in it."""

import logging
import re
import threading
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from captra.recording.reader import salvage
from captra.recording.writer import SessionWriter
from service.opening import body_of
from service.recording.claims import Claim, claim
from service.recording.tape import NO_TAPE, McapTape, Tape
from service.rejections import (
    NotStoredError,
    RecordingsFullError,
    RejectedError,
    UnfinishedRecordingError,
    UnknownRecordingError,
)
from service.store import SessionRecord

logger = logging.getLogger(__name__)

WHOLE, UNFINISHED, SALVAGED = ".mcap", ".mcap.part", ".mcap.salvaged"
NAME = re.compile(r"[A-Za-z0-9_-]{1,120}")
LEAST_ROOM_BYTES = 2**20
"""A recording that has less room is not begun."""


@dataclass(frozen=True)
class Recorded:
    """One recording."""

    name: str
    """Of the file, without its ending: category and session id."""
    size_bytes: int
    """Of the file."""
    finished: bool
    """Whether it is whole."""


class Recordings:
    """Starts, lists and removes recordings; its methods may be called from any thread."""

    def __init__(self, folder: Path, max_bytes: int, max_total_bytes: int) -> None:
        """`max_bytes` limits one file, `max_total_bytes` the folder."""
        self._folder = folder
        self._max_bytes = max_bytes
        self._max_total_bytes = max_total_bytes
        self._at_work: dict[str, int] = {}  # how large the recordings that are being written have become
        self._claims: dict[str, Claim] = {}
        self._kept_bytes = 0  # by all others, when last looked
        self._changes = 0
        self._lock = threading.RLock()

    @property
    def changes(self) -> int:
        """How often another recording became whole or one was deleted, in this process."""
        return self._changes

    def left_behind(self) -> Sequence[Path]:
        """What a process that died has not finished, before this one begins to record."""
        try:
            return sorted(self._folder.glob(f"*{UNFINISHED}"))
        except OSError:  # sessions go on without
            logger.exception("folder of recordings cannot be read")
            return ()

    def salvage(self, left: Sequence[Path]) -> None:
        """Make whole what was left behind; what cannot be read, or another service is writing, stays as it is."""
        for path in left:
            try:
                claimed = claim(path)
            except OSError:
                logger.exception("recording not salvaged", extra={"recording": path.name})
                continue
            if claimed is None:
                logger.info("another service is recording", extra={"recording": path.name})
                continue
            self._make_whole(path)
            claimed.release()

    def start(self, record: SessionRecord) -> Tape:
        """Begin to record a session, where it wants to be recorded.

        Raises:
            RecordingsFullError: there is no room.
            NotStoredError: the folder cannot be written.
        """
        if not record.record:
            return NO_TAPE
        with self._lock:
            name = self._free_name(f"{record.category}_{record.session_id}")
            self._look()
            if self._used_bytes() + LEAST_ROOM_BYTES > self._max_total_bytes:
                raise RecordingsFullError(self._all_full())
            path = self._folder / (name + UNFINISHED)
            try:
                self._folder.mkdir(parents=True, exist_ok=True)
                writer, claimed = SessionWriter(path), claim(path)
            except OSError as error:
                raise NotStoredError(
                    f"{path} cannot be written ({error}): set CAPTRA_RECORD_DIR to a folder that can"
                ) from error
            self._at_work[name] = 0
            if claimed is not None:
                self._claims[name] = claimed
        return McapTape(
            writer,
            body_of(record),
            partial(self._full, name),
            lambda: self._finished(name),
            lambda: self._broken_off(path),
            name,
        )

    def go_on(self, record: SessionRecord) -> Tape:
        """Record a restored session into one more file; one that there is no room for goes on without."""
        try:
            return self.start(record)
        except RejectedError as rejection:
            logger.warning("not recorded any more: %s", rejection, extra={"session_id": record.session_id})
            return NO_TAPE

    def all(self) -> Sequence[Recorded]:
        """Every recording, by name."""
        with self._lock:  # or one that becomes whole meanwhile would be overlooked under both names
            found = list[Recorded]()
            for path in [*self._folder.glob(f"*{WHOLE}"), *self._folder.glob(f"*{UNFINISHED}")]:
                with suppress(FileNotFoundError):  # somebody else has deleted it
                    if path.is_file():
                        found.append(recorded(path))
            return sorted(found, key=lambda each: each.name)

    def path(self, name: str) -> Path:
        """The file of a whole recording.

        Raises:
            UnknownRecordingError: there is none of this name.
            UnfinishedRecordingError: its session is still open, or it was broken off.
        """
        whole, unfinished = (self._folder / (name + ending) for ending in (WHOLE, UNFINISHED))
        with self._lock:
            if NAME.fullmatch(name) and whole.is_file():
                return whole
            if NAME.fullmatch(name) and unfinished.is_file():
                raise UnfinishedRecordingError(
                    f"{name} is still being recorded: close its session first"
                    if self._is_written(unfinished)
                    else f"{name} was broken off and is not whole: what can be read of it is saved when the service "
                    "starts and has room for a copy; its log says more. DELETE removes it"
                )
        raise UnknownRecordingError(f"there is no recording {name[:100]!r}: GET /v1/recordings lists those there are")

    def remove(self, name: str) -> None:
        """Delete a recording that is whole, or was broken off.

        Raises:
            UnknownRecordingError: there is none of this name.
            UnfinishedRecordingError: its session is still open.
        """
        with self._lock:
            try:
                path = self.path(name)
            except UnfinishedRecordingError:
                path = self._folder / (name + UNFINISHED)
                if self._is_written(path):
                    raise
            path.unlink(missing_ok=True)
            self._changes += 1
            self._look()

    def _is_written(self, unfinished: Path) -> bool:
        """Whether this service or another is writing a file."""
        if unfinished.name.removesuffix(UNFINISHED) in self._at_work:
            return True
        claimed = claim(unfinished)
        if claimed is not None:
            claimed.release()
        return claimed is None

    def _full(self, name: str, size_bytes: int) -> str | None:
        with self._lock:
            self._at_work[name] = size_bytes
            if size_bytes >= self._max_bytes:
                return f"it has the {self._max_bytes} bytes that it may have"
            return self._all_full() if self._used_bytes() >= self._max_total_bytes else None

    def _all_full(self) -> str:
        return (
            f"recordings fill the {self._max_total_bytes} bytes that they may have: DELETE /v1/recordings/…, "
            "or raise CAPTRA_RECORD_MAX_TOTAL_BYTES"
        )

    def _finished(self, name: str) -> None:
        with self._lock:
            try:
                (self._folder / (name + UNFINISHED)).rename(self._folder / (name + WHOLE))
            except FileNotFoundError:
                logger.warning("recording was deleted while it was written", extra={"recording": name})
            self._changes += 1
            self._let_go(name)

    def _broken_off(self, path: Path) -> None:
        """Keep what is there of a recording, now or, where there is no room for that, when the service starts again."""
        self._make_whole(path)
        with self._lock:
            self._let_go(path.name.removesuffix(UNFINISHED))

    def _let_go(self, name: str) -> None:
        self._at_work.pop(name, None)
        if (claimed := self._claims.pop(name, None)) is not None:
            claimed.release()
        self._look()

    def _make_whole(self, path: Path) -> None:
        name = path.name.removesuffix(UNFINISHED)
        whole, salvaged = (self._folder / (name + ending) for ending in (WHOLE, SALVAGED))
        try:
            count = salvage(path, salvaged)
            with self._lock:
                salvaged.replace(path)
                path.rename(whole)
                self._changes += 1
        except Exception as error:  # noqa: BLE001 - whatever one file holds, the others are looked at
            logger.warning("recording not salvaged, its file is left as it is: %s", error, extra={"recording": name})
            with suppress(OSError):
                salvaged.unlink(missing_ok=True)
            return
        logger.info("recording salvaged", extra={"recording": name, "messages": count})

    def _look(self) -> None:
        """See how much all recordings take that this service is not writing."""
        self._kept_bytes = sum(each.size_bytes for each in self.all() if each.name not in self._at_work)

    def _used_bytes(self) -> int:
        return self._kept_bytes + sum(self._at_work.values())

    def _free_name(self, stem: str) -> str:
        names, number = {each.name for each in self.all()}, 1
        while (name := stem if number == 1 else f"{stem}-{number}") in names:
            number += 1
        return name


def recorded(path: Path) -> Recorded:
    """What a file tells of itself."""
    finished = path.name.endswith(WHOLE)
    name = path.name.removesuffix(WHOLE if finished else UNFINISHED)
    return Recorded(name, path.stat().st_size, finished)

"""What a session is recorded on: nothing, or a file that a thread writes, so that no frame waits for a disk."""

import logging
import queue
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, Protocol

from captra.geometry import Pose
from captra.observations import Observation
from captra.recording.writer import SessionWriter, Shown, parts_of
from service.codecs import CDR
from service.envelopes import Envelope, NumberedHeader
from service.results import Event, Result

logger = logging.getLogger(__name__)

MOST_WAITING = 64
"""Messages that may wait for the disk; a recording that falls further behind ends."""


class Tape(Protocol):
    """Takes down one session; called while it is locked, so its methods return quickly."""

    def frame(self, header: NumberedHeader, envelope: Envelope, mask: bytes, observation: Observation) -> None:
        """A frame is about to be tracked; `mask` is its mask or box, packed."""

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """The same for observers."""

    def reset(self, pose: Pose) -> None:
        """The track starts again from this pose."""

    def result(self, result: Result) -> None:
        """A frame was processed."""

    def event(self, event: Event) -> None:
        """Something else happened."""

    def close(self) -> None:
        """Write what waits, and the index."""


class NoTape:
    """The session is not recorded."""

    def frame(self, header: NumberedHeader, envelope: Envelope, mask: bytes, observation: Observation) -> None:
        """Nothing to do."""

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """Nothing to do."""

    def reset(self, pose: Pose) -> None:
        """Nothing to do."""

    def result(self, result: Result) -> None:
        """Nothing to do."""

    def event(self, event: Event) -> None:
        """Nothing to do."""

    def close(self) -> None:
        """Nothing to do."""


NO_TAPE: Tape = NoTape()


class McapTape:
    """Records into one file, as long as there is room and the disk keeps up."""

    def __init__(
        self,
        writer: SessionWriter,
        body: Mapping[str, Any],
        full: Callable[[int], str | None],
        on_whole: Callable[[], None],
        on_broken: Callable[[], None],
        name: str,
    ) -> None:
        """`body` would open such a session; `full` says why a file of so many bytes may not grow, if that is so.

        One of the other callbacks is called on the writing thread at the end:
        `on_whole` where the file is complete, `on_broken` where it could not be written.
        """
        self._writer = writer
        self._full = full
        self._on_whole = on_whole
        self._on_broken = on_broken
        self._name = name
        self._waiting: queue.Queue[Callable[[], None] | None] = queue.Queue(MOST_WAITING)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name=f"captra-tape-{name}", daemon=True)
        self._thread.start()
        self._put(lambda: writer.session(body))

    def frame(self, header: NumberedHeader, envelope: Envelope, mask: bytes, observation: Observation) -> None:
        """Keep it; what it shows is worked out by the thread that writes."""
        media_type = envelope.encoding.partition(";")[0].strip().lower()

        def shown() -> Shown:
            return envelope.payload if media_type == CDR else observation.whole().points

        self._put(
            lambda: self._writer.frame(header.seq, header.stamp_ns, envelope.encoding, envelope.payload, mask, shown())
        )

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """It is kept as a frame."""

    def reset(self, pose: Pose) -> None:
        """Keep the pose."""
        self._put(lambda: self._writer.reset({"parts": parts_of(pose)}))

    def result(self, result: Result) -> None:
        """Keep the result."""
        self._put(lambda: self._writer.result(result.to_json(), result))

    def event(self, event: Event) -> None:
        """Keep the event."""
        self._put(lambda: self._writer.event(event.to_json()))

    def close(self) -> None:
        """Write what waits, and the index."""
        while self._thread.is_alive():
            with suppress(queue.Full):
                self._waiting.put(None, timeout=0.1)
                break
        self._thread.join()

    def _put(self, write: Callable[[], None]) -> None:
        if self._ended.is_set():
            return
        try:
            self._waiting.put_nowait(write)
        except queue.Full:
            self._end("the disk does not keep up")

    def _run(self) -> None:
        try:
            self._write_all()
            self._writer.close()
        except Exception:  # a full disk, most of all
            logger.exception("recording broken off", extra={"recording": self._name})
            self._writer.abandon()
            self._on_broken()
        else:
            self._on_whole()

    def _write_all(self) -> None:
        try:
            while not self._ended.is_set():
                write = self._waiting.get()
                if write is None:
                    break
                self._write(write)
                if (why := self._full(self._writer.size_bytes)) is not None:
                    self._end(why)
        finally:
            self._ended.set()

    def _write(self, write: Callable[[], None]) -> None:
        try:
            write()
        except OSError:
            raise
        except Exception:  # of what was to be written: the file is sound
            logger.exception("recording ends before its session", extra={"recording": self._name})
            self._ended.set()

    def _end(self, why: str) -> None:
        logger.warning("recording ends before its session: %s", why, extra={"recording": self._name})
        self._ended.set()

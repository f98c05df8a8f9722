"""Order of the frames of one session: each newer than the last, gaps counted."""

from service.rejections import RepeatedSeqError, StaleSeqError
from service.runs import Runs


class Sequence:
    """Knows the last frame processed; not thread-safe."""

    def __init__(self, last: int | None = None) -> None:
        self._last = last
        self._refused = Runs()

    @property
    def last(self) -> int | None:
        """Number of the last frame processed; none at the start and after a restart."""
        return self._last

    def next(self) -> int:
        """The number of a frame that brings none."""
        return 0 if self._last is None else self._last + 1

    def check(self, seq: int) -> None:
        """Refuse what is not newer than the last frame.

        Raises:
            RepeatedSeqError: the number of the last frame processed.
            StaleSeqError: an older one.
        """
        if self._is_newer(seq):
            return
        advice = "numbers rise by one a frame; to start over, PUT the pose"
        if seq == self._last:
            raise RepeatedSeqError(f"frame {seq} has been processed already: {advice}")
        raise StaleSeqError(f"frame {seq} is older than {self._last}, the last one processed: {advice}")

    def reject(self, seq: int) -> None:
        """Remember that a frame arrived and was refused, so that it does not count as dropped."""
        if self._is_newer(seq):
            self._refused.add(seq)

    def accept(self, seq: int) -> int:
        """Note that a frame was processed; return how many between it and the last one never arrived."""
        refused = self._refused.take_below(seq)
        dropped = 0 if self._last is None else max(0, seq - self._last - 1 - refused)
        self._last = seq
        return dropped

    def restart(self) -> None:
        """Take any number next."""
        self._last = None
        self._refused.clear()

    def _is_newer(self, seq: int) -> bool:
        return self._last is None or seq > self._last

"""Order of the frames of one session: each newer than the last, gaps counted."""

from typing import Self

from service.rejections import RepeatedSeqError, StaleSeqError
from service.runs import Runs

MOST_MISSING = 100_000
"""Numbers that jump further, an hour of frames, count something else than frames: times, most likely."""


class Sequence:
    """Knows the last frame processed; not thread-safe."""

    def __init__(self, last: int | None = None) -> None:
        self._last = last
        self._above = last  # what numbers have to be higher than, also where the last one is not known
        self._refused = Runs()
        self._refused_unnumbered = 0

    @classmethod
    def resumed(cls, trusted: int | None) -> Self:
        """That of a session which another process left: numbers go on above `trusted`, the last one it stored.

        Whether it processed later ones is not known: the first frame has no gap before it.
        """
        sequence = cls(trusted)
        sequence._last = None
        return sequence

    @property
    def last(self) -> int | None:
        """Number of the last frame processed; none at the start and after a restart."""
        return self._last

    def next(self) -> int:
        """The number of a frame that brings none."""
        return 0 if self._above is None else self._above + 1

    def check(self, seq: int) -> None:
        """Refuse what is not newer than the last frame.

        Raises:
            RepeatedSeqError: the number of the last frame processed.
            StaleSeqError: an older one.
        """
        if self._is_newer(seq):
            return
        advice = "numbers rise by one a frame; to start over, PUT the pose"
        if seq == self._above:
            raise RepeatedSeqError(f"frame {seq} has been processed already: {advice}")
        raise StaleSeqError(f"frame {seq} is older than {self._above}, the last one processed: {advice}")

    def reject(self, seq: int | None) -> None:
        """Remember that a frame arrived and was refused, so that it does not count as dropped.

        One whose number could not be read has some number all the same: it fills a gap before the next frame.
        """
        if seq is None:
            self._refused_unnumbered += 1
        elif self._is_newer(seq):
            self._refused.add(seq)

    def accept(self, seq: int) -> int:
        """Note that a frame was processed; return how many between it and the last one never arrived."""
        refused = self._refused.take_below(seq) + self._refused_unnumbered
        missing = 0 if self._last is None else max(0, seq - self._last - 1 - refused)
        self._last = self._above = seq
        self._refused_unnumbered = 0
        return missing if missing <= MOST_MISSING else 0

    def restart(self) -> None:
        """Take any number next."""
        self._last = self._above = None
        self._refused.clear()
        self._refused_unnumbered = 0

    def _is_newer(self, seq: int) -> bool:
        return self._above is None or seq > self._above

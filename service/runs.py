"""Whole numbers that mostly rise by one, kept as runs of neighbours."""

from bisect import bisect_left, bisect_right


class Runs:
    """A set of numbers, however many; not thread-safe.

    Of more than `most` runs the lowest are counted and no longer told apart: down there a number that was left out is
    taken for one that was added.
    """

    def __init__(self, most: int = 1024) -> None:
        self._most = most
        self._runs: list[range] = []
        self._counted = 0
        self._counted_below = 0

    def add(self, number: int) -> None:
        """Add a number from zero on; once more makes no difference."""
        if number < self._counted_below:
            return
        low = bisect_left(self._runs, number, key=lambda run: run.stop)
        high = bisect_right(self._runs, number + 1, key=lambda run: run.start)
        touching = [range(number, number + 1), *self._runs[low:high]]
        self._runs[low:high] = [range(min(run.start for run in touching), max(run.stop for run in touching))]
        if len(self._runs) > self._most:
            lowest = self._runs.pop(0)
            self._counted += len(lowest)
            self._counted_below = lowest.stop

    def take_below(self, number: int) -> int:
        """How many are lower than `number`; it and they are taken out."""
        taken = self._counted + sum(len(range(run.start, min(run.stop, number))) for run in self._runs)
        self._runs = [range(max(run.start, number + 1), run.stop) for run in self._runs if run.stop > number + 1]
        self._counted = self._counted_below = 0
        return taken

    def clear(self) -> None:
        """Take all out."""
        self._runs.clear()
        self._counted = self._counted_below = 0

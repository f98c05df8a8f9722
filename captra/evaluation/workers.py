"""Where sequences are tracked: in this process, or in several that have a core each."""

import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import AbstractContextManager
from multiprocessing import get_context
from types import TracebackType
from typing import Protocol, TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


class Workers(Protocol):
    """Applies a function to items and gives the results in their order."""

    def map(self, function: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
        """The results, as they become ready."""


class Here(AbstractContextManager["Here"]):
    """One after the other, in this process."""

    def map(self, function: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
        """The results, one by one."""
        return map(function, items)

    def __exit__(self, *_: object) -> None:
        """Nothing is left to stop."""


class Processes(AbstractContextManager["Processes"]):
    """So many at a time, each in a process of its own that knows nothing of this one's threads."""

    def __init__(self, jobs: int) -> None:
        self._pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"), initializer=_leave_interrupts)

    def map(self, function: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
        """The results in the items' order, each as soon as it and those before it are ready."""
        return self._pool.map(function, items)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Wait for what runs; drop what does not yet."""
        self._pool.shutdown(cancel_futures=True)


def workers(jobs: int) -> Here | Processes:
    """For one job at a time no process is started."""
    return Here() if jobs == 1 else Processes(jobs)


def _leave_interrupts() -> None:
    """Ctrl-C is the business of the process that the person sees."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)

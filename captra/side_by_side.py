"""Two pieces of work at the same time, for work that releases the GIL."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

One = TypeVar("One")
Other = TypeVar("Other")


def side_by_side(one: Callable[[], One], other: Callable[[], Other]) -> tuple[One, Other]:
    """Both answers; `one` runs in a thread of its own. What either raises is raised here, once both have ended."""
    with ThreadPoolExecutor(1, "captra-beside") as beside:
        future = beside.submit(one)
        answer = other()
    return future.result(), answer

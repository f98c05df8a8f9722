import threading
from collections.abc import Callable

import pytest

from captra.side_by_side import IN_TURN, SideBySide, WhileCoresAreFree

WAYS = [IN_TURN, WhileCoresAreFree(1), WhileCoresAreFree(2)]


def meeting() -> Callable[[int], int]:
    met = threading.Barrier(2, timeout=10)

    def meet(answer: int) -> int:
        met.wait()
        return answer

    return meet


def test_both_run_at_the_same_time_on_two_cores() -> None:
    meet = meeting()
    assert WhileCoresAreFree(2)(lambda: meet(1), lambda: meet(2)) == (1, 2)


@pytest.mark.parametrize("side_by_side", [IN_TURN, WhileCoresAreFree(1)])
def test_both_run_in_the_callers_thread_on_one_core(side_by_side: SideBySide) -> None:
    assert set(side_by_side(threading.get_ident, threading.get_ident)) == {threading.get_ident()}


def test_who_comes_while_the_cores_are_taken_works_alone() -> None:
    side_by_side, meet, done = WhileCoresAreFree(3), meeting(), threading.Event()

    def busy() -> int:
        assert done.wait(10)
        return 0

    first = threading.Thread(target=side_by_side, args=(busy, lambda: meet(0)))
    first.start()
    meet(0)
    assert set(side_by_side(threading.get_ident, threading.get_ident)) == {threading.get_ident()}
    done.set()
    first.join(10)
    meet = meeting()
    assert side_by_side(lambda: meet(1), lambda: meet(2)) == (1, 2)


@pytest.mark.parametrize("side_by_side", WAYS)
@pytest.mark.parametrize("failing", [0, 1])
def test_an_error_of_either_is_raised_and_forgotten(side_by_side: SideBySide, failing: int) -> None:
    def work(index: int) -> int:
        if index == failing:
            raise ValueError(f"work {index}")
        return index

    for _ in range(3):
        with pytest.raises(ValueError, match=f"work {failing}"):
            side_by_side(lambda: work(0), lambda: work(1))
    assert side_by_side(lambda: 3, lambda: 4) == (3, 4)

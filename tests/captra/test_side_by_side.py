import threading

import pytest

from captra.side_by_side import side_by_side


def test_both_run_at_the_same_time() -> None:
    met = threading.Barrier(2, timeout=10)

    def meet(answer: int) -> int:
        met.wait()
        return answer

    assert side_by_side(lambda: meet(1), lambda: meet(2)) == (1, 2)


@pytest.mark.parametrize("failing", [0, 1])
def test_an_error_of_either_is_raised(failing: int) -> None:
    def work(index: int) -> int:
        if index == failing:
            raise ValueError(f"work {index}")
        return index

    with pytest.raises(ValueError, match=f"work {failing}"):
        side_by_side(lambda: work(0), lambda: work(1))

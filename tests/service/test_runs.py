from hypothesis import given
from hypothesis import strategies as st

from service.runs import Runs

NUMBERS = st.integers(0, 20)


@given(st.lists(NUMBERS | st.none()), NUMBERS)
def test_runs_are_a_set_of_numbers(steps: list[int | None], border: int) -> None:
    """Numbers are added; at a None those below the border are taken."""
    runs, expected = Runs(), set[int]()
    for step in [*steps, None]:
        if step is not None:
            runs.add(step)
            expected.add(step)
        else:
            assert runs.take_below(border) == sum(each < border for each in expected)
            expected = {each for each in expected if each > border}


@given(st.sets(st.integers(0, 1000)), st.integers(1, 3))
def test_numbers_that_rise_are_counted_however_few_runs_are_kept(numbers: set[int], most: int) -> None:
    runs = Runs(most)
    for number in sorted(numbers):
        runs.add(number)
        runs.add(number)
    assert runs.take_below(1001) == len(numbers)


def test_far_numbers_do_not_hide_near_ones() -> None:
    runs = Runs(most=2)
    for number in (2**64 - 1, 10**18, 3, 4, 5, 4):
        runs.add(number)
    assert runs.take_below(10) == 3


def test_nothing_is_left_of_what_is_cleared() -> None:
    runs = Runs(most=1)
    for number in (1, 3, 5):
        runs.add(number)
    runs.clear()
    runs.add(1)
    assert runs.take_below(10) == 1

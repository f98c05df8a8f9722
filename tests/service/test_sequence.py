import pytest
from hypothesis import given
from hypothesis import strategies as st

from service.rejections import RepeatedSeqError, StaleSeqError
from service.sequence import Sequence


def test_first_number_may_be_any() -> None:
    sequence = Sequence()
    sequence.check(2**64 - 1)
    assert sequence.accept(41) == 0
    assert sequence.last == 41


def test_repeated_and_stale_numbers_are_refused() -> None:
    sequence = Sequence(7)
    with pytest.raises(RepeatedSeqError):
        sequence.check(7)
    with pytest.raises(StaleSeqError):
        sequence.check(6)
    sequence.check(8)


def test_gaps_are_dropped_frames() -> None:
    sequence = Sequence(7)
    assert sequence.accept(8) == 0
    assert sequence.accept(12) == 3


def test_refused_frames_are_not_dropped_ones() -> None:
    sequence = Sequence(7)
    for refused in (8, 9, 9, 3):
        sequence.reject(refused)
    assert sequence.accept(12) == 2
    assert sequence.accept(14) == 1


def test_refused_frames_whose_numbers_are_not_known_fill_the_gap_before_the_next() -> None:
    sequence = Sequence(7)
    sequence.reject(8)
    sequence.reject(None)
    assert sequence.accept(12) == 2
    assert sequence.accept(14) == 1
    sequence.reject(None)
    assert sequence.accept(15) == 0
    assert sequence.accept(17) == 1


def test_numbers_that_are_times_count_no_frames() -> None:
    sequence = Sequence(7)
    assert sequence.accept(7 + 33_000_000) == 0
    assert sequence.accept(7 + 33_000_002) == 1


def test_refused_frames_do_not_move_the_sequence() -> None:
    sequence = Sequence(7)
    sequence.reject(1000)
    sequence.check(8)
    assert sequence.accept(8) == 0


@given(st.lists(st.tuples(st.integers(0, 30), st.booleans())))
def test_dropped_are_those_in_between_that_never_arrived(frames: list[tuple[int, bool]]) -> None:
    """Frames in any order, over and over, each usable or not."""
    sequence, arrived, last = Sequence(), set[int](), None
    for seq, usable in frames:
        arrived.add(seq)
        try:
            sequence.check(seq)
        except RepeatedSeqError:
            assert seq == last
            sequence.reject(seq)
        except StaleSeqError:
            assert last is not None
            assert seq < last
            sequence.reject(seq)
        else:
            assert last is None or seq > last
            if not usable:
                sequence.reject(seq)
                continue
            between = range(0) if last is None else range(last + 1, seq)
            assert sequence.accept(seq) == len(set(between) - arrived)
            last = seq


def test_an_object_may_be_out_of_view_for_as_long_as_it_likes() -> None:
    sequence = Sequence(0)
    for refused in range(1, 10_001):
        if refused % 3:
            sequence.reject(refused)
    assert sequence.accept(10_001) == 3333


def test_what_another_process_did_after_its_last_trusted_frame_is_no_gap() -> None:
    sequence = Sequence.resumed(7)
    assert sequence.last is None
    assert sequence.next() == 8
    with pytest.raises(RepeatedSeqError):
        sequence.check(7)
    with pytest.raises(StaleSeqError):
        sequence.check(6)
    sequence.reject(65)
    assert sequence.accept(67) == 0
    assert sequence.accept(70) == 2


def test_restart_takes_any_number() -> None:
    sequence = Sequence(7)
    sequence.restart()
    sequence.check(0)
    assert sequence.accept(0) == 0

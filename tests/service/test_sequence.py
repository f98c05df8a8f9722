import pytest

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


def test_refused_frames_do_not_move_the_sequence() -> None:
    sequence = Sequence(7)
    sequence.reject(1000)
    sequence.check(8)
    assert sequence.accept(8) == 0


def test_restart_takes_any_number() -> None:
    sequence = Sequence(7)
    sequence.restart()
    sequence.check(0)
    assert sequence.accept(0) == 0

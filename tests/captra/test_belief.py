import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.belief import FORGETFUL, Persistence, belief_of, logit, sigmoid

probabilities = st.floats(0, 1)


def after(belief: Persistence, before: float, *told: float) -> float:
    for one in told:
        before = belief.updated(before, one)
    return before


@given(probabilities, probabilities)
def test_without_a_memory_a_frame_speaks_for_itself(before: float, told: float) -> None:
    assert FORGETFUL.updated(before, told) == told


@given(probabilities, probabilities, st.floats(0, 1))
def test_belief_rises_with_what_was_believed_and_with_what_is_told(before: float, told: float, more: float) -> None:
    belief = Persistence()
    lowest = belief.updated(before, told)
    assert 0 <= lowest <= 1
    assert belief.updated(before + more * (1 - before), told) >= lowest
    assert belief.updated(before, told + more * (1 - told)) >= lowest


def test_a_frame_that_tells_nothing_new_leaves_the_odds_to_time() -> None:
    belief = Persistence(usual=0.7, stays=0.9, returns=0.2)
    assert belief.updated(0.5, 0.7) == pytest.approx(0.55)
    assert after(belief, 1.0, *[0.7] * 200) == pytest.approx(0.2 / 0.3)


def test_middling_frames_neither_end_a_track_at_once_nor_bring_one_back() -> None:
    belief = Persistence()
    assert after(belief, 1.0, *[0.5] * 3) > 0.6
    assert after(belief, 0.0, *[0.5] * 3) < 0.3


def test_the_less_is_new_the_less_a_row_of_doubtful_frames_says() -> None:
    believed = [after(Persistence(0.7, news=news), 1.0, *[0.4] * 30) for news in (1.0, 0.5, 0.2)]
    assert believed[0] < 0.1
    assert believed[0] < believed[1] < believed[2]
    assert believed[2] > 0.25


def test_bad_frames_end_a_track_and_good_ones_bring_it_back_within_a_few() -> None:
    belief = Persistence()
    assert after(belief, 1.0, 0.01) < 0.2
    assert after(belief, 0.0, 0.97) < after(belief, 0.0, 0.97, 0.97)
    assert after(belief, 0.0, *[0.97] * 3) > 0.9


def test_a_frame_that_is_certain_is_not_the_last_word() -> None:
    assert after(Persistence(), 1.0, 0.0, *[1.0] * 3) > 0.9


@pytest.mark.parametrize("belief", [FORGETFUL, Persistence(0.5, 0.9, 0.2, 0.4)])
def test_a_manifest_gives_the_belief_back(belief: Persistence) -> None:
    assert belief_of(belief.calibration) == belief


@given(st.floats(1e-5, 1 - 1e-5))
def test_log_odds_and_probability_are_inverse(probability: float) -> None:
    assert sigmoid(logit(probability)) == pytest.approx(probability)

import numpy as np
import pytest

from captra.categories import get_category
from captra.geometry import axis_angle
from captra.turn import Turn, angle_between

Y, X = np.array([0.0, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])
ASPECT = np.array([0.7, 0.5, 0.5])  # of a mug whose handle stands out by 0.2
BODY = np.array([[-0.35, 0.1, 0.0], [0.14, 0.0, 0.1], [0.0, -0.2, 0.25]] * 40)
HANDLE = np.array([[0.3, 0.0, 0.0]])


def test_a_mug_tells_its_turn_by_points_on_its_handle() -> None:
    mug = get_category("mug")
    assert Turn.seen(BODY, ASPECT, mug) == Turn(0.0, 1.0)
    hint = Turn.seen(np.r_[BODY, HANDLE], ASPECT, mug)
    assert 0 < hint.known < 1
    assert hint.known + hint.guessed == 1
    assert Turn.seen(np.r_[BODY, HANDLE.repeat(8, axis=0)], ASPECT, mug) == Turn(1.0, 0.0)


@pytest.mark.parametrize(("name", "known"), [("can", 0.0), ("laptop", 1.0), ("scissors", 1.0)])
def test_others_always_tell_it_or_have_none_and_never_guess(name: str, known: float) -> None:
    assert Turn.seen(BODY, ASPECT, get_category(name)) == Turn(known, 0.0)


def test_a_turn_that_is_not_known_is_no_difference_and_a_tilt_always_is() -> None:
    turned, tilted = axis_angle(Y, 0.5), axis_angle(X, 0.3)
    for known in (0.0, 0.4, 1.0):
        turn = Turn(known, 1 - known)
        assert angle_between(np.eye(3), turned, turn) == pytest.approx(0.5 * known, abs=1e-9)
        assert angle_between(np.eye(3), tilted, turn) == pytest.approx(0.3)

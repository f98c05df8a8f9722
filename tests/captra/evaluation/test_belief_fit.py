from captra.belief import FORGETFUL
from captra.evaluation.belief_fit import SHARES_OF_NEWS, fit_belief
from tests.captra.evaluation.test_thresholds import MODEL, track


def test_frames_that_say_the_same_all_along_tell_little_new() -> None:
    doubted = [track([0.45] * 40, [1] * 40, 41, 41) for _ in range(4)]
    wrong = [track([0.3] * 40, [60] * 40, 41, 41)]
    assert fit_belief(MODEL, [*doubted, *wrong], 0.7).news < 0.5


def test_frames_that_are_right_or_wrong_by_themselves_tell_all() -> None:
    lost = [track([*[0.9] * 10, *[0.1] * 10] * 2, [*[1] * 10, *[60] * 10] * 2, 11, 41) for _ in range(4)]
    assert fit_belief(MODEL, lost, 0.5).news == max(SHARES_OF_NEWS)


def test_tracks_without_points_say_nothing() -> None:
    nothing = track([float("nan")] * 5, [60] * 5, 1, 6)
    assert fit_belief(MODEL, [nothing], 0.6) != FORGETFUL

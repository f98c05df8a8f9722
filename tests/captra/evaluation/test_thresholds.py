from dataclasses import replace

import numpy as np

from captra.belief import Persistence, logit, sigmoid
from captra.confidence import FEATURES, UNCALIBRATED, ConfidenceModel
from captra.evaluation.health_figures import DEADLINE, Share, false_alarms, losses
from captra.evaluation.thresholds import USUAL_DOUBT, USUAL_LOGITS, choose_thresholds, confidences, states
from captra.evaluation.watching import Watched
from captra.health import HealthMonitor, State
from tests.captra.evaluation.test_health_report import HIDDEN, told

MODEL = ConfidenceModel(6.0, dict(UNCALIBRATED))
SHOWN = FEATURES.index("doubtful_mask")


def track(confidence: list[float], error_deg: list[float], start: int, stop: int) -> Watched:
    """A track whose evidence has these confidences under `MODEL`; NaN for frames without points."""
    one = told([State.TRACKING] * len(confidence), error_deg, start, stop)
    p = np.array(confidence)
    features = np.zeros((len(p), 1, len(FEATURES)))
    features[:, 0, SHOWN] = (np.log(p / (1 - p)) - MODEL.bias) / MODEL.weights["doubtful_mask"]
    features[np.isnan(p)] = np.nan
    return replace(one, features=features)


def test_states_follow_from_confidences_and_from_frames_without_points() -> None:
    one = track([0.9, 0.9, *[HIDDEN] * 5, *[0.9] * 5], [1, 1, *[HIDDEN] * 5, *[1] * 5], 3, 8)
    said = states(HealthMonitor(MODEL, 0.2, 0.5), confidences(MODEL, one))
    assert said[2] is State.TRACKING
    assert said[6] is State.LOST
    assert said[-1] is State.TRACKING


def test_thresholds_tell_losses_apart_from_good_frames_that_are_not_sure() -> None:
    lost = track([*[0.8] * 5, *[0.45] * 8, *[0.8] * 5], [*[1] * 5, *[HIDDEN] * 8, *[1] * 5], 6, 14)
    unsure = track([0.62, 0.9] * 10, [1] * 20, 21, 21)
    monitor = choose_thresholds(MODEL, [lost, unsure])
    assert 0.45 < monitor.doubt_below < 0.62
    retold = [replace(one, states=states(monitor, confidences(MODEL, one))) for one in (lost, unsure)]
    assert [loss.delay for loss in losses(retold) if loss.delay is not None and loss.delay <= DEADLINE] == [3]
    assert false_alarms(retold).part == 0


def test_what_is_wrong_but_sure_does_not_make_all_good_frames_doubtful() -> None:
    wrong = track([0.9] * 20, [*[1] * 5, *[60] * 15], 6, 6)
    good = [track([0.55] * 20, [1] * 20, 21, 21) for _ in range(3)]
    monitor = choose_thresholds(MODEL, [wrong, *good])
    assert monitor.doubt_below < 0.55
    assert false_alarms(replace(one, states=states(monitor, confidences(MODEL, one))) for one in good) == Share(0, 60)


def test_frames_that_are_doubted_all_along_for_one_reason_are_not_summed_up() -> None:
    good = [track([0.2] * 40, [1] * 40, 41, 41) for _ in range(3)]
    lost = track([*[0.7] * 10, *[0.01] * 10, *[0.7] * 10], [*[1] * 10, *[HIDDEN] * 10, *[1] * 10], 11, 21)
    beliefs = [Persistence(0.7, news=news) for news in (1.0, 0.35)]
    monitor = choose_thresholds(MODEL, [*good, lost], beliefs)
    assert monitor.belief == beliefs[1]
    retold = [replace(one, states=states(monitor, confidences(MODEL, one))) for one in (*good, lost)]
    assert false_alarms(retold).part == 0
    assert [loss.delay is not None and loss.delay <= DEADLINE for loss in losses(retold)] == [True]


def test_trust_is_regained_only_by_what_is_not_as_sure_of_wrong_places() -> None:
    relapse = track(
        [*[0.95] * 5, *[0.1] * 6, *[0.6] * 12, *[0.95] * 6], [*[1] * 5, *[HIDDEN] * 6, *[60] * 12, *[1] * 6], 6, 12
    )
    monitor = choose_thresholds(MODEL, [relapse])
    said = states(monitor, confidences(MODEL, relapse))
    assert State.TRACKING not in said[11:23]
    assert said[-1] is State.TRACKING


def test_where_the_tracks_do_not_tell_thresholds_apart_the_usual_ones_are_taken() -> None:
    clear = track([*[0.99] * 5, *[0.01] * 8, *[0.99] * 5], [*[1] * 5, *[HIDDEN] * 8, *[1] * 5], 6, 14)
    monitor = choose_thresholds(MODEL, [clear])
    assert (monitor.doubt_below, monitor.trust_above) == (USUAL_DOUBT, sigmoid(logit(USUAL_DOUBT) + USUAL_LOGITS))

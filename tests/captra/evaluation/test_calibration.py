from dataclasses import replace

import numpy as np
import pytest

from captra.confidence import FEATURES, UNCALIBRATED, ConfidenceModel
from captra.evaluation.calibration import RIDGE, Observations, auroc, confidences, fit, fit_confidence

TRUTH = ConfidenceModel(7.4, {name: (1.4 if i % 2 else 0.8) * UNCALIBRATED[name] for i, name in enumerate(FEATURES)})
LOOSE_RIDGE = 3e-3


def made_up(steps: int = 4000, parts: int = 1) -> Observations:
    rng = np.random.default_rng(1)
    features = rng.exponential(0.15, (steps, parts, len(FEATURES)))
    probability = 1 / (1 + np.exp(-TRUTH.logit(features)))
    return Observations(features, rng.random((steps, parts)) < probability)


def test_the_model_that_made_the_data_is_found_again() -> None:
    found = made_up()
    model = fit(found.features[:, 0], found.correct[:, 0], LOOSE_RIDGE)
    difference = confidences(model, found) - confidences(TRUTH, found)
    assert np.abs(difference).mean() < 0.05


def test_confidence_is_calibrated() -> None:
    found = made_up()
    confidence, right = confidences(fit_confidence(found), found), found.correct[:, 0]
    assert confidence.mean() == pytest.approx(right.mean(), abs=0.03)
    sure = confidence > np.median(confidence)
    assert confidence[sure].mean() == pytest.approx(right[sure].mean(), abs=0.05)


def test_confidence_in_all_parts_at_once_is_less_than_in_the_worst_of_them_alone() -> None:
    found = made_up(parts=3)
    alone = confidences(fit(found.features.reshape(-1, len(FEATURES)), found.correct.reshape(-1)), found)
    together, right = confidences(fit_confidence(found), found), found.correct.all(axis=1)
    assert abs(together.mean() - right.mean()) < 0.7 * abs(alone.mean() - right.mean())
    assert right.mean() < together.mean() < alone.mean()


def test_a_fit_to_few_objects_stays_near_what_suits_most_categories() -> None:
    found = made_up(300)
    far, near = (fit(found.features[:, 0], found.correct[:, 0], ridge) for ridge in (LOOSE_RIDGE, RIDGE))
    spread = found.features[:, 0].std(axis=0)

    def distance(model: ConfidenceModel) -> float:
        return float(np.linalg.norm([model.weights[name] - UNCALIBRATED[name] for name in FEATURES] * spread))

    assert 0 < distance(near) < distance(far) / 1.5


def test_a_feature_that_seems_to_be_good_news_is_left_out() -> None:
    found = made_up()
    flipped = found.features.copy()
    flipped[:, 0, 0] = np.where(found.correct[:, 0], 1.0, 0.0)
    model = fit(flipped[:, 0], found.correct[:, 0], LOOSE_RIDGE)
    assert model.weights[FEATURES[0]] == 0
    assert all(weight <= 0 for weight in model.weights.values())


@pytest.mark.parametrize("right", [True, False])
def test_steps_that_are_all_right_or_all_wrong_can_be_calibrated_on(right: bool) -> None:
    found = made_up(200)
    model = fit_confidence(replace(found, correct=np.full_like(found.correct, right)))
    confidence = confidences(model, found)
    assert (confidence.mean() > 0.8) == right
    assert np.isfinite(list(model.weights.values())).all()
    assert set(model.weights) == set(UNCALIBRATED)


def test_nothing_to_calibrate_on_is_refused() -> None:
    with pytest.raises(ValueError, match="nothing to calibrate on"):
        fit_confidence(Observations(np.zeros((0, 1, len(FEATURES))), np.zeros((0, 1), bool)))


def test_auroc_counts_pairs_in_the_right_order() -> None:
    correct = np.array([True, True, False, False])
    assert auroc(np.array([0.9, 0.8, 0.2, 0.1]), correct) == 1
    assert auroc(np.array([0.1, 0.2, 0.8, 0.9]), correct) == 0
    assert auroc(np.array([0.9, 0.15, 0.2, 0.1]), correct) == 0.75
    assert auroc(np.full(4, 0.5), correct) == 0.5
    assert np.isnan(auroc(np.ones(2), np.ones(2, bool)))

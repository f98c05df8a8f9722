import numpy as np
import pytest

from captra.evaluation.calibration import Observations, auroc, confidences, fit, observe
from captra.health import ConfidenceModel
from tests.captra.evaluation.test_evaluation import still_recording
from tests.oracle import OracleNetworks


def made_up(count: int = 4000) -> tuple[ConfidenceModel, Observations]:
    rng = np.random.default_rng(0)
    truth = ConfidenceModel(bias=3, residual=-20, outliers=-1, disagreement=-4, few_points=-2, jump=-3)
    features = rng.uniform(0, [0.3, 1, 0.6, 1, 0.5], (count, 5))
    probability = np.array([truth.probability(row) for row in features])
    return truth, Observations(features, rng.random(count) < probability)


def test_the_model_that_made_the_data_is_found_again() -> None:
    truth, observations = made_up()
    found = fit(observations)
    difference = confidences(found, observations) - confidences(truth, observations)
    assert np.abs(difference).mean() < 0.03
    assert np.abs(confidences(found, observations).mean() - observations.correct.mean()) < 0.02


def test_fitting_needs_right_and_wrong_steps() -> None:
    with pytest.raises(ValueError, match="both"):
        fit(Observations(np.zeros((5, 5)), np.ones(5, bool)))


def test_auroc_counts_pairs_in_the_right_order() -> None:
    correct = np.array([True, True, False, False])
    assert auroc(np.array([0.9, 0.8, 0.2, 0.1]), correct) == 1
    assert auroc(np.array([0.1, 0.2, 0.8, 0.9]), correct) == 0
    assert auroc(np.array([0.9, 0.15, 0.2, 0.1]), correct) == 0.75


def test_every_step_of_every_start_is_observed() -> None:
    recording = still_recording("camera")
    truth = recording.truth(0)
    observations = observe(OracleNetworks(recording.category, truth, truth), [recording])
    assert observations.features.shape[1] == 5
    assert len(observations.features) == len(observations.correct) <= 9

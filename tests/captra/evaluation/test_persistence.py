from dataclasses import replace

import numpy as np
import pytest

from captra.belief import Persistence, logit
from captra.confidence import FEATURES, UNCALIBRATED, ConfidenceModel
from captra.evaluation.persistence import believed, confidences, fit_persistence
from captra.evaluation.watching import Watched
from captra.health import State
from tests.captra.evaluation.test_health_report import told

MODEL = ConfidenceModel(0.0, dict(UNCALIBRATED))


def drawn(truth: Persistence, frames: int, seed: int) -> Watched:
    """A track that is right and wrong by turns as `truth` has it, with evidence that tells one from the other badly."""
    rng, right, rights = np.random.default_rng(seed), True, list[bool]()
    for _ in range(frames):
        right = bool(rng.random() < (truth.stays if right else truth.returns))
        rights.append(right)
    one = told([State.TRACKING] * frames, [1.0 if right else 60.0 for right in rights], frames + 1, frames + 1)
    features = np.zeros((frames, 1, len(FEATURES)))
    news = rng.normal(np.where(rights, 1.0, -1.0), np.sqrt(2))  # the log odds of these two normals are the value itself
    usual = truth.returns / (truth.returns + 1 - truth.stays)
    features[:, 0, 0] = (news + logit(usual)) / UNCALIBRATED[FEATURES[0]]
    return replace(one, features=features)


def test_the_persistence_that_made_the_tracks_is_found_again() -> None:
    for truth in (Persistence(0.95, 0.1, 1.0), Persistence(0.9, 0.2, 1.0)):
        found = fit_persistence(MODEL, [drawn(truth, 400, seed) for seed in range(10)])
        assert (found.stays, found.returns) == (truth.stays, truth.returns)


def test_belief_follows_the_truth_better_than_single_frames() -> None:
    one = drawn(Persistence(0.98, 0.06), 2000, 0)
    right, alone = one.found.all(axis=1), confidences(MODEL, one)
    together = believed(fit_persistence(MODEL, [one]), alone)
    assert ((together > 0.5) == right).mean() > ((alone > 0.5) == right).mean() + 0.05


def test_frames_without_points_tell_of_a_loss() -> None:
    assert believed(Persistence(), np.array([0.9, np.nan, np.nan]))[-1] < 0.01


@pytest.mark.parametrize("right", [True, False])
def test_tracks_that_are_all_right_or_all_wrong_can_be_fitted(right: bool) -> None:
    one = told([State.TRACKING] * 60, [1.0 if right else 60.0] * 60, 61, 61)
    alone = confidences(MODEL, one) + np.where(right, 0.45, -0.45)
    assert (believed(fit_persistence(MODEL, [one]), alone).mean() > 0.5) == right

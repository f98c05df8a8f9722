from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.confidence import FEATURES, UNCALIBRATED, ConfidenceModel, features
from captra.evidence import Evidence, PartEvidence, Ride

GOOD = PartEvidence(
    points=500,
    centroid=np.zeros(3),
    explained=np.zeros((0, 3)),
    residual=0.02,
    inliers=0.95,
    disagreement_rad=0.03,
    rotation_jump_rad=0.02,
    translation_jump=0.02,
    scale_jump=0.005,
    spread=0.002,
    shape_jump=0.02,
    share=0.5,
    filled=0.9,
    certainty=0.97,
    outside=0.01,
    thickness=0.08,
    diagonal_error=0.03,
    guessed_turn=0.0,
)
BAD = replace(GOOD, residual=0.2, inliers=0.1, disagreement_rad=0.6, certainty=0.5)
GUESS = replace(GOOD, guessed_turn=1.0)


def evidence(*parts: PartEvidence, distinct_points: int = 1024) -> Evidence:
    return Evidence(parts, 0.5, distinct_points)


def test_there_is_a_feature_and_a_weight_for_every_name() -> None:
    assert features(evidence(GOOD, BAD)).shape == (2, len(FEATURES))
    assert set(UNCALIBRATED) == set(FEATURES)


def test_good_evidence_is_trusted_and_bad_evidence_is_not() -> None:
    model = ConfidenceModel()
    assert model(evidence(GOOD)) > 0.8
    assert model(evidence(BAD)) < 0.1


def test_the_worst_part_decides() -> None:
    model = ConfidenceModel()
    assert model(evidence(GOOD, BAD)) == pytest.approx(model(evidence(BAD)))


def test_a_missing_part_is_never_trusted() -> None:
    assert ConfidenceModel()(evidence(GOOD, PartEvidence.missing(0, np.zeros(3)))) < 0.01


def test_a_part_that_rides_is_as_right_as_the_part_that_it_rides_on_but_for_its_few_points() -> None:
    model, nothing = ConfidenceModel(), PartEvidence.missing(0, np.zeros(3))
    carried = replace(evidence(GOOD, nothing), rides=(Ride(1, 0, 0, turned=0.0, seen=0.0),))
    assert model(carried) == pytest.approx(model(evidence(GOOD, replace(GOOD, share=0.0))))
    assert 0.5 < model(carried) < model(evidence(GOOD))
    half = replace(evidence(GOOD, BAD), rides=(Ride(1, 0, 0, turned=0.5, seen=0.5),))
    assert model(evidence(GOOD, BAD)) < model(half) < model(evidence(GOOD))
    assert model(replace(evidence(BAD, nothing), rides=carried.rides)) <= model(evidence(BAD))


def test_the_longer_a_hinge_is_only_taken_to_stand_still_the_less_its_part_is_trusted() -> None:
    nothing = PartEvidence.missing(0, np.zeros(3))

    def hidden_for(frames: float) -> Evidence:
        return replace(evidence(GOOD, nothing), rides=(Ride(1, 0, 0, 0.0, 0.0, frames),))

    told = [ConfidenceModel()(hidden_for(frames)) for frames in (0, 1, 5, 30)]
    assert sorted(told, reverse=True) == told
    assert told[0] - told[3] > 0.1
    chain = replace(evidence(GOOD, nothing, nothing), rides=(*hidden_for(1e9).rides, Ride(2, 1, 1, 0.0, 0.0)))
    assert features(chain)[:, FEATURES.index("stood_still")].tolist() == pytest.approx([0.0, 1.0, 0.0])


def test_a_part_rides_on_one_that_rides_itself() -> None:
    nothing = PartEvidence.missing(0, np.zeros(3))
    chain = replace(evidence(nothing, nothing, GOOD), rides=(Ride(1, 2, 0, 0.0, 0.0), Ride(0, 1, 1, 0.0, 0.0)))
    assert ConfidenceModel()(chain) == pytest.approx(ConfidenceModel()(evidence(GOOD, replace(GOOD, share=0.0))))


def test_a_sparse_cloud_is_trusted_less() -> None:
    model = ConfidenceModel()
    assert model(evidence(GOOD, distinct_points=12)) < model(evidence(GOOD))


def test_what_is_flat_or_guessed_or_sticks_out_of_its_box_is_trusted_less() -> None:
    model, good = ConfidenceModel(), ConfidenceModel()(evidence(GOOD))
    for worse in (replace(GOOD, thickness=0.001), replace(GOOD, outside=0.4), replace(GOOD, diagonal_error=0.6), GUESS):
        assert model(evidence(worse)) < good - 0.01


def test_a_fit_from_before_a_feature_was_known_still_counts() -> None:
    older = {name: weight for name, weight in UNCALIBRATED.items() if name != "flat"}
    model = ConfidenceModel(3.0, older)
    assert model(evidence(GOOD)) == pytest.approx(model(evidence(replace(GOOD, thickness=0.0))))


def test_jumps_do_not_count_where_they_were_to_be_expected() -> None:
    jumped = replace(GOOD, rotation_jump_rad=0.5, translation_jump=0.6, scale_jump=0.1)
    model = ConfidenceModel()
    assert model(evidence(jumped)) < model(evidence(GOOD))
    assert model(evidence(jumped).without_jumps()) == pytest.approx(model(evidence(GOOD).without_jumps()))
    assert model(evidence(BAD).without_jumps()) < model(evidence(GOOD))


@given(st.floats(0, 1), st.floats(0, 3), st.floats(0, 1), st.floats(0, 1))
def test_worse_evidence_is_never_trusted_more(residual: float, disagreement: float, more: float, less: float) -> None:
    part = replace(GOOD, residual=residual, disagreement_rad=disagreement)
    worse = replace(
        part,
        residual=residual + more,
        disagreement_rad=disagreement + more,
        rotation_jump_rad=part.rotation_jump_rad + more,
        certainty=part.certainty * less,
        filled=part.filled * less,
        outside=part.outside + more,
        thickness=part.thickness * less,
        diagonal_error=part.diagonal_error + more,
    )
    model = ConfidenceModel()
    assert 0 <= model(evidence(worse)) <= model(evidence(part)) <= 1

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.confidence import UNCALIBRATED, ConfidenceModel
from captra.evidence import Evidence
from captra.health import HealthMonitor, State
from captra.observations import Crop
from captra.tracker import Tracker
from captra.visibility import LEAST_LEFT, Visibility, visible
from tests.captra.test_confidence import GOOD, evidence
from tests.oracle import OracleNetworks, explaining, scene


def seen(amount: float) -> Evidence:
    return replace(evidence(GOOD), visible=amount)


def explained_at(distance_m: float, count: int) -> Evidence:
    return evidence(replace(GOOD, explained=np.tile([0.0, 0.0, distance_m], (count, 1))))


def crop_of(count: int) -> Crop:
    return Crop(np.zeros((count, 3), np.float32), np.arange(count))


def test_as_much_is_seen_of_an_object_far_away_as_nearby() -> None:
    near, far = visible(explained_at(0.5, 400), crop_of(400)), visible(explained_at(1.0, 100), crop_of(100))
    assert near == pytest.approx(far)


def test_points_stand_for_all_that_they_were_chosen_from() -> None:
    thinned = crop_of(4000).chosen(np.arange(1024))
    assert visible(explained_at(1.0, 1024), thinned) == pytest.approx(4000)
    assert visible(explained_at(1.0, 512), thinned) == pytest.approx(2000)


def test_points_that_are_no_part_of_the_object_stand_for_nothing() -> None:
    whole = crop_of(4000)
    own = whole.kept(np.arange(4000) < 1000)
    assert visible(explained_at(1.0, 512), own.chosen(np.arange(512))) == pytest.approx(1000)


def test_nothing_is_seen_where_nothing_is_explained() -> None:
    assert visible(explaining(0, 0), crop_of(100)) == 0


def test_the_first_frame_is_as_usual() -> None:
    assert Visibility().judged(seen(3.0)).vanished == 0


@given(st.floats(1.0, 1e4), st.floats(LEAST_LEFT, 1.0))
def test_the_less_is_left_the_more_has_vanished(usual: float, left: float) -> None:
    visibility = Visibility().updated(seen(usual))
    assert visibility.judged(seen(usual * left)).vanished == pytest.approx(-np.log(left), abs=1e-6)
    assert visibility.judged(seen(usual / left)).vanished == 0


def test_next_to_nothing_has_vanished_like_nothing() -> None:
    visibility = Visibility().updated(seen(100.0))
    assert visibility.judged(seen(0.0)).vanished == visibility.judged(seen(0.5)).vanished == -np.log(LEAST_LEFT)


def test_a_track_gets_used_to_seeing_less() -> None:
    visibility = Visibility().updated(seen(100.0))
    for _ in range(100):
        visibility = visibility.updated(seen(20.0))
    assert visibility.judged(seen(20.0)).vanished < 0.01


def test_what_has_vanished_is_trusted_less() -> None:
    assert ConfidenceModel()(replace(seen(1.0), vanished=3.0)) < ConfidenceModel()(seen(1.0)) - 0.1


def test_a_tracker_notices_that_most_of_its_object_is_gone_and_starts_afresh_with_a_new_pose() -> None:
    category, pose, points = scene("laptop_articulated", np.random.default_rng(0))
    tracker = Tracker(OracleNetworks(category, pose, pose), pose)
    for _ in range(3):
        assert tracker.step(points).evidence.vanished < 0.1
    result = tracker.step(points[::40])
    assert result.evidence.vanished == pytest.approx(np.log(40), abs=0.2)
    assert tracker.step(points).evidence.vanished < 0.1
    tracker.reset(pose)
    assert tracker.step(points[::40]).evidence.vanished == 0


def test_a_lost_track_does_not_get_used_to_seeing_little() -> None:
    category, pose, points = scene("laptop_articulated", np.random.default_rng(0))
    watchful = ConfidenceModel(weights={**UNCALIBRATED, "vanished": -10.0})
    tracker = Tracker(OracleNetworks(category, pose, pose), pose, HealthMonitor(watchful))
    tracker.step(points)
    for _ in range(60):
        result = tracker.step(points[::100])
    assert result.state is not State.TRACKING
    assert result.evidence.vanished > 4

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import Category, get_category
from captra.geometry import Pose
from captra.openings import told_apart
from captra.pose_memory import NO_ERROR
from captra.sampling import Neighborhoods
from captra.solving import Prediction
from captra.tracker import Tracker
from tests.captra.test_stacking import before_camera, cabinet, own
from tests.oracle import OracleNetworks, surfaces

DRAWERS, GLASSES, MUG = (get_category(name) for name in ("drawers", "glasses", "mug"))
LOWEST, MIDDLE, TOP, BASE = range(4)


def said(*probabilities: float) -> Prediction:
    """Of a single point."""
    segmentation = np.array(probabilities, np.float32)[:, None]
    nothing = np.zeros((len(probabilities), 1, 3), np.float32)
    return Prediction(segmentation, nothing, segmentation.argmax(axis=0), np.zeros((len(probabilities), 1, 3, 3)))


def at(pose: Pose, part: int, own_m: tuple[float, float, float]) -> np.ndarray:
    """One point in a part's own frame, as the camera has it."""
    return np.asarray([pose.rotation[part] @ np.array(own_m) + pose.translation[part]], np.float32)


@given(st.integers(0, 9), st.floats(-0.8, 0.8), st.sampled_from([LOWEST, MIDDLE, TOP]))
def test_a_front_is_that_of_the_drawer_whose_opening_it_is_in_however_far_it_is_pulled(
    seed: int, pulled_m: float, drawer: int
) -> None:
    pose = cabinet(seed)
    believed = [0.05, 0.05, 0.05, 0.05]
    believed[(drawer + 1) % 3] = 0.85
    told = told_apart(said(*believed), at(pose, drawer, (0.1, 0.02, pulled_m)), pose, DRAWERS)
    assert told.labels.tolist() == [drawer]
    np.testing.assert_allclose(told.segmentation.sum(axis=0), 1, rtol=1e-5)
    assert told.segmentation[BASE, 0] == pytest.approx(0.05)


def test_whether_it_is_a_drawer_at_all_is_left_to_the_networks() -> None:
    pose = cabinet(1)
    told = told_apart(said(0.1, 0.1, 0.1, 0.7), at(pose, TOP, (0, 0, 0)), pose, DRAWERS)
    assert told.labels.tolist() == [BASE]


def test_near_an_edge_the_networks_decide() -> None:
    pose = cabinet(2)
    edge = at(pose, LOWEST, (0, 0.145, 0))  # a little above its own front, a little below the next
    for probabilities, label in (((0.7, 0.3, 0, 0), LOWEST), ((0.3, 0.7, 0, 0), MIDDLE)):
        assert told_apart(said(*probabilities), edge, pose, DRAWERS).labels.tolist() == [label]


def test_far_from_every_part_the_networks_decide() -> None:
    pose = cabinet(3)
    lost = replace(pose, translation=pose.translation + 50)
    told = told_apart(said(0.2, 0.6, 0.1, 0.1), at(pose, LOWEST, (0, 0, 0)), lost, DRAWERS)
    assert np.isfinite(told.segmentation).all()
    np.testing.assert_allclose(told.segmentation.sum(axis=0), 1, rtol=1e-5)


@pytest.mark.parametrize("category", [GLASSES, MUG], ids=lambda category: category.name)
def test_parts_that_are_on_no_slides_are_left_to_the_networks(category: Category) -> None:
    prediction = said(*[1 / category.num_classes] * category.num_classes)
    assert told_apart(prediction, np.zeros((1, 3), np.float32), cabinet(1), category) is prediction


class Mistaken(OracleNetworks):
    """Takes the middle drawer for the lowest."""

    def coordinates(self, points_canonical: np.ndarray, neighborhoods: Neighborhoods) -> tuple[np.ndarray, np.ndarray]:
        """The truth but for that."""
        segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
        segmentation[LOWEST] = np.maximum(segmentation[LOWEST], 0.9 * segmentation[MIDDLE])
        segmentation[MIDDLE] *= 0.1
        return segmentation, coordinates


def test_a_track_tells_drawers_apart_that_look_alike() -> None:
    rng = np.random.default_rng(4)
    truth = before_camera(4)
    drawn = replace(
        truth, translation=truth.translation + np.array([[0], [1], [0], [0]]) * 0.02 * truth.rotation[0, :, 2]
    )
    cloud = surfaces(drawn, 1500, rng)
    tracker = Tracker(Mistaken(DRAWERS, drawn, truth, found_error=NO_ERROR), truth)
    result = tracker.step(cloud)
    assert result.evidence.parts[MIDDLE].points > 50
    assert own(result.pose, truth)[MIDDLE, 2] == pytest.approx(0.02, abs=0.01)

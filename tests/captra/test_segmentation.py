import numpy as np
import pytest

from captra.categories import CATEGORIES
from captra.depth_images import DepthImage, Intrinsics
from captra.segmentation import (
    BACKGROUND,
    NOTHING_KNOWN,
    OBJECT,
    UNKNOWN,
    Box,
    LabelImage,
    overrule,
    without_background,
)
from captra.tracker import Tracker
from tests.oracle import OracleNetworks, scene

MUG, LAPTOP = CATEGORIES["mug"], CATEGORIES["laptop_articulated"]


def test_nothing_known_changes_nothing() -> None:
    probabilities = np.array([[0.3], [0.7]], np.float32)
    assert overrule(probabilities, NOTHING_KNOWN.labels(np.array([5])), MUG) is probabilities


def test_labels_overrule_the_network() -> None:
    probabilities = np.tile(np.array([[0.3], [0.7]], np.float32), (1, 4))
    labels = np.array([BACKGROUND, 1, OBJECT, UNKNOWN], np.uint8)
    np.testing.assert_allclose(overrule(probabilities, labels, MUG), [[0, 1, 1, 0.3], [1, 0, 0, 0.7]])


def test_object_without_parts_leaves_the_parts_to_the_network() -> None:
    probabilities = np.array([[0.2, 0.9, 0.5], [0.8, 0.1, 0.5]], np.float32)
    labels = np.array([OBJECT, 2, OBJECT], np.uint8)
    np.testing.assert_allclose(overrule(probabilities, labels, LAPTOP), [[0.2, 0, 0.5], [0.8, 1, 0.5]])


def test_a_network_sure_of_background_still_names_a_part_for_the_object() -> None:
    overruled = overrule(np.array([[0.0], [1.0]], np.float32), np.array([OBJECT], np.uint8), MUG)
    np.testing.assert_array_equal(overruled, [[1], [0]])


def test_box_says_what_is_outside() -> None:
    box = Box(columns=10, left=2, top=1, right=4, bottom=3)
    labels = box.labels(np.arange(50)).reshape(5, 10)
    assert (labels[1:3, 2:4] == UNKNOWN).all()
    assert (labels == UNKNOWN).sum() == 4
    assert (labels == BACKGROUND).sum() == 46


class Misled(OracleNetworks):
    """Knows the pose, but takes everything for the object."""

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        segmentation, coordinates = super().coordinates(points_canonical, neighborhoods)
        # A point of the background gets a coordinate at random: a fit that uses it is off.
        background = segmentation[-1] > 0.5
        coordinates[:, background] = np.random.default_rng(0).uniform(-0.5, 0.5, (1, int(background.sum()), 3))
        return np.eye(2, dtype=np.float32)[:, [0]].repeat(segmentation.shape[1], axis=1), coordinates


def test_mask_repairs_what_the_network_gets_wrong() -> None:
    category, truth, cloud = scene("mug", np.random.default_rng(3), count=3000)
    labels = np.full((1, len(cloud)), OBJECT, np.uint8)
    labels[0, 3000:] = BACKGROUND
    networks = Misled(category, truth, truth)
    alone = Tracker(networks, truth).step(cloud).evidence.parts[0]
    masked = Tracker(networks, truth).step(cloud, LabelImage(labels)).evidence.parts[0]
    assert alone.residual > 0.1
    assert masked.residual < 0.01
    assert masked.points < alone.points == networks.profile.points


@pytest.mark.parametrize("known", [1, OBJECT])
def test_pre_segmented_categories_are_cut_out_by_the_mask(known: int) -> None:
    depth = np.full((20, 20), 0.5, np.float32)
    labels = np.zeros((20, 20), np.uint8)
    labels[5:15, 5:15] = known
    whole = DepthImage(depth, 1.0, Intrinsics(20, 20, 9.5, 9.5)).whole()
    kept = without_background(whole, LabelImage(labels))
    assert len(kept) == 100
    assert (labels.reshape(-1)[kept.indices] == known).all()

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import CATEGORIES, Category, get_category
from captra.mirrors import ACROSS, MIRRORS, Answer, images_of

GLASSES, MUG = get_category("glasses"), get_category("mug")


class Asked:
    """A stand-in for CoordinateNet that keeps what it was asked."""

    def __init__(self, category: Category, bias: float = 0.0) -> None:
        self.category, self.bias = category, bias
        self.clouds = list[np.ndarray]()

    def __call__(self, points: np.ndarray) -> Answer:
        """Points right of the middle are the first part's, and all others the second's; a bias draws both to +x."""
        self.clouds.append(points)
        probability = np.zeros((self.category.num_classes, len(points)), np.float32)
        first = points[:, 0] < 0
        probability[0], probability[1] = first, ~first
        parts = np.arange(1, self.category.num_parts + 1)
        widths = parts if self.category is MUG else np.array([1, 1, 2])  # temples are alike
        coordinates = points * widths[:, None, None] + np.array([self.bias, 0, 0])
        return probability, coordinates.astype(np.float32)


def cloud(seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-0.5, 0.5, (50, 3)).astype(np.float32)


@given(st.integers(0, 9))
def test_an_answer_that_is_the_same_in_a_mirror_stays(seed: int) -> None:
    ask = Asked(GLASSES)
    for one, other in zip(MIRRORS["left-and-right"](ask, cloud(seed), GLASSES), ask(cloud(seed)), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-6)
    np.testing.assert_array_equal(ask.clouds[1], cloud(seed) * ACROSS)


@given(st.integers(0, 9), st.floats(-0.2, 0.2))
def test_what_differs_between_left_and_right_cancels(seed: int, bias: float) -> None:
    _, coordinates = MIRRORS["left-and-right"](Asked(GLASSES, bias), cloud(seed), GLASSES)
    np.testing.assert_allclose(coordinates, Asked(GLASSES)(cloud(seed))[1], atol=1e-6)


def test_classes_beyond_the_parts_are_their_own_image() -> None:
    segmentation, _ = MIRRORS["left-and-right"](Asked(MUG), cloud(0), MUG)
    assert segmentation.shape == (2, 50)
    np.testing.assert_allclose(segmentation, 0.5)  # the mug is always right of its background here


def test_without_a_mirror_the_cloud_is_asked_about_once() -> None:
    ask = Asked(GLASSES, 0.1)
    _, coordinates = MIRRORS["none"](ask, cloud(0), GLASSES)
    np.testing.assert_array_equal(coordinates, Asked(GLASSES, 0.1)(cloud(0))[1])
    assert len(ask.clouds) == 1


@pytest.mark.parametrize("name", CATEGORIES)
def test_right_is_the_image_of_left_and_all_else_of_itself(name: str) -> None:
    category = get_category(name)
    images = images_of(category)
    assert [images[image] for image in images] == list(range(category.num_parts))
    expected = {"glasses": (1, 0, 2), "scissors": (1, 0)}
    assert images == expected.get(name, tuple(range(category.num_parts)))

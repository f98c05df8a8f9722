import numpy as np
import pytest

from benchmarks.contact_sheet import drawn
from captra.data.shapes.registry import make_shape


@pytest.mark.parametrize(("category", "parts"), [("can", 1), ("drawers", 4)])
def test_an_instance_fills_the_middle_of_its_picture_in_one_hue_a_part(category: str, parts: int) -> None:
    rng = np.random.default_rng(3)
    image = drawn(make_shape(category, rng), rng)
    empty = (image == 1.0).all(-1)
    assert 0.1 < 1 - empty.mean() < 0.9
    border = np.concatenate([empty[0], empty[-1], empty[:, 0], empty[:, -1]])
    assert border.mean() > 0.9
    hues = image[~empty] / image[~empty].max(-1, keepdims=True)
    assert len(np.unique(hues.round(2), axis=0)) >= parts

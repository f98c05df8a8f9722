import numpy as np
import pytest
from scipy.spatial import cKDTree

from captra.data.contents import make_contents, settled
from captra.data.shapes import make_shape
from captra.data.shapes.mesh import merged
from captra.data.shapes.surfaces import box, superellipsoid


def test_things_are_lowered_until_they_touch() -> None:
    ground = box((1.0, 0.2, 1.0))
    ball = superellipsoid((0.1, 0.1, 0.1), 2.0, 24).moved(translation=np.array([0.1, 0.7, 0.0]))
    assert settled(ball, ground).bounds()[0, 1] == pytest.approx(0.1, abs=1e-5)
    plank = box((3.0, 0.1, 3.0)).moved(translation=np.array([0.0, 2.0, 0.0]))
    assert settled(plank, ground).bounds()[0, 1] == pytest.approx(0.1, abs=1e-5), "only corners of the ground touch it"
    beside = ball.moved(translation=np.array([5.0, 0, 0]))
    np.testing.assert_array_equal(settled(beside, ground).vertices, beside.vertices)


@pytest.mark.parametrize("category", ["bowl", "laptop"])
@pytest.mark.parametrize("seed", range(5))
def test_contents_lie_in_the_vessel(category: str, seed: int) -> None:
    rng = np.random.default_rng([2, seed])
    vessel = make_shape(category, rng).parts[0]
    things = make_contents(rng, vessel)
    assert things
    low = vessel.bounds()[0]
    assert merged(things).bounds()[0, 1] > low[1] - 0.02
    gap = cKDTree(merged([vessel, *things[1:]]).vertices).query(things[0].vertices)[0].min()
    assert gap < 0.08, "the first thing is near what it lies on"

"""What viewers are shown of a result."""

import numpy as np
import pytest

from captra.health import State
from captra.recording.foxglove import COLOURED, edges
from clients.results import PartPose, Result, Timing

SIZE = np.array([0.1, 0.2, 0.3])
QUARTER_ABOUT_Y = (0.0, float(np.sin(np.pi / 4)), 0.0, float(np.cos(np.pi / 4)))
CENTRES = ((1.0, 2.0, 3.0), (0.0, 0.0, 1.0))


def result(state: State) -> Result:
    parts = tuple(PartPose(f"part {i}", centre, QUARTER_ABOUT_Y, tuple(SIZE)) for i, centre in enumerate(CENTRES))
    return Result("s", 0, 20, "camera", state, 0.9, parts, (), Timing(0.0, 0.0, 0.0, 0.0, 0.0))


def test_edges_outline_every_box_where_it_is() -> None:
    points = np.frombuffer(edges(result(State.TRACKING))["data"], COLOURED)
    for centre, part in zip(CENTRES, points.reshape(len(CENTRES), -1), strict=True):
        x, y, z = (part[axis] - middle for axis, middle in zip("xyz", centre, strict=True))
        own = np.stack([-z, y, x], axis=1) / SIZE  # a quarter turn about y puts the box's x along -z, its z along x
        assert np.abs(own).max() == pytest.approx(0.5, abs=1e-5)
        at_side = np.isclose(np.abs(own), 0.5, atol=1e-5)
        assert (at_side.sum(axis=1) >= 2).all(), "a point beside the edges"
        assert len(np.unique(np.sign(own[at_side.all(axis=1)]), axis=0)) == 8, "a corner is missing"
        assert len({(tuple(side), *np.sign(point[side])) for side, point in zip(at_side, own, strict=True)}) == 12 + 8


@pytest.mark.parametrize(
    ("state", "colour"),
    [(State.TRACKING, (51, 204, 76)), (State.UNCERTAIN, (255, 178, 26)), (State.LOST, (230, 51, 51))],
)
def test_edges_have_the_colour_of_the_state(state: State, colour: tuple[int, ...]) -> None:
    points = np.frombuffer(edges(result(state))["data"], COLOURED)
    assert {tuple(int(point[name]) for name in ("red", "green", "blue", "alpha")) for point in points} == {
        (*colour, 255)
    }

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import CATEGORIES, get_category
from captra.evidence import Evidence
from captra.fronts import DOUBT, FASTEST, FURTHEST, behind_fronts
from captra.geometry import Pose, axis_angle
from captra.pose_memory import PoseMemory
from tests.captra.test_confidence import GOOD
from tests.oracle import box_surface, elsewhere

DRAWERS = get_category("drawers")
BASE = DRAWERS.root
SIZE = np.array([0.5, 0.2, 0.4])
NOTHING = PoseMemory.nothing_known(4)


def facing(yaw_rad: float) -> Pose:
    """Four boxes whose fronts are turned away from the camera by so much."""
    rotation = axis_angle(np.array([0.0, 1.0, 0.0]), np.pi + yaw_rad)
    translation = np.array([0.0, 0.0, 2.0]) + np.arange(-1.5, 2)[:, None] * [0.0, 0.25, 0.0]
    return Pose.from_size(np.tile(rotation, (4, 1, 1)), translation, np.tile(SIZE, (4, 1)))


def seen(pose: Pose, keep: float = -1.0, count: int = 4000, height: float = 1.0) -> Evidence:
    """Points on the surfaces of all parts, those further ahead than `keep` half depths, the lowest share `height`."""
    own = box_surface(SIZE, count, np.random.default_rng(0))
    own = own[(own[:, 2] >= keep * SIZE[2] / 2) & (own[:, 1] <= (height - 0.5) * SIZE[1])]
    parts = zip(pose.rotation, pose.translation, strict=True)
    return Evidence(tuple(replace(GOOD, explained=own @ R.T + t) for R, t in parts), 1.0, 4 * len(own))


def ahead(pose: Pose, by_m: float) -> Pose:
    return replace(pose, translation=pose.translation + by_m * pose.rotation[:, :, 2])


def remembering(by_m: float) -> PoseMemory:
    """Children are so much ahead of where they are found."""
    offset = np.zeros((4, 3))
    offset[CHILDREN, 2] = by_m
    return replace(NOTHING, offset_part=offset)


def children_ahead(pose: Pose, by_m: float) -> Pose:
    out = np.where(np.arange(4)[:, None] == BASE, 0.0, by_m * pose.rotation[:, :, 2])
    return replace(pose, translation=pose.translation + out)


CHILDREN = [slide.child for slide in DRAWERS.slides]
shifts = st.floats(-0.02, 0.02)


@given(shifts, shifts, st.floats(-0.8, 0.8))
def test_a_drawer_whose_front_is_seen_is_behind_it(by_m: float, before_m: float, yaw_rad: float) -> None:
    truth = facing(yaw_rad)
    found = children_ahead(truth, by_m)
    before = replace(NOTHING, offset_part=np.array([[0.01, 0.02, before_m]] * 3 + [[0.0, 0.0, 0.0]]))
    memory = behind_fronts(before, found, truth, seen(truth), DRAWERS)
    np.testing.assert_allclose(memory.offset_part[CHILDREN, 2], -by_m, atol=1e-6)
    np.testing.assert_allclose(memory.offset_part[:, :2], before.offset_part[:, :2])
    np.testing.assert_array_equal(memory.offset_part[BASE], before.offset_part[BASE])


@pytest.mark.parametrize(
    "far", [pytest.param(facing(0.2), id="as before"), pytest.param(elsewhere(facing(0.2)), id="moved")]
)
def test_a_front_where_the_drawer_last_was_is_believed_however_far_off_networks_find_it(far: Pose) -> None:
    found, last = children_ahead(facing(0.2), -0.1), far
    memory = behind_fronts(NOTHING, found, last, seen(facing(0.2)), DRAWERS)
    np.testing.assert_allclose(memory.offset_part[CHILDREN, 2], 0.1, atol=1e-6)
    lost = behind_fronts(NOTHING, found, children_ahead(far, -0.1), seen(facing(0.2)), DRAWERS)
    np.testing.assert_array_equal(lost.offset_part, NOTHING.offset_part)


@pytest.mark.parametrize("back", [0.5, 2.0])
def test_a_front_that_falls_back_all_at_once_is_followed_with_doubt(back: float) -> None:
    truth = facing(0.1)
    by_m = back * FASTEST * truth.scale[0]
    memory = behind_fronts(NOTHING, truth, children_ahead(truth, by_m), seen(truth), DRAWERS)
    expected = by_m * (1 - DOUBT) if back > 1 else 0.0
    np.testing.assert_allclose(memory.offset_part[CHILDREN, 2], expected, atol=1e-6)
    assert FURTHEST > 2 * FASTEST


@pytest.mark.parametrize(
    ("evidence", "found"),
    [
        pytest.param(seen(facing(3.0)), facing(3.0), id="seen from behind"),
        pytest.param(seen(facing(0.0), count=10), facing(0.0), id="hardly seen"),
        pytest.param(seen(ahead(facing(0.0), -0.2)), facing(0.0), id="ends far behind"),
        pytest.param(seen(facing(0.0), height=0.4), facing(0.0), id="mostly behind another"),
    ],
)
def test_what_no_front_tells_stays_as_it_was(evidence: Evidence, found: Pose) -> None:
    before = remembering(0.02)
    after = behind_fronts(before, children_ahead(found, 0.01), found, evidence, DRAWERS)
    np.testing.assert_array_equal(after.offset_part, before.offset_part)


def test_what_is_behind_the_front_need_not_be_seen() -> None:
    truth = facing(0.1)
    memory = behind_fronts(NOTHING, children_ahead(truth, 0.02), truth, seen(truth, keep=0.999), DRAWERS)
    np.testing.assert_allclose(memory.offset_part[:3, 2], -0.02, atol=1e-6)


@pytest.mark.parametrize("name", sorted(set(CATEGORIES) - {"drawers"}))
def test_nothing_else_has_fronts(name: str) -> None:
    category = get_category(name)
    parts = category.num_parts
    truth = facing(0.0)
    some = Pose(truth.rotation[:parts], truth.translation[:parts], truth.scale[:parts], truth.size[:parts])
    before = PoseMemory.nothing_known(parts)
    evidence = replace(seen(truth), parts=seen(truth).parts[:parts])
    after = behind_fronts(before, ahead(some, 0.02), some, evidence, category)
    np.testing.assert_array_equal(after.offset_part, before.offset_part)

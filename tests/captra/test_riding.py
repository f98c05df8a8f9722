from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.categories import Category, get_category
from captra.evidence import Evidence, PartEvidence, Ride
from captra.geometry import Pose, axis_angle, is_rotation
from captra.health import State
from captra.joint_projection import ALONG_AXES
from captra.metrics import rotation_error_deg
from captra.riding import FEW_POINTS, Standstill, carried, ride_along, rides
from captra.sampling import NoPointsError
from captra.tracker import Tracker, TrackResult
from tests.oracle import OracleNetworks, elsewhere, explaining, surfaces

DRAWERS, GLASSES, MUG = get_category("drawers"), get_category("glasses"), get_category("mug")
LAPTOP = get_category("laptop_articulated")


def pose(category: Category, seed: int = 0) -> Pose:
    """Parts anywhere and turned in any way."""
    rng, parts = np.random.default_rng(seed), category.num_parts
    rotation = axis_angle(rng.standard_normal((parts, 3)), rng.uniform(0, 3, parts))
    return Pose.from_size(rotation, rng.uniform(-0.3, 0.3, (parts, 3)), np.full((parts, 3), 0.1))


def with_part(whole: Pose, other: Pose, part: int) -> Pose:
    """One part as in another pose."""
    chosen = np.arange(whole.num_parts) == part
    rotation = np.where(chosen[:, None, None], other.rotation, whole.rotation)
    translation = np.where(chosen[:, None], other.translation, whole.translation)
    return replace(whole, rotation=rotation, translation=translation)


def ridden(found: Pose, evidence: Evidence, last: Pose, category: Category) -> Pose:
    """What was found, where parts ride as the evidence tells."""
    return ride_along(found, replace(evidence, rides=tuple(rides(found, evidence, category))), last, category)


def assert_same(one: Pose, other: Pose) -> None:
    np.testing.assert_allclose(one.rotation, other.rotation, atol=1e-9)
    np.testing.assert_allclose(one.translation, other.translation, atol=1e-9)


@given(st.integers(0, 9), st.sampled_from([0, 1]))
def test_an_unseen_temple_goes_where_its_front_takes_it(seed: int, hidden: int) -> None:
    last = pose(GLASSES, seed)
    points = [200 * (part != hidden) for part in range(3)]
    stayed = with_part(elsewhere(last), last, hidden)
    assert_same(ridden(stayed, explaining(*points), last, GLASSES), elsewhere(last))


@given(st.integers(0, 9))
def test_an_unseen_front_goes_where_the_temple_that_is_seen_best_takes_it(seed: int) -> None:
    last = pose(GLASSES, seed)
    found = with_part(last, elsewhere(last), 1)
    assert_same(ridden(found, explaining(5, 90, 0), last, GLASSES).part(2), elsewhere(last).part(2))


@given(st.integers(0, 9))
def test_a_drawer_counts_for_as_much_as_is_seen_of_it(seed: int) -> None:
    last = pose(DRAWERS, seed)
    pulled = with_part(last, replace(last, translation=last.translation + [0.0, 0.0, 0.1]), 1)
    after = [ridden(pulled, explaining(50, n, 50, 500), last, DRAWERS) for n in (4, FEW_POINTS, 30 * FEW_POINTS)]
    opened = [one.translation[1, 2] - last.translation[1, 2] for one in after]
    assert opened[0] < 0.02
    assert opened[1] == pytest.approx(0.05)
    assert opened[2] > 0.095


def test_a_turn_about_a_hinge_counts_likewise() -> None:
    last = pose(GLASSES)
    turned = replace(last, rotation=last.rotation @ axis_angle(np.array([0.0, 1.0, 0.0]), np.radians(20.0)))
    found = with_part(last, turned, 0)
    after = ridden(found, explaining(FEW_POINTS, 90, 500), last, GLASSES)
    assert rotation_error_deg(after.rotation, last.rotation, symmetric=False).round(6).tolist() == [10.0, 0.0, 0.0]


@pytest.mark.parametrize("points", [0, 3, 1000])
def test_an_object_of_one_part_goes_where_it_is_found(points: int) -> None:
    last = pose(MUG)
    assert_same(ridden(elsewhere(last), explaining(points), last, MUG), elsewhere(last))


@pytest.mark.parametrize("category", [DRAWERS, GLASSES, MUG])
@pytest.mark.parametrize("points", [0, 1])
def test_what_is_hidden_for_long_keeps_its_shape(category: Category, points: int) -> None:
    """Every frame starts from the pose of the one before, root and parts in turn from each other."""
    first = last = pose(category)
    hidden = explaining(*(points * (part != category.root) for part in range(category.num_parts)))
    for _ in range(500):
        last = ridden(last, hidden, last, category)
    assert is_rotation(last.rotation, tolerance=1e-9)
    np.testing.assert_allclose(last.translation, first.translation, atol=1e-6)


def test_who_rides_on_whom() -> None:
    glasses, mug = pose(GLASSES), pose(MUG)

    def riding(*points: int) -> list[Ride]:
        return list(rides(glasses, explaining(*points), GLASSES))

    assert riding(30, 10, 500) == [Ride(0, 2, 0, 0.5, 0.5), Ride(1, 2, 1, 0.25, 0.25)]
    assert riding(30, 90, 0) == [Ride(2, 1, 1, 0.0, 0.0), Ride(0, 2, 0, 0.5, 0.5)]
    assert riding(30, 90, 10) == [Ride(2, 1, 1, 0.25, 0.25), Ride(0, 2, 0, 0.5, 0.5)]
    assert riding(0, 0, 0) == [Ride(0, 2, 0, 0.0, 0.0), Ride(1, 2, 1, 0.0, 0.0)]
    assert list(rides(mug, explaining(0), MUG)) == []


def seen(whole: Pose, part: int, spread: np.ndarray, middle: np.ndarray, points: int = 600) -> PartEvidence:
    """Evidence of a part whose points lie so far to either side of a place in its own frame, metres."""
    own = middle + np.random.default_rng(0).uniform(-spread, spread, (points, 3))
    nothing = PartEvidence.missing(points, whole.translation[part])
    return replace(nothing, explained=own @ whole.rotation[part].T + whole.translation[part])


BOARD, FRONT_EDGE = np.array([0.15, 0.003, 0.1]), np.array([0.0, 0.0, 0.1])


def laptop(found: Pose, edge: int | None) -> Evidence:
    """Evidence of boards that are seen from above, but for one of which only the front edge is seen."""
    whole, line = (BOARD, np.zeros(3)), (BOARD * [1, 1, 0], FRONT_EDGE)
    return Evidence(tuple(seen(found, part, *(line if part == edge else whole)) for part in range(2)), 1.0, 1200)


@pytest.mark.parametrize("edge", [LAPTOP.root, 1])
def test_a_board_that_is_seen_from_its_edge_turns_with_the_other_about_that_edge(edge: int) -> None:
    """The many points along a line parallel to the hinge tell where the line is, but nothing of the turn about it."""
    about_hinge = np.array([1.0, 0.0, 0.0])
    base = pose(LAPTOP).rotation[0]
    last = replace(pose(LAPTOP), rotation=np.stack([base, base @ axis_angle(about_hinge, -1.8)]))
    turned = replace(last, rotation=last.rotation @ axis_angle(about_hinge, np.radians(20.0)))
    found = with_part(last, turned, 1 - edge)
    went, stayed = (ridden(found, laptop(found, seen_from), last, LAPTOP) for seen_from in (edge, None))
    middles = [one.translation[edge] + one.rotation[edge] @ FRONT_EDGE for one in (last, went)]
    assert np.linalg.norm(middles[1] - middles[0]) < 0.02
    relative = [one.rotation[edge].T @ one.rotation[1 - edge] for one in (last, went)]
    assert rotation_error_deg(*relative, symmetric=False) < 2.0
    assert rotation_error_deg(stayed.rotation, last.rotation, symmetric=False)[edge] < 2.0


def test_points_on_a_line_tell_of_a_slide_as_well_as_others() -> None:
    last = pose(DRAWERS)
    line = seen(last, 1, np.array([0.0, 0.0, 0.2]), np.zeros(3), points=30)  # along the slide
    parts = tuple(line if part == 1 else PartEvidence.missing(0, np.zeros(3)) for part in range(4))
    (ride,) = (one for one in rides(last, Evidence(parts, 1.0, 30), DRAWERS) if one.part == DRAWERS.root)
    assert (ride.by, ride.turned) == (1, 0.0)
    parts = tuple(line if part == 1 else seen(last, part, BOARD, np.zeros(3)) for part in range(4))
    (ride,) = (one for one in rides(last, Evidence(parts, 1.0, 1830), DRAWERS) if one.part == 1)
    assert ride.turned == ride.seen == 0.5


def judged(standstill: Standstill, category: Category, *points: int) -> Evidence:
    """Evidence of a frame that explains so many points of each part."""
    evidence = explaining(*points)
    return replace(evidence, rides=standstill.judged(rides(pose(category), evidence, category), category))


def test_how_long_a_hinge_was_taken_to_stand_still() -> None:
    standstill, lasted = Standstill.of(GLASSES), []
    for points in (0, 0, 30, 3000, 0):
        standstill = standstill.updated(judged(standstill, GLASSES, points, 5000, 5000), trusted=True)
        lasted.append(standstill.frames[0])
    np.testing.assert_allclose(lasted, [1, 2, 1.5, 2.5 * 30 / 3030, 1 + 2.5 * 30 / 3030])
    assert standstill.frames[1] < 0.01
    assert [ride.stood for ride in judged(Standstill.of(DRAWERS), DRAWERS, 0, 0, 0, 500).rides] == [0, 0, 0]


def test_a_hinge_is_not_told_by_the_other_part_being_hidden() -> None:
    standstill = Standstill.of(LAPTOP)
    for points in ((0, 900), (0, 900), (900, 0)):
        standstill = standstill.updated(judged(standstill, LAPTOP, *points), trusted=True)
    assert standstill.frames.tolist() == [3.0]


def test_a_frame_that_cannot_be_trusted_or_shows_nothing_tells_of_no_hinge() -> None:
    standstill = Standstill(np.array([5.0]))
    seen_well = judged(standstill, LAPTOP, 3000, 3000)
    assert standstill.updated(seen_well, trusted=False).frames.tolist() == [5.0]
    assert standstill.updated(seen_well, trusted=True).frames[0] < 0.1
    assert standstill.missed().frames.tolist() == [6.0]


def cabinet() -> Pose:
    """One drawer above the other, half a metre deep."""
    size = np.array([[0.4, 0.12, 0.5]] * 3 + [[0.5, 0.5, 0.5]])
    return Pose.from_size(np.tile(np.eye(3), (4, 1, 1)), np.array([[0, y, 1.3] for y in (-0.15, 0, 0.15, 0)]), size)


@pytest.mark.parametrize("start", [True, False])
def test_a_track_carries_a_drawer_that_is_hidden_after_it_was_given(start: bool) -> None:
    rng = np.random.default_rng(0)
    truth = replace(cabinet(), translation=cabinet().translation + np.array([[0, 0, 0.6]] * 3 + [[0, 0, 0]]))
    networks = OracleNetworks(DRAWERS, truth, truth)
    tracker = Tracker(networks, truth)
    cloud = surfaces(truth, 1500, rng)
    first = truth if start else tracker.step(cloud).pose
    shift = np.array([0.02, 0.0, 0.03])
    networks.truth = replace(truth, translation=truth.translation + shift)
    found = tracker.step(cloud[1500:] + shift.astype(np.float32)).pose
    went = found.translation[0] - first.translation[0]
    np.testing.assert_allclose(went, 0.0 if start else shift, atol=1e-9 if start else 0.006)


def test_a_track_of_which_a_temple_is_hidden_for_long_is_trusted_less_but_not_lost() -> None:
    rng, size = np.random.default_rng(0), np.array([[0.01, 0.03, 0.12], [0.01, 0.03, 0.12], [0.14, 0.04, 0.012]])
    centres = np.array([[-0.07, 0.0, 0.43], [0.07, 0.0, 0.43], [0.0, 0.0, 0.5]])
    truth = Pose.from_size(np.tile(np.eye(3), (3, 1, 1)), centres, size)
    networks = OracleNetworks(GLASSES, truth, truth)
    tracker = Tracker(networks, truth)

    def hidden_for(frames: int) -> TrackResult:
        """The last of so many frames without the right temple."""
        for _ in range(frames):
            networks.last = tracker.pose
            result = tracker.step(surfaces(truth, 800, rng)[800:])
        return result

    tracker.step(surfaces(truth, 800, rng))
    soon, late = hidden_for(1), hidden_for(39)
    assert [one.evidence.rides[0].stood for one in (soon, late)] == [1.0, 40.0]
    assert late.confidence < soon.confidence
    assert late.state is State.TRACKING
    tracker.reset(truth)
    tracker.step(surfaces(truth, 800, rng))
    assert hidden_for(1).evidence.rides[0].stood == 1.0
    with pytest.raises(NoPointsError):
        tracker.step(np.zeros((0, 3), np.float32))
    assert hidden_for(1).evidence.rides[0].stood == 3.0


@given(st.integers(0, 9), st.integers(0, 2))
def test_what_is_hidden_goes_with_what_most_is_seen_of(seed: int, hidden: int) -> None:
    last = pose(GLASSES, seed)
    leader = (hidden + 1) % 3
    seen = np.where(np.arange(3) == leader, 90, 9) * (np.arange(3) != hidden)
    found = with_part(last, elsewhere(last), leader)
    moved = carried(found, last, seen)
    assert_same(moved, with_part(found, elsewhere(last), hidden))
    assert_same(carried(found, last, np.full(3, 9)), found)


@pytest.mark.parametrize("name", ["drawers", "laptop_articulated"])
def test_a_root_of_which_nothing_is_seen_holds_nobody_back(name: str) -> None:
    """Only moving parts are in sight while the whole object is turned and carried away."""
    category = get_category(name)
    root, parts = category.root, category.num_parts
    rotation = axis_angle(np.array([0.2, 1.0, 0.1]), 2.9)
    translation = np.array([0.0, 0.0, 1.5]) + np.arange(parts)[:, None] * [0.0, 0.3, 0.0]
    truth = Pose.from_size(np.tile(rotation, (parts, 1, 1)), translation, np.tile([0.5, 0.25, 0.4], (parts, 1)))
    networks = OracleNetworks(category, truth, truth, joint_projection=ALONG_AXES)
    tracker = Tracker(networks, truth)
    cloud = surfaces(truth, 2000, np.random.default_rng(0))
    tracker.step(cloud)
    step = axis_angle(np.array([0.3, 0.2, 1.0]), np.radians(2.0))
    for _ in range(15):
        networks.last = tracker.pose
        networks.truth = replace(
            networks.truth,
            rotation=step @ networks.truth.rotation,
            translation=(networks.truth.translation - translation[0]) @ step.T + translation[0] + [0.01, 0.005, 0.0],
        )
        points = surfaces(networks.truth, 2000, np.random.default_rng(0)).reshape(parts, 2000, 3)
        tracker.step(np.delete(points, root, axis=0).reshape(-1, 3))
    found, true = tracker.pose, networks.truth
    assert rotation_error_deg(found.rotation, true.rotation, symmetric=False).max() < 1.5
    assert np.linalg.norm(found.translation - true.translation, axis=1).max() < 0.005

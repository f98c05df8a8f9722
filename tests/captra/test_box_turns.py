from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.box_turns import MOST_POINTS, BoxTurns
from captra.categories import Category, get_category
from captra.evidence import Evidence
from captra.geometry import Pose, axis_angle
from captra.pose_memory import NO_ERROR, FoundError, PoseMemory
from captra.tracker import Tracker
from tests.captra.test_confidence import GOOD
from tests.oracle import OracleNetworks

GLASSES, SCISSORS, DRAWERS = (get_category(name) for name in ("glasses", "scissors", "drawers"))
Y = np.array([0.0, 1.0, 0.0])
SIZE = np.array([0.02, 0.03, 0.14])
UNSURE = FoundError(rotation_deg=((0.5, 4.0, 0.5),))
ROUGH_DEG = 8.0


def temple(rng: np.random.Generator, count: int = 300) -> np.ndarray:
    """A thin one that splays by 7°: it lies across its box, which it touches on every side."""
    along = rng.uniform(-0.5, 0.5, count)
    along[:4] = -0.5, -0.5, 0.5, 0.5
    thin = np.array([0.15, 1.0, 0.02]) * rng.uniform(-0.5, 0.5, (count, 3))
    thin[:4, 0] = -0.075, 0.075, -0.075, 0.075
    return np.asarray((np.stack([0.85 * along, 0 * along, 0.98 * along], axis=1) + thin) * SIZE)


def pair(seed: int) -> Pose:
    """Both temples and a base, each somewhere else."""
    rng = np.random.default_rng(seed)
    rotation = axis_angle(rng.standard_normal((3, 3)), rng.uniform(0, 3, 3))
    return Pose.from_size(rotation, rng.uniform(-1, 1, (3, 3)), np.tile(SIZE, (3, 1)))


def turned(pose: Pose, degrees: float) -> Pose:
    return replace(pose, rotation=pose.rotation @ axis_angle(Y, np.radians(degrees)))


def seen(true: Pose, points_part: np.ndarray) -> Evidence:
    parts = [
        replace(GOOD, explained=points_part @ rotation.T + centre)
        for rotation, centre in zip(true.rotation, true.translation, strict=True)
    ]
    return Evidence(tuple(parts), 0.9, len(points_part))


def turns_deg(given_pose: Pose, found: Pose, evidence: Evidence, error: FoundError = UNSURE) -> np.ndarray:
    """About y, of every part, with nothing remembered of the given pose otherwise."""
    turns = BoxTurns.between(given_pose, found, GLASSES, error).updated(found, evidence)
    return np.asarray(np.degrees(turns.refine(PoseMemory.nothing_known(3), found.size).turn_part))


@given(st.integers(0, 20), st.floats(-5, 2))
def test_a_part_is_turned_to_where_it_fills_its_box(seed: int, off_deg: float) -> None:
    true = pair(seed)
    found = turned(true, off_deg)
    turn = turns_deg(turned(true, ROUGH_DEG), found, seen(true, temple(np.random.default_rng(seed))))
    np.testing.assert_allclose(turn[:, 1], -off_deg, atol=1.6)
    np.testing.assert_array_equal(turn[:, [0, 2]], 0)


def test_without_points_the_given_pose_and_the_networks_share_the_difference() -> None:
    true = pair(1)
    memory = PoseMemory.between(true, turned(true, 4), GLASSES, UNSURE)
    turns = BoxTurns.between(true, turned(true, 4), GLASSES, UNSURE)
    assert turns.refine(memory, true.size).turn_part.tolist() == memory.turn_part.tolist()


def test_networks_that_are_sure_are_left_alone() -> None:
    true = pair(2)
    found, evidence = turned(true, 5), seen(true, temple(np.random.default_rng(2)))
    sure = FoundError(rotation_deg=((0.5, 0.2, 0.5),))
    assert np.abs(turns_deg(true, found, evidence, sure)).max() < 0.8
    assert np.abs(turns_deg(true, found, evidence, NO_ERROR)).max() == 0


def test_few_points_or_points_that_are_not_the_parts_tell_nothing() -> None:
    true, rng = pair(3), np.random.default_rng(3)
    found = turned(true, 4)
    nothing = turns_deg(found, found, seen(true, temple(rng)[:10]))
    assert np.abs(nothing).max() == 0
    scattered = turns_deg(found, found, seen(true, rng.uniform(-0.3, 0.3, (300, 3))))
    assert np.abs(scattered).max() < 0.5


def test_both_ends_may_be_seen_in_frames_that_follow_each_other() -> None:
    true, rng = pair(4), np.random.default_rng(4)
    found, points = turned(true, 4), temple(rng)
    turns = BoxTurns.between(turned(true, ROUGH_DEG), found, GLASSES, UNSURE)
    for half in (points[points[:, 2] < 0], points[points[:, 2] >= 0]):
        turns = turns.updated(found, seen(true, half))
    turn = np.degrees(turns.refine(PoseMemory.nothing_known(3), found.size).turn_part[:, 1])
    np.testing.assert_allclose(turn, -4, atol=1.6)


def test_what_is_remembered_stays_small_and_changes_with_every_frame() -> None:
    true, rng = pair(5), np.random.default_rng(5)
    turns = BoxTurns.between(true, true, GLASSES)
    for _ in range(30):
        before, turns = turns, turns.updated(true, seen(true, temple(rng)))
        assert all(len(points) <= MOST_POINTS for points in turns.points_part)
        assert not np.array_equal(before.points_part[0][-1:], turns.points_part[0][-1:])
    assert len(turns.points_part[0]) == MOST_POINTS


@pytest.mark.parametrize(
    ("category", "axes"),
    [(GLASSES, (1, 1, 1)), (SCISSORS, (1, 1)), (DRAWERS, (None,) * 4)],
    ids=str,
)
def test_parts_on_either_side_of_a_hinge_are_asked_about_its_axis(
    category: Category, axes: tuple[int | None, ...]
) -> None:
    rng = np.random.default_rng(6)
    rotation = axis_angle(rng.standard_normal((len(axes), 3)), 1.0)
    pose = Pose.from_size(rotation, np.zeros((len(axes), 3)), np.full((len(axes), 3), 0.1))
    assert BoxTurns.between(pose, pose, category).axes == axes


def test_a_track_turns_temples_into_their_boxes() -> None:
    rng = np.random.default_rng(7)
    apart = np.array([[0.0, 0, 0], [0.3, 0, 0], [0, 0.3, 0]]) + [0.0, 0.0, 0.7]
    true = replace(pair(7), translation=apart)
    points = np.concatenate([temple(rng) @ R.T + t for R, t in zip(true.rotation, true.translation, strict=True)])
    guessed, rough = turned(true, 4), turned(true, ROUGH_DEG)
    networks = OracleNetworks(GLASSES, guessed, rough, found_error=UNSURE)
    tracker = Tracker(networks, rough)
    for _ in range(3):
        pose = tracker.step(points.astype(np.float32)).pose
    left = np.degrees(np.arccos((np.einsum("pij,pij->p", true.rotation, pose.rotation) - 1) / 2))
    assert left[:2].max() < 2.5

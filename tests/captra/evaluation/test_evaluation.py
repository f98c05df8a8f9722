from dataclasses import dataclass, replace

import numpy as np
import pytest

from captra.data.recordings import Recording
from captra.evaluation import observability, runner, summary, workers
from captra.evaluation.followers.served import Served
from captra.evaluation.response import response
from captra.evaluation.scoring import joint_errors, score
from captra.evaluation.sequences import Sequence
from captra.evaluation.table import response_table, table
from captra.geometry import Pose, axis_angle
from captra.looking import Networks
from tests.oracle import OracleNetworks, scene


def still_recording(category_name: str, frames: int = 4) -> Recording:
    category, truth, cloud = scene(category_name, np.random.default_rng(1))
    labels = np.zeros(len(cloud), np.uint8)
    return Recording(
        category=category,
        name=f"{category_name}__box__still",
        stamps_ns=np.arange(frames) * 33_000_000,
        clouds=(cloud,) * frames,
        labels=(labels,) * frames,
        rotation=np.stack([truth.rotation] * frames).astype(np.float32),
        translation=np.stack([truth.translation] * frames).astype(np.float32),
        size=truth.size.astype(np.float32),
        init=truth,
        joint_values=np.zeros((frames, len(category.joints)), np.float32),
    )


@dataclass(frozen=True)
class Held:
    """A sequence that is there already."""

    sequence: Sequence
    """The sequence."""

    @property
    def name(self) -> str:
        return self.sequence.recording.name

    def load(self) -> Sequence:
        return self.sequence


@dataclass(frozen=True, eq=False)
class Ready:
    """Networks that are there already."""

    networks: Networks
    """The networks."""

    def load(self) -> Networks:
        return self.networks


def moved(pose: Pose, degrees: float, centimetres: float) -> Pose:
    turn = axis_angle(np.array([1.0, 0, 0]), np.radians(degrees))
    return replace(pose, rotation=pose.rotation @ turn, translation=pose.translation + [0, 0, centimetres / 100])


def test_errors_come_out_in_degrees_centimetres_and_shares() -> None:
    recording = still_recording("camera")
    truth = recording.truth(0)
    found = score(recording, [truth, moved(truth, 4, 3), moved(truth, 6, 0)])
    np.testing.assert_allclose(found.rotation_deg[:, 0], [0, 4, 6], atol=1e-3)
    np.testing.assert_allclose(found.translation_cm[:, 0], [0, 3, 0], atol=1e-3)
    np.testing.assert_array_equal(found.within_5deg_5cm[:, 0], [True, True, False])
    assert found.iou[0, 0] == pytest.approx(1, abs=1e-3)
    row = summary.summarize(found)
    assert row.within_5deg_5cm_percent == pytest.approx(200 / 3)
    assert row.joint_deg is None
    assert row.joint_cm is None
    assert (row.frames, row.symmetric_frames) == (3, 0)


def test_the_first_frame_is_not_scored() -> None:
    recording = still_recording("camera")
    with pytest.raises(ValueError, match="give 3 poses"):
        score(recording, [recording.truth(0)] * 4)


def test_joint_errors_of_hinges_and_slides() -> None:
    for name, expected in (("laptop_articulated", 5.0), ("drawers", 2.0)):
        recording = still_recording(name)
        truth = recording.truth(0)
        joint = recording.category.joints[0]
        rotation, translation = truth.rotation.copy(), truth.translation.copy()
        if joint.kind == "revolute":
            relative = rotation[joint.parent].T @ rotation[joint.child]
            axis = np.array(
                [relative[2, 1] - relative[1, 2], relative[0, 2] - relative[2, 0], relative[1, 0] - relative[0, 1]]
            )
            rotation[joint.child] = rotation[joint.child] @ axis_angle(axis, np.radians(5))
        else:
            translation[joint.child] += 0.02 * rotation[joint.parent] @ np.array(joint.axis)
        errors = joint_errors(replace(truth, rotation=rotation, translation=translation), truth, recording)
        assert errors[0] == pytest.approx(expected, abs=1e-2)


def test_a_mug_without_visible_handle_is_scored_as_symmetric() -> None:
    recording = still_recording("mug")
    truth = replace(recording.truth(0), size=np.array([[0.12, 0.1, 0.08]]))
    body = np.array([[-0.06 + 0.08, 0, 0]]).repeat(100, axis=0)
    handle = np.array([[0.055, 0, 0]]).repeat(20, axis=0)
    own = np.concatenate([body, handle]) @ truth.rotation[0].T + truth.translation[0]
    labels = np.zeros(120, np.uint8)
    assert observability.handle_points(own, labels, truth) == 20
    assert observability.handle_points(own[:100], labels[:100], truth) == 0
    assert observability.handle_points(own, labels + 1, truth) == 0


@pytest.mark.parametrize(("name", "expected"), [("bottle", True), ("camera", False)])
def test_symmetric_frames_follow_the_category(name: str, expected: bool) -> None:
    assert (observability.symmetric_frames(still_recording(name)) == expected).all()


def test_perfect_networks_track_perfectly() -> None:
    recording = still_recording("can")
    truth = recording.truth(0)
    sources = [Held(Sequence(recording, (truth.size[:1] / 2,)))]
    (outcome,) = runner.evaluate(Ready(OracleNetworks(recording.category, truth, truth)), sources, workers.Here())
    found = outcome.score
    assert found.within_ad10.all()
    assert found.within_5deg_5cm.all()
    assert found.iou.min() > 0.9


def test_frames_without_points_keep_the_last_pose() -> None:
    recording = still_recording("camera")
    truth = recording.truth(0)
    clouds = (*recording.clouds[:2], recording.clouds[0] + np.float32(9), recording.clouds[3])
    sequence = Sequence(replace(recording, clouds=clouds), ())
    poses = Served()(OracleNetworks(recording.category, truth, truth), sequence).poses
    assert poses[1] is poses[0]


def test_response_of_networks_that_never_react_is_one() -> None:
    recording = still_recording("camera")

    class Deaf(OracleNetworks):
        def rotations(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
            identity = np.array([1, 0, 0, 0, 1, 0], np.float32)
            return np.broadcast_to(identity, (1, points_canonical.shape[1], 6))

    truth = recording.truth(0)
    answers = response(Deaf(recording.category, truth, truth), recording, every=2)
    assert [answer.axis for answer in answers] == ["x", "y", "z"]
    assert all(answer.median_left == pytest.approx(1, abs=0.02) for answer in answers)


def test_tables_hold_every_row() -> None:
    recording = still_recording("camera")
    rows = [summary.summarize(score(recording, [recording.truth(0)] * 3))] * 2
    rows.append(summary.average("camera: mean of 2", rows))
    assert table(rows, "scores").row_count == 3
    assert summary.markdown(rows).count("\n") == 4
    assert summary.as_json(rows)[0]["within_5deg_5cm_percent"] == 100
    truth = recording.truth(0)
    responses = response(OracleNetworks(recording.category, truth, truth), recording, every=3)
    assert response_table("camera", responses).row_count == 3
    with pytest.raises(ValueError, match="nothing to average"):
        summary.average("none", [])

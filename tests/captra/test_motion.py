import numpy as np
import pytest

from captra.geometry import Pose, axis_angle, rotation_angle
from captra.motion import STANDING_STILL, ConstantVelocity

SIZE = np.full((2, 3), 0.1)
Z = np.array([0.0, 0.0, 1.0])


def at(time_s: float, speed: float = 0.3, spin: float = 1.0) -> Pose:
    rotation = np.tile(axis_angle(Z, spin * time_s), (2, 1, 1))
    return Pose.from_size(rotation, np.array([[speed * time_s, 0, 0.5], [speed * time_s, 0.2, 0.5]]), SIZE)


def followed(model: ConstantVelocity, frames: int, period_s: float) -> ConstantVelocity:
    model = model.restarted(at(0))
    for frame in range(frames):
        model = model.observed(at(frame * period_s), frame * period_s, trusted=True)
    return model


def test_an_object_that_stands_still_is_expected_where_it_was() -> None:
    pose = at(1.0)
    model = STANDING_STILL.restarted(at(0)).observed(pose, 1.0, trusted=True)
    assert model.expected(2.0) is pose


@pytest.mark.parametrize("period_s", [1 / 30, 1 / 10])
def test_steady_motion_is_foreseen_whatever_the_rate(period_s: float) -> None:
    model = followed(ConstantVelocity(damping=1.0), 10, period_s)
    expected, truth = model.expected(10 * period_s), at(10 * period_s)
    np.testing.assert_allclose(expected.translation, truth.translation, atol=1e-9)
    assert rotation_angle(np.swapaxes(truth.rotation, -1, -2) @ expected.rotation).max() < 1e-6


def test_a_skipped_frame_is_made_up_for() -> None:
    model = followed(ConstantVelocity(damping=1.0), 5, 0.1)
    np.testing.assert_allclose(model.expected(0.6).translation, at(0.6).translation, atol=1e-9)


def test_damping_holds_back() -> None:
    model = followed(ConstantVelocity(damping=0.5), 5, 0.1)
    assert model.expected(0.5).translation[0, 0] == pytest.approx(at(0.45).translation[0, 0])


def test_a_pose_that_is_not_trusted_ends_the_velocity() -> None:
    model = followed(ConstantVelocity(), 5, 0.1).observed(at(0.5), 0.5, trusted=False)
    np.testing.assert_array_equal(model.expected(0.6).translation, at(0.5).translation)


def test_after_a_long_pause_nothing_is_foreseen() -> None:
    model = followed(ConstantVelocity(), 5, 0.1)
    np.testing.assert_array_equal(model.expected(5.0).translation, at(0.4).translation)


def test_without_stamps_frames_count() -> None:
    model = ConstantVelocity(damping=1.0).restarted(at(0))
    for frame in range(4):
        model = model.observed(at(0.1 * frame), None, trusted=True)
    assert model.expected(None).translation[0, 0] > at(0.3).translation[0, 0]


def test_a_given_pose_is_at_rest() -> None:
    model = followed(ConstantVelocity(), 5, 0.1).restarted(at(2.0))
    np.testing.assert_array_equal(model.expected(2.1).translation, at(2.0).translation)
    with pytest.raises(ValueError, match="restarted"):
        ConstantVelocity().expected(1.0)

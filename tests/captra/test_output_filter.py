import numpy as np

from captra.geometry import Pose, axis_angle, rotation_angle
from captra.output_filter import UNFILTERED, OneEuro, OutputFilter

X = np.array([1.0, 0.0, 0.0])


def pose(x: float, angle: float = 0.0, side: float = 0.1) -> Pose:
    return Pose.from_size(axis_angle(X, angle)[None], np.array([[x, 0, 0.5]]), np.full((1, 3), side))


def run(smoother: OutputFilter, poses: list[Pose], rate_hz: float = 30.0) -> list[Pose]:
    out = []
    for index, one in enumerate(poses):
        smooth, smoother = smoother.filtered(one, index / rate_hz)
        out.append(smooth)
    return out


def test_nothing_is_changed_by_default() -> None:
    poses = [pose(0.0), pose(1.0)]
    assert run(UNFILTERED, poses) == poses


def test_jitter_at_rest_shrinks() -> None:
    rng = np.random.default_rng(0)
    noisy = [pose(*rng.normal(0, [0.002, 0.02])) for _ in range(200)]
    smooth = run(OneEuro(), noisy)[50:]
    assert np.std([one.translation[0, 0] for one in smooth]) < 0.5 * 0.002
    assert np.mean([rotation_angle(one.rotation[0]) for one in smooth]) < 0.5 * 0.02


def test_fast_motion_hardly_lags() -> None:
    smooth = run(OneEuro(), [pose(0.5 * i / 30) for i in range(60)])
    assert 0 <= 0.5 * 59 / 30 - smooth[-1].translation[0, 0] < 0.03


def test_the_first_pose_after_a_restart_and_every_size_pass() -> None:
    _, smoother = OneEuro().filtered(pose(0.0), 0.0)
    changed, _ = smoother.filtered(pose(0.1, side=0.2), 1 / 30)
    assert changed.size[0, 0] == 0.2
    assert changed.translation[0, 0] < 0.1
    fresh, _ = smoother.restarted().filtered(pose(1.0), 1 / 30)
    assert fresh.translation[0, 0] == 1.0


def test_a_stamp_that_does_not_advance_starts_again() -> None:
    _, smoother = OneEuro().filtered(pose(0.0), 1.0)
    same, _ = smoother.filtered(pose(0.3), 1.0)
    assert same.translation[0, 0] == 0.3

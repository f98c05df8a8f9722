from pathlib import Path

import numpy as np
import pytest

from captra.data.recordings import Recording, load_recording, save_recording
from captra.data.sequences import FRAMES_PER_SECOND, Motion, make_sequence, smooth_walk
from captra.data.shapes import make_shape
from captra.geometry import rotation_angle


def sequence(motion: Motion, seed: int = 0, frames: int = 8) -> Recording:
    return make_sequence(make_shape("mug", np.random.default_rng(3)), seed, frames, motion)


@pytest.mark.parametrize("motion", ["hand", "table", "alone"])
def test_sequences_are_smooth_start_perturbed_and_survive_the_disk(motion: Motion, tmp_path: Path) -> None:
    recording = sequence(motion)
    assert len(recording) == 8
    np.testing.assert_array_equal(np.diff(recording.stamps_ns), 1_000_000_000 // FRAMES_PER_SECOND)
    speed = np.linalg.norm(np.diff(recording.translation[:, 0], axis=0), axis=1) * FRAMES_PER_SECOND
    turns = np.swapaxes(recording.rotation[:-1, 0], -1, -2) @ recording.rotation[1:, 0]
    assert 0 < speed.max() < 1.0
    assert np.degrees(rotation_angle(turns)).max() * FRAMES_PER_SECOND < 120
    assert all((labels == 0).sum() >= 40 for labels in recording.labels)
    offset = np.linalg.norm(recording.init.translation - recording.truth(0).translation)
    assert 0 < offset < 0.2
    save_recording(tmp_path / "s.npz", recording)
    read = load_recording(tmp_path / "s.npz")
    assert read.category == recording.category
    np.testing.assert_allclose(read.clouds[3], recording.clouds[3], atol=0.51e-4)
    np.testing.assert_array_equal(read.rotation, recording.rotation)


def test_the_same_seed_makes_the_same_sequence() -> None:
    first, again, other = sequence("hand", frames=3), sequence("hand", frames=3), sequence("hand", seed=1, frames=3)
    np.testing.assert_array_equal(first.clouds[2], again.clouds[2])
    np.testing.assert_array_equal(first.init.rotation, again.init.rotation)
    assert not np.array_equal(first.translation, other.translation)


def test_a_standalone_object_is_seen_perfectly_and_with_nothing_around_it() -> None:
    recording = make_sequence(make_shape("glasses", np.random.default_rng(3)), 2, 4, "alone")
    for cloud, labels, truth in zip(recording.clouds, recording.labels, map(recording.truth, range(4)), strict=True):
        assert labels.max() < truth.num_parts
        for part in range(truth.num_parts):
            own = (cloud[labels == part] - truth.translation[part]) @ truth.rotation[part]
            assert (np.abs(own) <= truth.size[part] / 2 + 5e-4).all()
    assert np.ptp(recording.translation[:, 0], axis=0).max() > 1e-3


def test_walks_start_at_zero_and_peak_at_the_given_speed() -> None:
    path = smooth_walk(np.random.default_rng(0), 100, 3, 0.3)
    np.testing.assert_array_equal(path[0], 0)
    speed = np.linalg.norm(np.diff(path, axis=0), axis=1) * FRAMES_PER_SECOND
    assert speed.max() == pytest.approx(0.3)
    acceleration = np.linalg.norm(np.diff(path, 2, axis=0), axis=1) * FRAMES_PER_SECOND**2
    assert acceleration.max() < 5 * 0.3 * 2 * np.pi * 0.7


@pytest.mark.parametrize(
    ("category", "motion"), [("bowl", "hand"), ("can", "table"), ("camera", "hand"), ("laptop", "table")]
)
def test_every_rigid_category_can_be_filmed(category: str, motion: Motion) -> None:
    recording = make_sequence(make_shape(category, np.random.default_rng(3)), 1, 3, motion)
    assert recording.category.name == category
    assert all((labels == 0).sum() >= 40 for labels in recording.labels)
    for frame, cloud in enumerate(recording.clouds):
        own = (cloud[recording.labels[frame] == 0] - recording.translation[frame, 0]) @ recording.rotation[frame, 0]
        beyond = np.abs(own) - recording.size[0] / 2
        assert np.quantile(beyond.max(1), 0.9) < 0.012

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from captra.data.recordings import RecordingError, load_recording, save_recording

BUNDLED = sorted((Path(__file__).parents[3] / "recordings").glob("*.npz"))
MUG = next(path for path in BUNDLED if "coffee-mug" in path.name)


@pytest.mark.parametrize("path", BUNDLED, ids=lambda path: path.stem)
def test_bundled_recordings_survive_a_round_trip_bit_for_bit(path: Path, tmp_path: Path) -> None:
    recording = load_recording(path)
    copy = tmp_path / path.name
    save_recording(copy, recording)
    with np.load(path) as given, np.load(copy) as written:
        assert set(given.files) == set(written.files)
        for name in given.files:
            assert given[name].dtype == written[name].dtype, name
            np.testing.assert_array_equal(given[name], written[name], err_msg=name)


def test_a_recording_is_read_as_it_was_taken() -> None:
    recording = load_recording(MUG)
    assert recording.name == MUG.stem
    assert recording.category.name == "mug"
    assert len(recording) == len(recording.labels) == len(recording.stamps_ns) == 60
    assert recording.clouds[0].dtype == np.float32
    assert len(recording.clouds[7]) == len(recording.labels[7])
    truth = recording.truth(0)
    distance = np.linalg.norm(recording.clouds[0] - truth.translation[0], axis=1)
    assert distance.max() < 0.5, "metres, around the object"
    own = (recording.clouds[0] - truth.translation[0]) @ truth.rotation[0]
    inside = (np.abs(own) < truth.size[0] / 2 + 0.005).all(axis=1)
    assert inside[recording.labels[0] == 0].mean() > 0.95
    assert np.linalg.norm(recording.init.translation - truth.translation) < 0.15
    np.testing.assert_allclose(recording.init.scale, np.linalg.norm(recording.init.size, axis=1))


def test_a_file_that_is_no_recording_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "odd.npz"
    np.savez(path, points=np.zeros((2, 3)))
    with pytest.raises(RecordingError, match="offsets"):
        load_recording(path)
    with pytest.raises(FileNotFoundError):
        load_recording(tmp_path / "none.npz")


def changed(path: Path, **arrays: np.ndarray) -> Path:
    """The mug's recording with other arrays."""
    with np.load(MUG) as stored:
        np.savez(path, allow_pickle=False, **{**stored, **arrays})
    return path


UNLIKE: dict[str, tuple[dict[str, np.ndarray], str]] = {
    "stamps": ({"stamp_ns": np.arange(55)}, r"offsets is int64 \(61,\), where 55 stamps.* want numbers \(56,\)"),
    "labels": ({"labels": np.zeros(7, np.uint8)}, r"labels is uint8 \(7,\)"),
    "points": ({"points": np.zeros(7, np.int16)}, r"points is int16 \(7,\)"),
    "parts": ({"size": np.ones((2, 3))}, r"size is float64 \(2, 3\), where .* 1 part\(s\) want numbers \(1, 3\)"),
    "truth": ({"rotation": np.zeros((59, 1, 3, 3))}, r"rotation is float64 \(59, 1, 3, 3\)"),
    "joints": ({"joint_values": np.zeros(60)}, r"joint_values is float64 \(60,\)"),
    "words": ({"init_size": np.full((1, 3), "a")}, r"init_size is <U1 \(1, 3\)"),
    "offsets": ({"offsets": np.arange(61)}, r"offsets do not rise from 0 to its \d+ points"),
    "first pose": ({"init_translation": np.full((1, 3), np.nan)}, r"the pose to begin with holds NaN"),
}


@pytest.mark.parametrize("case", UNLIKE)
def test_arrays_that_do_not_go_together_are_refused(case: str, tmp_path: Path) -> None:
    arrays, why = UNLIKE[case]
    with pytest.raises(RecordingError, match=rf"mug__odd\.npz is no recording: {why}.*; record or download it again"):
        load_recording(changed(tmp_path / "mug__odd.npz", **arrays))


@pytest.mark.parametrize("at", [0.25, 0.5, 0.75])
def test_a_bit_that_flipped_is_told(at: float, tmp_path: Path) -> None:
    path, content = tmp_path / MUG.name, bytearray(MUG.read_bytes())
    content[int(at * len(content))] ^= 16
    path.write_bytes(content)
    with pytest.raises(RecordingError, match=r"no recording: it is not an \.npz archive, or damaged; record or"):
        load_recording(path)


def test_nothing_is_left_behind_by_saving(tmp_path: Path) -> None:
    save_recording(tmp_path / "again.npz", load_recording(BUNDLED[0]))
    assert [path.name for path in tmp_path.iterdir()] == ["again.npz"]


def test_reading_recordings_and_views_needs_numpy_alone() -> None:
    code = (
        "import sys, captra.data.recordings, captra.data.dataset;"
        "print([name for name in ('torch', 'scipy', 'trimesh', 'embreex') if name in sys.modules])"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert answer.stdout.strip() == "[]"

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh

from captra.cli import main
from captra.data.recordings import load_recording, save_recording
from captra.data.shapes.shape import Shape
from captra.data.shapes.surfaces import box
from captra.evaluation.model_points import from_recording, from_shape
from captra.evaluation.sequence_cache import VERSIONS_KEPT, SequenceCache, generator_version
from captra.evaluation.sequences import SequenceSource, library, procedural, recordings_in, standalone
from captra.evaluation.workers import workers

BUNDLED = Path(__file__).parents[3] / "recordings"


def test_a_sequence_is_simulated_once(tmp_path: Path) -> None:
    cache = SequenceCache.open(tmp_path)
    first, second = procedural("mug", 2, cache, frames=3)
    assert (first.name, second.name) == ("mug__procedural-900000__table", "mug__procedural-900001__hand")
    made = first.load()
    (path,) = tmp_path.rglob("*.npz")
    written = path.stat().st_mtime_ns
    again = first.load()
    assert path.stat().st_mtime_ns == written
    np.testing.assert_array_equal(again.recording.clouds[2], made.recording.clouds[2])
    np.testing.assert_array_equal(again.model[0], made.model[0])
    assert (again.recording.name, len(again.recording)) == (first.name, 3)
    longer = replace(first, frames=4)
    assert len(longer.load().recording) == 4


def test_standalone_sequences_show_the_same_instances_without_what_is_around_them(tmp_path: Path) -> None:
    cache = SequenceCache.open(tmp_path)
    (_, among), (_, alone) = procedural("glasses", 2, cache, frames=2), standalone("glasses", 2, cache, frames=2)
    assert (among.name, alone.name) == ("glasses__procedural-900001__hand", "glasses__procedural-900001__alone")
    np.testing.assert_array_equal(alone.load().model[0], among.load().model[0])
    assert len(alone.load().recording) == 2
    assert not list(standalone("can", 2, cache))


def test_another_generator_or_shape_makes_other_sequences(tmp_path: Path) -> None:
    (tmp_path / "data" / "shapes").mkdir(parents=True)
    (tmp_path / "data" / "shapes" / "mug.py").write_text("width = 1\n")
    before = generator_version(tmp_path)
    assert generator_version(tmp_path) == before
    (tmp_path / "data" / "shapes" / "mug.py").write_text("width = 2\n")
    assert generator_version(tmp_path) != before


def test_sequences_of_versions_long_gone_are_removed(tmp_path: Path) -> None:
    for index in range(5):
        key = tmp_path / f"{index:016x}" / "0123456789abcdef-900000-100"
        key.mkdir(parents=True)
        (key / "mug__procedural-900000__table.npz").touch()
        (key / ".mug__procedural-900000__table.npz.4711").touch()
    cache = SequenceCache.open(tmp_path)
    left = [path.name for path in tmp_path.iterdir()]
    assert len(left) == VERSIONS_KEPT
    assert cache.version in left


OF_OTHERS = (
    "views/mug/train/seed-0001_shard-00000/points.npy",
    "runs/mug/run/state.pt",
    ".git/HEAD",
    "version-1/0123456789abcdef-900000-100/mug__procedural-900000__table.npz",
    "0000000000000001/notes.txt",
    "0000000000000002/0123456789abcdef-900000-100/notes.txt",
    "0000000000000003/0123456789abcdef-900000-100/more/mug__procedural-900000__table.npz",
    "0000000000000004/photos/mug__procedural-900000__table.npz",
    "00000000000000055/0123456789abcdef-900000-100/mug__procedural-900000__table.npz",
)


def test_what_is_not_the_caches_own_stays(tmp_path: Path) -> None:
    for name in OF_OTHERS:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("dear to somebody")
    linked = tmp_path / "0000000000000006"
    linked.symlink_to(tmp_path / "views", target_is_directory=True)
    SequenceCache.open(tmp_path)
    assert [name for name in OF_OTHERS if not (tmp_path / name).is_file()] == []
    assert linked.is_dir()


@pytest.mark.parametrize("command", ["evaluate", "fuse"])
def test_nothing_is_touched_where_there_is_no_model(command: str, tmp_path: Path) -> None:
    versions = {f"{index:016x}" for index in range(3)}
    for version in versions:
        (tmp_path / "cache" / version).mkdir(parents=True)
    with pytest.raises(SystemExit):
        main([command, "--models", str(tmp_path), "--cache", str(tmp_path / "cache")])
    assert {path.name for path in (tmp_path / "cache").iterdir()} == versions


def write_library(folder: Path) -> None:
    index = {}
    for name, use in (("can/train_me", "train"), ("can/spare_me", "validate")):
        path = folder / f"{name}.ply"
        path.parent.mkdir(parents=True, exist_ok=True)
        mesh = box((0.07, 0.12, 0.07))
        trimesh.Trimesh(mesh.vertices, mesh.faces).export(path)
        index[name] = {"use": use, "licence": "CC0", "notes": ""}
    (folder / "INDEX.json").write_text(json.dumps(index))


def test_library_objects_are_filmed_in_both_motions(tmp_path: Path) -> None:
    write_library(tmp_path / "meshes")
    sources = list(library(tmp_path / "meshes", "can", SequenceCache.open(tmp_path / "cache"), frames=2))
    assert [source.name for source in sources] == ["can__spare_me__table", "can__spare_me__hand"]
    sequence = sources[0].load()
    assert len(sequence.recording) == 2
    np.testing.assert_allclose(np.ptp(sequence.model[0], axis=0), sequence.recording.size[0], rtol=0.03)


def test_sequences_can_be_loaded_by_other_processes(tmp_path: Path) -> None:
    sources = list(procedural("can", 2, SequenceCache.open(tmp_path), frames=2))
    with workers(2) as pool:
        names = list(pool.map(_name, sources))
    assert names == [source.name for source in sources]


def _name(source: SequenceSource) -> str:
    return source.load().recording.name


def test_what_a_recording_shows_is_its_objects_surface() -> None:
    (source,) = recordings_in(BUNDLED, "mug")
    sequence = source.load()
    recording = load_recording(source.path)
    (points,) = sequence.model
    np.testing.assert_array_equal(points, from_recording(recording)[0])
    assert np.quantile(np.abs(points), 0.98, axis=0) == pytest.approx(recording.size[0] / 2, abs=0.01)


def test_the_surface_of_a_shape_is_covered_evenly() -> None:
    empty = np.zeros((0, 3), np.float32), np.zeros((0, 2), np.float32)
    mesh = box((0.1, 0.2, 0.4)).moved(translation=np.array([1.0, 0, 0]))
    (points,) = from_shape(Shape("can", (mesh,), *empty), count=20_000)
    on_ends = np.abs(np.abs(points[:, 2]) - 0.2) < 1e-5
    assert on_ends.mean() == pytest.approx(0.02 / (0.02 + 0.04 + 0.08), abs=0.01)
    assert (np.abs(points) <= [0.0501, 0.1001, 0.2001]).all()


def test_a_recorded_object_is_looked_up_in_the_library(tmp_path: Path) -> None:
    write_library(tmp_path / "meshes")
    sequence = next(library(tmp_path / "meshes", "can", SequenceCache.open(tmp_path / "cache"), frames=2)).load()
    save_recording(tmp_path / "can__spare_me__table.npz", sequence.recording)
    (found,) = recordings_in(tmp_path, "can", tmp_path / "meshes")
    np.testing.assert_allclose(found.load().model[0], sequence.model[0], atol=1e-6)

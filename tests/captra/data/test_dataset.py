import json
from pathlib import Path

import numpy as np
import pytest

from captra.data.dataset import ViewDataset, pack, read_shard, write_shard
from captra.data.generate import generate
from captra.data.generation import OtherViewsError, generate_views, write_sources
from captra.data.shapes import make_shape
from captra.data.view import View
from captra.data.views import ViewOptions

FEW = ViewOptions(max_rays=4_000, points=(200, 400), least_object_points=5)


def fill(folder: Path, count: int = 5, seed: int = 1) -> None:
    generate_views("mug", count, seed, folder, lambda rng: make_shape("mug", rng), FEW, views_per_shard=2)


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*.npy"))}


def test_generation_is_deterministic_and_resumable(tmp_path: Path) -> None:
    whole, resumed = tmp_path / "whole", tmp_path / "resumed"
    fill(whole)
    fill(resumed, count=2)
    untouched = (resumed / "seed-0001_shard-00000" / "points.npy").stat().st_mtime_ns
    (resumed / ".seed-0001_shard-00001.123").mkdir()  # what a killed process leaves behind
    fill(resumed)
    assert (resumed / "seed-0001_shard-00000" / "points.npy").stat().st_mtime_ns == untouched
    assert contents(whole) == contents(resumed)
    assert len(ViewDataset(resumed)) == 5


def test_a_shard_cut_short_is_made_whole(tmp_path: Path) -> None:
    fill(tmp_path, count=1)
    fill(tmp_path, count=2)
    assert len(ViewDataset(tmp_path)) == 2


def test_seeds_add_views_without_moving_those_found_before(tmp_path: Path) -> None:
    fill(tmp_path, count=2, seed=2)
    dataset = ViewDataset(tmp_path)
    first = dataset[0]
    fill(tmp_path, count=3, seed=1)
    assert len(dataset) == 2
    assert dataset.refresh() == 5
    np.testing.assert_array_equal(dataset[0].points, first.points)
    assert len(list(dataset)) == 5


def test_several_folders_make_one_collection(tmp_path: Path) -> None:
    fill(tmp_path / "mug", count=3)
    fill(tmp_path / "can", count=2)
    dataset = ViewDataset(tmp_path / "mug", tmp_path / "can")
    assert len(dataset) == 5, "shards of the same name in two folders are two shards"
    np.testing.assert_array_equal(dataset[3].points, ViewDataset(tmp_path / "can")[0].points)


def test_an_index_beyond_the_end_is_refused(tmp_path: Path) -> None:
    fill(tmp_path, count=2)
    with pytest.raises(IndexError, match="refresh"):
        ViewDataset(tmp_path)[2]


def test_an_empty_folder_has_no_views(tmp_path: Path) -> None:
    assert len(ViewDataset(tmp_path)) == 0


def view(count: int) -> View:
    rng = np.random.default_rng(count)
    return View(
        points=rng.uniform(-1, 2, (count, 3)).astype(np.float32),
        labels=rng.integers(0, 3, count).astype(np.uint8),
        rotation=rng.normal(size=(2, 3, 3)).astype(np.float32),
        translation=rng.normal(size=(2, 3)).astype(np.float32),
        size=rng.uniform(0, 1, (2, 3)).astype(np.float32),
        joint_values=rng.normal(size=1).astype(np.float32),
    )


def test_shards_keep_views_to_a_tenth_of_a_millimetre(tmp_path: Path) -> None:
    views = [view(7), view(0), view(30)]
    write_shard(tmp_path / "shard", pack(views))
    shard = read_shard(tmp_path / "shard")
    assert isinstance(shard.points, np.memmap)
    assert len(shard) == 3
    for index, given in enumerate(views):
        read = shard.view(index)
        np.testing.assert_allclose(read.points, given.points, atol=0.51e-4)
        for field in ("labels", "rotation", "translation", "size", "joint_values"):
            np.testing.assert_array_equal(getattr(read, field), getattr(given, field))


def test_of_two_writers_the_first_wins(tmp_path: Path) -> None:
    write_shard(tmp_path / "shard", pack([view(7)]))
    write_shard(tmp_path / "shard", pack([view(8)]))
    assert len(read_shard(tmp_path / "shard").labels) == 7
    assert [path.name for path in tmp_path.iterdir()] == ["shard"]


def test_the_command_writes_shards_and_their_sources(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    generate("bottle", count=2, seed=3, out=tmp_path)
    assert len(ViewDataset(tmp_path)) == 2
    assert (tmp_path / "sources.json").read_text() == "{}\n"
    assert "2/2" in capsys.readouterr().out


def test_a_folder_of_another_category_stays_as_it_is(tmp_path: Path) -> None:
    fill(tmp_path, count=2)
    before = {path.name: path.stat().st_mtime_ns for path in tmp_path.iterdir()}
    with pytest.raises(OtherViewsError, match=r"holds views of mug.* name another folder by --out, such as .*/can/"):
        generate("can", count=2, seed=1, out=tmp_path)
    with pytest.raises(OtherViewsError):
        generate_views("can", 2, 1, tmp_path, lambda rng: make_shape("can", rng), FEW)
    assert {path.name: path.stat().st_mtime_ns for path in tmp_path.iterdir()} == before


def test_folders_of_before_are_kept_where_they_may_be_of_the_category(tmp_path: Path) -> None:
    fill(tmp_path, count=2)
    (tmp_path / "views.json").unlink()
    with pytest.raises(OtherViewsError, match="holds views of another category, and those of laptop_articulated"):
        generate("laptop_articulated", count=2, seed=1, out=tmp_path)
    fill(tmp_path)
    assert len(ViewDataset(tmp_path)) == 5
    assert not (tmp_path / "views.json").exists(), "nobody knows"


def test_the_credit_of_earlier_views_stays(tmp_path: Path) -> None:
    write_sources(tmp_path, {"mug/cup": "CC0"})
    write_sources(tmp_path, {})
    write_sources(tmp_path, {"mug/beaker": "CC-BY 3.0 (A. Nother)"})
    assert json.loads((tmp_path / "sources.json").read_text()) == {
        "mug/cup": "CC0",
        "mug/beaker": "CC-BY 3.0 (A. Nother)",
    }


def test_how_often_a_hand_holds_the_object_can_be_said(tmp_path: Path) -> None:
    for held in (0.0, 1.0):
        generate("mug", count=1, seed=3, out=tmp_path / str(held), held=held)
    resting, held_up = (ViewDataset(tmp_path / name)[0] for name in ("0.0", "1.0"))
    assert not np.allclose(resting.rotation, held_up.rotation)

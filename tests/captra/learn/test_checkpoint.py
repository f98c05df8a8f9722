from pathlib import Path

import pytest
import torch
from torch import nn

from captra.categories import get_category
from captra.learn.checkpoint import (
    CheckpointError,
    is_authors,
    load_coordinate_net,
    load_rotation_net,
    save_checkpoint,
    training_info,
)
from captra.learn.networks import TorchNetworks
from export.step import profile_for, step_arrays
from tests import reference
from tests.made_up import batch_of_clouds, networks_of, write_checkpoints

MUG = get_category("mug")


@reference.needs_reference
@pytest.mark.parametrize("name", reference.CATEGORIES)
def test_one_step_with_the_authors_checkpoints(name: str, tmp_path: Path) -> None:
    category, arrays = get_category(name), reference.step_of(name)
    coordinate, rotation = reference.write_checkpoints(name, tmp_path)
    networks = TorchNetworks(
        category,
        profile_for(arrays["points"]),
        load_coordinate_net(coordinate, category),
        load_rotation_net(rotation, category),
    )
    reference.assert_matches_reference(step_arrays(networks, arrays), arrays)


@reference.needs_reference
def test_the_authors_layout_is_recognized(tmp_path: Path) -> None:
    coordinate, _ = reference.write_checkpoints("bottle", tmp_path)
    assert is_authors(coordinate)
    assert training_info(coordinate) == {"epoch": 1, "iteration": 1}


@reference.needs_reference
@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (
            lambda state: state.pop("net.backbone.sa2.conv_blocks.1.2.weight"),
            r"1 entries are missing.*conv_blocks\.1\.2",
        ),
        (lambda state: state.update({"net.extra": torch.zeros(3)}), r"1 entries are unknown, first 'net\.extra'"),
        (lambda state: state.update({"net.seg_head.0.bias": torch.zeros(7)}), r"\(7,\) instead of \(2,\)"),
    ],
)
def test_every_entry_of_the_authors_is_accounted_for(spoil: object, message: str, tmp_path: Path) -> None:
    path, _ = reference.write_checkpoints("bottle", tmp_path)
    content = torch.load(path, weights_only=True)
    assert callable(spoil)
    spoil(content["model"])
    torch.save(content, path)
    with pytest.raises(CheckpointError, match=message) as caught:
        load_coordinate_net(path, get_category("bottle"))
    assert "check that" in str(caught.value)


@reference.needs_reference
def test_swapped_files_and_wrong_categories_are_told(tmp_path: Path) -> None:
    coordinate, rotation = reference.write_checkpoints("bottle", tmp_path)
    with pytest.raises(CheckpointError, match=r"is not the CoordinateNet of bottle.*swapped"):
        load_coordinate_net(rotation, get_category("bottle"))
    with pytest.raises(CheckpointError, match=r"is not the RotationNet of mug.*category"):
        load_rotation_net(rotation, MUG)
    with pytest.raises(CheckpointError, match="is not the RotationNet of glasses"):
        load_rotation_net(coordinate, get_category("glasses"))


def test_our_own_checkpoints_come_back_as_they_were(tmp_path: Path) -> None:
    coordinate, rotation = write_checkpoints("mug", tmp_path)
    expected = networks_of("mug")
    points, n = batch_of_clouds(1, seed=0)
    with torch.inference_mode():
        torch.testing.assert_close(load_coordinate_net(coordinate, MUG)(points, n), expected[0](points, n))
        torch.testing.assert_close(load_rotation_net(rotation, MUG)(points[None], n), expected[1](points[None], n))
    assert not is_authors(coordinate)
    assert training_info(coordinate) == {"samples": 24, "seed": 1}


def test_our_own_checkpoint_of_another_category_is_refused(tmp_path: Path) -> None:
    coordinate, rotation = write_checkpoints("mug", tmp_path)
    with pytest.raises(CheckpointError, match="is not the CoordinateNet of drawers"):
        load_coordinate_net(coordinate, get_category("drawers"))
    with pytest.raises(CheckpointError, match=r"heads\.0\.output"):
        load_rotation_net(rotation, get_category("bowl"))


def test_an_interrupted_save_leaves_the_old_checkpoint(tmp_path: Path) -> None:
    path = tmp_path / "coordinate.pt"
    save_checkpoint(path, nn.Linear(2, 2), {"samples": 1})

    class Unsaveable(nn.Module):
        def state_dict(self, *args: object, **kwargs: object) -> dict[str, object]:  # type: ignore[override]
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        save_checkpoint(path, Unsaveable(), {"samples": 2})
    assert training_info(path) == {"samples": 1}


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "no readable checkpoint"),
        (b"not a checkpoint at all", "no readable checkpoint"),
    ],
)
def test_files_that_are_no_checkpoint(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "broken.pt"
    path.write_bytes(content)
    with pytest.raises(CheckpointError, match=message):
        load_coordinate_net(path, MUG)


def test_a_file_without_a_model(tmp_path: Path) -> None:
    path = tmp_path / "other.pt"
    torch.save({"weights": {}}, path)
    with pytest.raises(CheckpointError, match='no state dict "model"'):
        load_coordinate_net(path, MUG)


def test_a_missing_file(tmp_path: Path) -> None:
    with pytest.raises(CheckpointError, match="does not exist"):
        load_rotation_net(tmp_path / "none.pt", MUG)

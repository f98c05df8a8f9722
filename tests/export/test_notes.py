import json
from pathlib import Path

import pytest

from captra.runtime.bundle import BundleError, Manifest, Score, Training
from captra.sampling import InputSampling
from export.notes import with_notes

MANIFEST = Manifest("mug", ("mug",), False, "float16", 17, {}, Training(data="mugs", steps=10, seed=1))


def notes(folder: Path, content: object) -> Path:
    path = folder / "notes.json"
    path.write_text(json.dumps(content))
    return path


def test_nothing_to_add() -> None:
    assert with_notes(None)(MANIFEST) is MANIFEST


def test_objects_are_merged_and_lists_replaced(tmp_path: Path) -> None:
    content = {
        "training": {"commit": "abc"},
        "health": {"bias": 5.0},
        "input_sampling": {"surroundings_weight": 0.5},
        "scores": [{"command": "captra evaluate", "values": {"IoU %": 80.0}}],
    }
    manifest = with_notes(notes(tmp_path, content))(MANIFEST)
    assert manifest.training == Training(data="mugs", steps=10, seed=1, commit="abc")
    assert manifest.health == {"bias": 5.0}
    assert manifest.input_sampling == InputSampling(surroundings_weight=0.5)
    assert manifest.scores == (Score("captra evaluate", {"IoU %": 80.0}),)


@pytest.mark.parametrize("content", [{"sha256": {}}, ["scores"], {"category": "bowl", "scores": []}])
def test_what_was_measured_or_computed_cannot_be_set(content: object, tmp_path: Path) -> None:
    with pytest.raises(BundleError, match=r"only training, scores, health, .*, joint_projection, mirror can"):
        with_notes(notes(tmp_path, content))


def test_a_file_that_is_no_json(tmp_path: Path) -> None:
    path = tmp_path / "notes.json"
    path.write_text("scores: 1")
    with pytest.raises(BundleError, match="is no JSON"):
        with_notes(path)

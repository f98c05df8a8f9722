from pathlib import Path

import pytest
import torch

from captra.learn import local_steps
from captra.learn.campaign import Folders, replace_bundle
from captra.learn.course import BOTH, COORDINATE_FURTHER, ROTATION_ANEW, ROTATION_FURTHER
from captra.learn.local_steps import LocalSteps, captra


def test_the_steps_lead_from_nothing_to_a_bundle(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Far too little training to be of use, but every step is the one that a campaign takes."""
    (tmp_path / "models").mkdir()
    folders = Folders(tmp_path / ".campaign", tmp_path / "models")
    steps = LocalSteps(folders, samples=36, views=8, sequences=1, instances=2, frames=3)
    steps.make_views("can")
    assert steps.train("can", BOTH, 18) == 18
    first = torch.load(folders.run("can") / "state.pt", weights_only=True)["progress"]["samples"]
    steps.train("can", BOTH, 36)
    assert (first, torch.load(folders.run("can") / "state.pt", weights_only=True)["progress"]["samples"]) == (18, 36)
    steps.export("can", BOTH)
    assert 0 <= steps.validate(folders.candidate("can")) <= 100
    assert all("procedural-9" not in path.name for path in folders.sequences.rglob("*.npz")), "no test seed is drawn"
    replace_bundle(folders.candidate("can"), folders.models / "can")
    before = {path.name: path.read_bytes() for path in (folders.models / "can").iterdir()}
    for name in ("bottle", "bowl"):
        steps.make_views(name)
    monkeypatch.setattr(local_steps, "captra", briefly)
    stretches = (ROTATION_ANEW, COORDINATE_FURTHER, ROTATION_FURTHER)
    for stretch, network in zip(stretches, ("rotation.onnx", "coordinate.onnx", "rotation.onnx"), strict=True):
        assert steps.train("can", stretch, 18) == 18
        steps.export("can", stretch)
        changed = {path.name for path in folders.candidate("can").iterdir() if path.read_bytes() != before[path.name]}
        assert changed == {network, "manifest.json"}
    assert steps.train("bowl", ROTATION_ANEW, 9) == 18, "it is the run of all that are round"


def briefly(*arguments: str) -> None:
    """All but what takes long and was done before."""
    if arguments[0] not in ("fuse", "calibrate"):
        captra(*arguments)

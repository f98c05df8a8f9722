import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from captra.cli import build_app
from captra.evaluation.cli import evaluate
from captra.evaluation.manifest_scores import command_for, write_scores
from captra.evaluation.scoring import score
from captra.evaluation.summary import summarize
from captra.runtime.bundle import Score, load_manifest, verify, write_manifest
from tests.captra.evaluation.test_evaluation import still_recording

ROOT = Path(__file__).parents[3]


@pytest.fixture
def bundle(tmp_path: Path) -> Path:
    shutil.copytree(ROOT / "models" / "mug", tmp_path / "models" / "mug")
    return tmp_path / "models" / "mug"


def test_scores_take_the_place_of_older_ones_and_leave_others_alone(bundle: Path) -> None:
    speed = Score("captra bench", {"frames_per_second": 20.0})
    write_manifest(bundle, replace(load_manifest(bundle), scores=(Score("captra evaluate --old", {"a": 1.0}), speed)))
    recording = still_recording("drawers")
    mean = summarize(score(recording, [recording.truth(0)] * 3))
    write_scores(bundle, "captra evaluate --category mug", {"recordings": mean})
    kept, written = load_manifest(bundle).scores
    assert kept == speed
    assert written.command == "captra evaluate --category mug"
    assert written.values["recordings_5deg5cm_percent"] == 100
    assert written.values["recordings_joint_cm"] == pytest.approx(0, abs=1e-3)
    assert "recordings_joint_deg" not in written.values
    verify(bundle, load_manifest(bundle))


def test_scores_of_another_provider_stay(bundle: Path) -> None:
    recording = still_recording("mug")
    means = {"recordings": summarize(score(recording, [recording.truth(0)] * 3))}
    write_manifest(bundle, replace(load_manifest(bundle), scores=()))
    for command in ("captra evaluate", "captra evaluate --provider openvino", "captra evaluate --procedural 20"):
        write_scores(bundle, command, means)
    commands = [each.command for each in load_manifest(bundle).scores]
    assert commands == ["captra evaluate --provider openvino", "captra evaluate --procedural 20"]


def test_the_command_names_no_folder_of_this_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    options = {"recordings": Path("recordings"), "meshes": Path("../meshes"), "procedural": 20}
    expected = "captra evaluate --category can --recordings recordings --meshes MESHES --procedural 20"
    assert command_for("can", options) == expected
    assert command_for("can", {"recordings": tmp_path / "recordings"}).endswith("--recordings RECORDINGS")


def test_what_is_measured_is_what_the_manifest_says(tmp_path: Path) -> None:
    bundle = Path(shutil.copytree(ROOT / "models" / "scissors", tmp_path / "models" / "scissors"))
    arguments = ["evaluate", "--recordings", str(bundle), "--procedural", "1", "--frames", "4", "--write-scores"]
    arguments += [
        "--standalone",
        "1",
        "--models",
        str(bundle.parent),
        "--cache",
        str(bundle.parent / "cache"),
        "--json",
        str(bundle / "rows"),
    ]
    done = CliRunner().invoke(build_app({"evaluate": evaluate}), arguments, catch_exceptions=False)
    assert done.exit_code == 0, done.output
    values = load_manifest(bundle).scores[-1].values
    assert values["procedural_sequences"] == values["standalone_sequences"] == 1
    assert f"{values['procedural_5deg5cm_percent']:.1f} %" in done.output
    assert "--procedural 1 --frames 4 --profile realtime --standalone 1" in load_manifest(bundle).scores[-1].command
    assert np.isfinite(list(values.values())).all()
    assert (bundle / "rows").stat().st_size > 100

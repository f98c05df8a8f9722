import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from captra.categories import CATEGORIES
from captra.cli import main
from captra.evaluation.fusion_choice import LEAST_GAIN, FusedNetworks, Fusion, choose, rotation_fusions, worth
from captra.evaluation.runner import ExportedNetworks
from captra.evaluation.summary import Summary
from captra.joint_projection import JOINT_PROJECTIONS
from captra.rotation_fusion import ROTATION_FUSIONS
from captra.runtime.bundle import load_manifest, write_manifest
from captra.runtime.onnx_networks import OnnxNetworks

MODELS = Path(__file__).resolve().parents[3] / "models"


def mean_of(name: str, percent: float) -> Summary:
    return Summary(name, 1, 1, 0, percent, percent, percent, 0.0, 0.0, 0.0, None, None, None)


@pytest.mark.parametrize("category", CATEGORIES)
def test_candidates_are_fusions_that_manifests_can_name(category: str) -> None:
    _, means = choose(category, lambda fusion: mean_of(fusion.name, 50.0))
    tried = [tuple(mean.name.split(", ")[:2]) for mean in means]
    assert {fusion for fusion, _ in tried} == set(rotation_fusions(category)) <= set(ROTATION_FUSIONS)
    assert {projection for _, projection in tried} == (
        set(JOINT_PROJECTIONS) if CATEGORIES[category].joints else {"free"}
    )


def test_a_projection_is_chosen_only_if_it_helps() -> None:
    percents = {"mean, free": 70.0, "mean, pooled": 80.0, "mean, along-axes": 60.0}
    best, means = choose("drawers", lambda fusion: mean_of(fusion.name, percents.get(fusion.name, 50.0)))
    assert best == Fusion("mean", "pooled")
    assert worth(max(means, key=worth)) == 80.0
    percents["mean, pooled"] = 65.0
    assert choose("drawers", lambda fusion: mean_of(fusion.name, percents.get(fusion.name, 50.0)))[0] == Fusion("mean")


def test_a_pair_is_found_that_is_best_though_neither_of_it_is_with_the_best_of_the_other() -> None:
    percents = {"mean, free": 70.0, "turn-about-y-half-way, pooled": 80.0}
    best, _ = choose("scissors", lambda fusion: mean_of(fusion.name, percents.get(fusion.name, 50.0)))
    assert best == Fusion("turn-about-y-half-way", "pooled")


@pytest.mark.parametrize(("gain", "chosen"), [(LEAST_GAIN / 2, "none"), (2 * LEAST_GAIN, "left-and-right")])
def test_a_mirror_is_tried_with_the_best_of_all_and_chosen_if_it_is_worth_its_time(gain: float, chosen: str) -> None:
    percents = {"mean, free": 60.0, "mean, pooled": 80.0, "mean, pooled, left-and-right": 80.0 + gain}
    best, means = choose("glasses", lambda fusion: mean_of(fusion.name, percents.get(fusion.name, 50.0)))
    assert best == Fusion("mean", "pooled", chosen)
    assert [mean.name for mean in means if "left" in mean.name] == ["mean, pooled, left-and-right"]


def test_objects_that_are_round_are_not_mirrored() -> None:
    _, means = choose("can", lambda fusion: mean_of(fusion.name, 50.0))
    assert not any("left" in mean.name for mean in means)


def test_a_bundle_is_run_with_the_fusion_asked_for() -> None:
    exported = ExportedNetworks(MODELS / "laptop_articulated", "realtime", "cpu", 1)
    fused = FusedNetworks(exported, Fusion("coordinates", "pooled", "left-and-right")).load()
    assert isinstance(fused, OnnxNetworks)
    assert fused.manifest.mirror == "left-and-right"
    assert Fusion.of(fused.manifest) == Fusion("coordinates", "pooled", "left-and-right")
    assert fused.rotation_fusion is ROTATION_FUSIONS["coordinates"]
    assert fused.joint_projection is JOINT_PROJECTIONS["pooled"]


def test_the_best_candidate_on_validation_sequences_goes_into_the_manifest(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bundle = tmp_path / "models" / "mug"
    shutil.copytree(MODELS / "mug", bundle)
    before = load_manifest(bundle)
    write_manifest(bundle, replace(before, rotation_fusion="coordinates"))
    options = ["--category", "mug", "--models", str(bundle.parent), "--cache", str(tmp_path / "cache")]
    with pytest.raises(SystemExit) as ended:
        main(["fuse", *options, "--sequences", "1", "--frames", "4", "--instances", "2"])
    assert not ended.value.code
    chosen = load_manifest(bundle)
    assert chosen.rotation_fusion in rotation_fusions("mug")
    printed = " ".join(capsys.readouterr().out.split())
    assert f"mug: {chosen.rotation_fusion}, free" in printed
    assert "left-and-right" in printed
    assert "mug: centres stay off by" in printed
    assert chosen.found_error != before.found_error
    noted = Fusion(chosen.rotation_fusion, chosen.joint_projection, chosen.mirror)
    assert replace(noted.set_in(before), found_error=chosen.found_error) == chosen

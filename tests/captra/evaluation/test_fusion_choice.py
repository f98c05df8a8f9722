import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from captra.categories import CATEGORIES
from captra.cli import main
from captra.evaluation import workers
from captra.evaluation.fusion_choice import FusedNetworks, candidates, compare, worth
from captra.evaluation.runner import ExportedNetworks
from captra.evaluation.sequence_cache import SequenceCache
from captra.evaluation.sequences import VALIDATION_SEED, procedural
from captra.rotation_fusion import ROTATION_FUSIONS
from captra.runtime.bundle import load_manifest, write_manifest

MODELS = Path(__file__).resolve().parents[3] / "models"


@pytest.mark.parametrize("category", CATEGORIES)
def test_candidates_are_fusions_that_manifests_can_name(category: str) -> None:
    assert set(candidates(category)) <= set(ROTATION_FUSIONS)
    assert "rotation-net" in candidates(category)


def test_a_bundle_is_run_with_the_fusion_asked_for() -> None:
    fused = FusedNetworks(ExportedNetworks(MODELS / "can", "realtime", "cpu", 1), "coordinates")
    assert fused.load().rotation_fusion is ROTATION_FUSIONS["coordinates"]


def test_the_best_candidate_on_validation_sequences_goes_into_the_manifest(tmp_path: Path) -> None:
    bundle = tmp_path / "models" / "mug"
    shutil.copytree(MODELS / "mug", bundle)
    before = load_manifest(bundle)
    write_manifest(bundle, replace(before, rotation_fusion="coordinates"))
    options = [
        "--category",
        "mug",
        "--models",
        str(bundle.parent),
        "--cache",
        str(tmp_path / "cache"),
        "--sequences",
        "1",
        "--frames",
        "4",
    ]
    with pytest.raises(SystemExit) as ended:
        main(["fuse", *options])
    assert not ended.value.code
    sources = list(procedural("mug", 1, SequenceCache.open(tmp_path / "cache"), 4, VALIDATION_SEED))
    exported = ExportedNetworks(bundle, "realtime", "cpu", 1)
    means = {mean.name: worth(mean) for mean in compare(exported, "mug", sources, workers.Here())}
    assert list(means) == list(candidates("mug"))
    chosen = load_manifest(bundle)
    assert means[chosen.rotation_fusion] == max(means.values())
    assert replace(chosen, rotation_fusion=before.rotation_fusion) == before

"""Networks from bundles on disk, without a network that could be loaded."""

import json
from pathlib import Path

import pytest

from captra.runtime.bundle import Manifest, Training, sha256_of, write_manifest
from service.bundles import BundleNetworks
from service.networks import NoModelError
from service.rejections import CategoryWithoutModelError, ModelNotLoadableError


def provider_of(models_dir: Path) -> BundleNetworks:
    return BundleNetworks(models_dir, "realtime", "cpu", threads=1)


def write_bundle(
    folder: Path, category: str = "mug", files: tuple[str, ...] = ("coordinate.onnx", "rotation.onnx")
) -> None:
    """A bundle whose manifest is right and whose networks are not."""
    folder.mkdir(parents=True)
    for name in files:
        (folder / name).write_bytes(b"no graph")
    digests = {name: sha256_of(folder / name) for name in files}
    write_manifest(folder, Manifest(category, (category,), False, "float16", 17, digests, Training("nothing", 0)))


@pytest.mark.parametrize("exists", [True, False])
def test_folder_without_bundles_is_named(tmp_path: Path, exists: bool) -> None:
    folder = tmp_path if exists else tmp_path / "nowhere"
    provider = provider_of(folder)
    with pytest.raises(NoModelError, match=str(folder)):
        provider.prepare()
    assert provider.models() == []
    with pytest.raises(CategoryWithoutModelError, match="mug"):
        provider.get("mug", "realtime")


def test_networks_that_cannot_be_loaded_are_told_with_the_reason(tmp_path: Path) -> None:
    write_bundle(tmp_path / "mug")
    provider = provider_of(tmp_path)
    assert [(model.category, model.precision, model.error) for model in provider.models()] == [("mug", "float16", None)]
    with pytest.raises(ModelNotLoadableError, match="mug"):
        provider.get("mug", "realtime")
    with pytest.raises(NoModelError, match="mug"):
        provider.prepare()
    (model,) = provider.models()
    assert model.error
    assert model.loaded == ()
    assert model.manifest["training"]["data"] == "nothing"


def test_damaged_file_is_named(tmp_path: Path) -> None:
    write_bundle(tmp_path / "mug")
    (tmp_path / "mug" / "rotation.onnx").write_bytes(b"something else")
    with pytest.raises(ModelNotLoadableError, match=r"rotation\.onnx"):
        provider_of(tmp_path).get("mug", "realtime")


def test_manifest_that_is_none_is_told(tmp_path: Path) -> None:
    (tmp_path / "mug").mkdir()
    (tmp_path / "mug" / "manifest.json").write_text(json.dumps({"format": 0}))
    (model,) = provider_of(tmp_path).models()
    assert model.category == "mug"
    assert "manifest.json" in str(model.error)


def test_category_without_bundle_names_those_that_have_one(tmp_path: Path) -> None:
    write_bundle(tmp_path / "mug")
    with pytest.raises(CategoryWithoutModelError, match="mug"):
        provider_of(tmp_path).get("bottle", "realtime")

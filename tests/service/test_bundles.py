"""Networks from bundles on disk, without a network that could be loaded."""

import json
import shutil
from pathlib import Path

import pytest

from captra.runtime.bundle import Manifest, Training, sha256_of, write_manifest
from service.bundles import BundleNetworks
from service.networks import NoModelError
from service.rejections import CategoryWithoutModelError, ModelNotLoadableError
from tests import made_up


def provider_of(models_dir: Path, preload: tuple[str, ...] = ()) -> BundleNetworks:
    return BundleNetworks(models_dir, "realtime", "cpu", threads=1, preload=preload)


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


@pytest.fixture(scope="module")
def three_bundles(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("models")
    for category in ("bottle", "bowl", "mug"):
        made_up.write_bundle(category, folder / category)
    return folder


@pytest.mark.parametrize(
    ("preload", "loaded"), [((), ["bottle"]), (("mug",), ["mug"]), (("mug", "bowl"), ["bowl", "mug"])]
)
def test_networks_are_loaded_when_they_are_asked_for(
    preload: tuple[str, ...], loaded: list[str], three_bundles: Path
) -> None:
    provider = provider_of(three_bundles, preload)
    provider.prepare()
    assert [model.category for model in provider.models() if model.loaded] == loaded
    provider.get("bottle", "realtime")
    assert [model.category for model in provider.models() if model.loaded] == sorted({*loaded, "bottle"})


def test_a_damaged_bundle_is_told_before_anybody_asks_for_it(three_bundles: Path, tmp_path: Path) -> None:
    models = shutil.copytree(three_bundles, tmp_path / "models")
    (models / "bowl" / "rotation.onnx").write_bytes(b"something else")
    provider = provider_of(models, ("mug", "teapot"))
    provider.prepare()
    errors = {model.category: model.error for model in provider.models()}
    assert "rotation.onnx" in str(errors["bowl"])
    assert errors["bottle"] is errors["mug"] is None

import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from captra.runtime.bundle import (
    COORDINATE,
    ROTATION,
    BundleError,
    Manifest,
    MeshCredit,
    Score,
    Training,
    find_bundles,
    load_manifest,
    sha256_of,
    verify,
    write_manifest,
)
from captra.sampling import PROFILES, InputSampling

MANIFEST = Manifest(
    category="mug",
    parts=("mug",),
    symmetric=False,
    precision="float16",
    opset=17,
    sha256={},
    training=Training(
        data="procedural mugs", steps=5000, seed=1, commit="abc", meshes=(MeshCredit("cup", "CC-BY-4.0", "A. Nother"),)
    ),
    scores=(Score("captra evaluate --category mug", {"5°5cm %": 91.5}),),
    input_sampling=InputSampling(surroundings_weight=0.4),
    health={"bias": 6.5},
)
TEXT = st.text(max_size=20)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)


@given(
    st.builds(
        replace,
        st.just(MANIFEST),
        parts=st.lists(TEXT, min_size=1, max_size=4).map(tuple),
        symmetric=st.booleans(),
        sha256=st.dictionaries(TEXT, TEXT, max_size=2),
        scores=st.lists(st.builds(Score, TEXT, st.dictionaries(TEXT, NUMBERS, max_size=3)), max_size=3).map(tuple),
        health=st.dictionaries(TEXT, NUMBERS, max_size=3),
        training=st.builds(
            Training,
            TEXT,
            st.integers(0),
            st.none() | st.integers(),
            TEXT,
            st.builds(MeshCredit, TEXT, TEXT, TEXT).map(lambda m: (m,)),
        ),
        input_sampling=st.builds(InputSampling, NUMBERS, NUMBERS),
    )
)
def test_json_round_trip(manifest: Manifest) -> None:
    assert Manifest.from_json(manifest.to_json()) == manifest


def test_shapes_of_the_profiles_are_stated() -> None:
    content = json.loads(MANIFEST.to_json())
    assert content["profiles"]["realtime"]["points"] == 1024
    assert Manifest.from_json(MANIFEST.to_json()).profiles == PROFILES


def bundle(folder: Path, category: str = "mug") -> Path:
    path = folder / category
    path.mkdir(parents=True)
    for name in (COORDINATE, ROTATION):
        (path / name).write_bytes(b"weights")
    write_manifest(path, replace(MANIFEST, sha256={name: sha256_of(path / name) for name in (COORDINATE, ROTATION)}))
    return path


def test_a_whole_bundle_verifies(tmp_path: Path) -> None:
    path = bundle(tmp_path)
    verify(path, load_manifest(path))


def test_files_whose_digest_is_not_told_do_not_verify(tmp_path: Path) -> None:
    path = bundle(tmp_path)
    write_manifest(path, replace(MANIFEST, sha256={COORDINATE: sha256_of(path / COORDINATE)}))
    with pytest.raises(BundleError, match=r"rotation\.onnx is damaged"):
        verify(path, load_manifest(path))


@pytest.mark.parametrize(
    "damage", ['"sha256": 5', '"training": []', '"rotation_share": 2', '"profiles": []', '"parts": 7']
)
def test_damaged_manifests_are_told(tmp_path: Path, damage: str) -> None:
    path = bundle(tmp_path)
    content = json.loads(MANIFEST.to_json()) | json.loads("{" + damage + "}")
    (path / "manifest.json").write_text(json.dumps(content))
    with pytest.raises(BundleError):
        load_manifest(path)


def test_one_flipped_bit_is_found(tmp_path: Path) -> None:
    path = bundle(tmp_path)
    (path / "coordinate.onnx").write_bytes(b"weighus")
    with pytest.raises(BundleError, match=r"coordinate\.onnx is damaged.*copy the whole bundle again"):
        verify(path, load_manifest(path))


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    path = bundle(tmp_path)
    (path / "coordinate.onnx").unlink()
    with pytest.raises(BundleError, match=r"coordinate\.onnx is missing"):
        verify(path, load_manifest(path))


def test_a_folder_without_a_manifest(tmp_path: Path) -> None:
    with pytest.raises(BundleError, match=r"is no bundle.*captra export"):
        load_manifest(tmp_path)


@pytest.mark.parametrize("field", ["category", "sha256", "training", "profiles", "rotation_input"])
def test_a_manifest_that_lacks_something(field: str, tmp_path: Path) -> None:
    path = bundle(tmp_path)
    content = json.loads((path / "manifest.json").read_text())
    del content[field]
    (path / "manifest.json").write_text(json.dumps(content))
    with pytest.raises(BundleError, match=rf"manifest\.json cannot be read.*{field}.*export the bundle again"):
        load_manifest(path)


def test_a_manifest_from_before_the_share_means_all_points() -> None:
    content = json.loads(MANIFEST.to_json())
    del content["rotation_share"]
    assert Manifest.from_json(json.dumps(content)).rotation_share == 1


def test_a_manifest_from_before_mirrors_asks_once() -> None:
    content = json.loads(MANIFEST.to_json())
    del content["mirror"]
    assert Manifest.from_json(json.dumps(content)).mirror == "none"


@pytest.mark.parametrize("field", ["rotation_fusion", "joint_projection", "mirror"])
def test_a_way_to_run_the_networks_that_is_not_known(field: str) -> None:
    content = {**json.loads(MANIFEST.to_json()), field: "sideways"}
    with pytest.raises(BundleError, match=r"'sideways' is unknown.*update captra"):
        Manifest.from_json(json.dumps(content))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "no manifest"),
        ("[]", "no manifest"),
        ('{"format": 2}', "format is 2"),
        ('{"format": 1, "new": 0}', "no manifest"),
    ],
)
def test_what_is_no_manifest(text: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "manifest.json").write_text(text)
    with pytest.raises(BundleError, match=message):
        load_manifest(tmp_path)


def test_unknown_entries_are_refused() -> None:
    content = {**json.loads(MANIFEST.to_json()), "invention": 1}
    with pytest.raises(BundleError, match="invention"):
        Manifest.from_json(json.dumps(content))


def test_bundles_are_found_by_category(tmp_path: Path) -> None:
    paths = {name: bundle(tmp_path, name) for name in ("mug", "bottle")}
    (tmp_path / "notes").mkdir()
    (tmp_path / "README.md").write_text("not a bundle")
    assert find_bundles(tmp_path) == paths
    assert list(find_bundles(tmp_path)) == ["bottle", "mug"]
    assert find_bundles(tmp_path / "notes") == {}

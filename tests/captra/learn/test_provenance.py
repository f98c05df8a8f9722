"""Whoever made a mesh is named from the library to the bundle."""

import json
from pathlib import Path

import pytest
import trimesh

from captra.data.credits import UnnamedAuthorError
from captra.data.generate import generate
from captra.data.shapes.surfaces import box
from captra.learn.provenance import provenance
from captra.runtime.bundle import load_manifest

MODELS = Path(__file__).parents[3] / "models"


def write_library(folder: Path, entry: dict[str, str]) -> Path:
    (folder / "bottle").mkdir(parents=True)
    mesh = box((0.06, 0.2, 0.06))
    trimesh.Trimesh(mesh.vertices, mesh.faces).export(folder / "bottle" / "shop-CC-BY__square.ply")
    index = {"bottle/shop-CC-BY__square": {"use": "train", "notes": "", **entry}}
    (folder / "INDEX.json").write_text(json.dumps(index))
    return folder


@pytest.mark.parametrize("entry", [{"notes": "square; author A. Nother"}, {"author": "A. Nother"}])
def test_a_checkpoint_names_the_author_of_a_mesh(tmp_path: Path, entry: dict[str, str]) -> None:
    library = write_library(tmp_path / "library", {"licence": "CC-BY 3.0", **entry})
    generate("bottle", count=1, seed=3, out=tmp_path / "views", meshes=library)
    (credit,) = provenance(tmp_path / "views")["meshes"]
    assert credit == {"name": "bottle/shop-CC-BY__square", "license": "CC-BY 3.0", "attribution": "A. Nother"}


def test_no_views_are_made_of_a_mesh_whose_author_has_to_be_named_and_is_not(tmp_path: Path) -> None:
    library = write_library(tmp_path / "library", {"licence": "CC-BY 3.0"})
    with pytest.raises(UnnamedAuthorError, match="bottle/shop-CC-BY__square"):
        generate("bottle", count=1, seed=3, out=tmp_path / "views", meshes=library)
    assert not (tmp_path / "views").exists()


def test_a_mesh_in_the_public_domain_is_known_by_its_collection(tmp_path: Path) -> None:
    library = write_library(tmp_path / "library", {"licence": "CC0"})
    generate("bottle", count=1, seed=3, out=tmp_path / "views", meshes=library)
    (credit,) = provenance(tmp_path / "views")["meshes"]
    assert credit["attribution"] == "shop-CC-BY"


@pytest.mark.parametrize("bundle", sorted(path.name for path in MODELS.iterdir()))
def test_bundles_name_authors_and_not_collections(bundle: str) -> None:
    for mesh in load_manifest(MODELS / bundle).training.meshes:
        assert mesh.attribution
        assert mesh.attribution != Path(mesh.name).name.partition("__")[0], mesh.name

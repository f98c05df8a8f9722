"""The library of meshes that docs/your-own-category.md shows can be read."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
import trimesh

from captra.data.meshes import load_meshes
from captra.data.shapes.surfaces import box

TEXT = (Path(__file__).parents[3] / "docs" / "your-own-category.md").read_text(encoding="utf-8")
INDEX, OBJECT = (json.loads(block) for block in re.findall(r"```json\n(.*?)```", TEXT, re.DOTALL))


@pytest.fixture
def library(tmp_path: Path) -> Path:
    (tmp_path / "INDEX.json").write_text(json.dumps(INDEX))
    cabinet = tmp_path / "drawers_articulated" / "my_cabinet"
    for folder, files in ((tmp_path / "mug", ["my_mug.ply", "kept_back.ply"]), (cabinet, meshes_of(OBJECT))):
        folder.mkdir(parents=True)
        for height, name in enumerate(files):
            mesh = box((0.4, 0.1, 0.4)).moved(translation=np.array([0, 0.2 * height, 0]))
            trimesh.Trimesh(mesh.vertices, mesh.faces).export(folder / name)
    (cabinet / "object.json").write_text(json.dumps(OBJECT))
    return tmp_path


def meshes_of(articulated: dict[str, list[dict[str, str]]]) -> list[str]:
    return [part["mesh"] for part in articulated["parts"]]


def test_it_can_be_read(library: Path) -> None:
    (mug,), (kept_back,) = load_meshes(library, "mug", "train"), load_meshes(library, "mug", "validate")
    (cabinet,) = load_meshes(library, "drawers", "train")
    assert [each.name for each in (mug, kept_back, cabinet)] == list(INDEX)
    assert mug.credit.checked(mug.name).author == "A. Nother"
    assert [round(float(part.bounds().mean(0)[1]), 3) for part in cabinet.shape.parts] == [-0.3, -0.1, 0.1, 0.3]
    np.testing.assert_allclose(cabinet.shape.joint_limits, [[0, 0.42]] * 3)

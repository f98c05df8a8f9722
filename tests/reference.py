"""The reference: weights that follow from a seed, and what the authors' networks compute with them in one step."""

import importlib.util
import os
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import torch

from captra.fitting import mean_axis_rotation, mean_rotation

CATEGORIES = ("bottle", "laptop_articulated")
REPOSITORY = Path(__file__).resolve().parent.parent


def shared_folder() -> Path:
    """`CAPTRA_SHARED`, or `shared` beside the repository."""
    return Path(os.environ.get("CAPTRA_SHARED", REPOSITORY.parent / "shared"))


REFERENCE = shared_folder() / "reference"
needs_reference = pytest.mark.skipif(
    not REFERENCE.is_dir(), reason=f"there is no {REFERENCE}: set CAPTRA_SHARED to the folder that holds `reference`"
)


def checkpoint(category: str, network: str) -> dict[str, np.ndarray]:
    """A state dict in the authors' layout."""
    state: dict[str, np.ndarray] = _maker().checkpoint(category, network)
    return state


def write_checkpoints(category: str, folder: Path) -> tuple[Path, Path]:
    """Files of CoordinateNet and RotationNet as the authors release them."""
    paths = (folder / f"{category}-coordinate.pt", folder / f"{category}-rotation.pt")
    for path, network in zip(paths, ("coordinate", "rotation"), strict=True):
        state = {key: torch.from_numpy(value) for key, value in checkpoint(category, network).items()}
        torch.save({"epoch": 1, "iteration": 1, "model": state, "optimizer": {}}, path)
    return paths


def step_of(category: str) -> dict[str, np.ndarray]:
    """Inputs and answers of one step."""
    with np.load(REFERENCE / f"step_{category}.npz") as stored:
        return dict(stored)


def assert_matches_reference(answers: dict[str, np.ndarray], reference: dict[str, np.ndarray]) -> None:
    """Compare one step's answers with what the authors' networks give."""
    parts = len(reference["last_scale"])
    deltas = reference["delta_point_rotation"].reshape(parts, -1, 3, 3).astype(np.float64)
    np.testing.assert_allclose(answers["seg"], reference["seg"], atol=1e-4)
    np.testing.assert_allclose(answers["coords"], reference["coords"], atol=1e-4)
    np.testing.assert_array_equal(answers["labels"], reference["labels"])
    np.testing.assert_allclose(answers["delta_point_rotation"], deltas, atol=1e-3)
    mean = mean_axis_rotation if reference["sym"] else mean_rotation
    for part in range(parts):
        expected = reference["last_rotation"][part] @ mean(deltas[part, reference["labels"] == part])
        np.testing.assert_allclose(answers["rotation"][part], expected, atol=1e-3)
        scale, translation = _fit(reference, part, expected)
        if scale > 0:
            np.testing.assert_allclose(answers["scale"][part], scale, atol=1e-4)
            np.testing.assert_allclose(answers["translation"][part], translation, atol=1e-3)
        else:
            np.testing.assert_allclose(answers["scale"][part], reference["last_scale"][part])


def _fit(reference: dict[str, np.ndarray], part: int, rotation: np.ndarray) -> tuple[float, np.ndarray]:
    """Scale and translation in closed form from the reference's masks and coordinates, given the rotation."""
    mask = reference["labels"] == part
    points = reference["points"][mask].astype(np.float64)
    coordinates = reference["coords"][3 * part : 3 * part + 3, mask].T.astype(np.float64)
    if reference["sym"]:
        seen = (points - points.mean(axis=0)) @ rotation
        c, s = seen[:, [0, 2]], (coordinates - coordinates.mean(axis=0))[:, [0, 2]]
        u, _, vt = np.linalg.svd(s.T @ c)
        u[:, 1] *= np.linalg.det(u @ vt)
        coordinates[:, [0, 2]] = coordinates[:, [0, 2]] @ (u @ vt)
    turned = coordinates @ rotation.T
    w, c = turned - turned.mean(axis=0), points - points.mean(axis=0)
    scale = float((w * c).sum() / (w * w).sum())
    return scale, (points - scale * turned).mean(axis=0)


def _maker() -> ModuleType:
    spec = importlib.util.spec_from_file_location("make_checkpoint", REFERENCE / "make_checkpoint.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module

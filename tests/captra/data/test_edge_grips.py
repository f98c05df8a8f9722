import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from captra.data.edge_grips import Edge, laptop_grip, pinch, rim_grip
from captra.data.shapes import make_shape
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import box


def distance(holder: Mesh, held: Mesh) -> float:
    """From the hand's vertices to the surface that it holds."""
    surface = trimesh.sample.sample_surface(trimesh.Trimesh(*held, process=False), 20_000, seed=0)[0]
    return float(cKDTree(surface).query(holder.vertices)[0].min())


def test_a_pinch_has_the_sheet_between_thumb_and_fingers() -> None:
    sheet = box((0.3, 0.01, 0.3))
    edge = Edge(np.array([0.15, 0, 0]), np.array([-1.0, 0, 0]), np.array([0, 1.0, 0]), 0.01)
    for seed in range(10):
        holder = pinch(np.random.default_rng(seed), edge)
        over = holder.vertices[(np.abs(holder.vertices[:, 2]) < 0.1) & (holder.vertices[:, 0] < 0.14)]
        assert (over[:, 1] > 0.004).any()
        assert (over[:, 1] < -0.004).any()
        assert np.abs(over[:, 1]).min() > 0.004, "no finger goes through the sheet"
        assert distance(holder, sheet) < 0.004


@pytest.mark.parametrize("seed", range(8))
def test_laptops_and_bowls_are_held_at_an_edge(seed: int) -> None:
    for category, grip in (("laptop", laptop_grip), ("bowl", rim_grip)):
        rng = np.random.default_rng([3, seed])
        held = make_shape(category, rng).parts[0]
        holder = grip(rng, held.vertices)
        assert np.isfinite(holder.vertices).all()
        assert distance(holder, held) < 0.012, category

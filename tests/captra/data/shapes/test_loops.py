import numpy as np
import pytest
import trimesh

from captra.data.shapes.curves import superellipse
from captra.data.shapes.loops import bent, bent_mesh, closed_sweep, mirrored
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.surfaces import box

Z = np.array([0.0, 0, 1])


def as_trimesh(mesh: Mesh) -> trimesh.Trimesh:
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)


def test_a_swept_circle_is_a_torus() -> None:
    circle = np.insert(superellipse(120, 2.0), 2, 0.0, axis=1)
    torus = as_trimesh(closed_sweep(circle, superellipse(60, 2.0, (0.2, 0.2)), Z))
    assert torus.is_watertight
    assert torus.volume == pytest.approx(2 * np.pi**2 * 0.2**2, rel=0.02)
    assert torus.euler_number == 0


def test_sections_may_vary_and_their_first_axis_points_inwards() -> None:
    circle = np.insert(superellipse(40, 2.0), 2, 0.0, axis=1)
    shifted = np.tile(superellipse(8, 2.0, (0.1, 0.1)) + [0.3, 0.0], (40, 1, 1))
    radius = np.linalg.norm(closed_sweep(circle, shifted, Z).vertices[:, :2], axis=1)
    assert radius.max() == pytest.approx(0.8, abs=0.01)


def test_a_mirror_image_stays_wound_outwards() -> None:
    mesh = mirrored(box((1, 2, 3)).moved(translation=np.array([2.0, 0, 0])), axis=0)
    assert as_trimesh(mesh).volume == pytest.approx(6)
    assert mesh.bounds()[:, 0].tolist() == [-2.5, -1.5]


def test_bending_keeps_lengths_and_turns_the_ends_backwards() -> None:
    line = np.column_stack([np.linspace(-0.1, 0.1, 400), np.zeros(400), np.zeros(400)])
    curve = bent(line, 0.08)
    assert np.linalg.norm(np.diff(curve, axis=0), axis=1).sum() == pytest.approx(0.2, rel=1e-4)
    assert curve[0, 2] == pytest.approx(0.08 * (np.cos(0.1 / 0.08) - 1))
    np.testing.assert_allclose(curve[200], 0, atol=1e-3)
    flat = bent_mesh(box((0.1, 0.1, 0.1)), 1e5)
    np.testing.assert_allclose(flat.bounds(), [[-0.05] * 3, [0.05] * 3], atol=1e-4)

import numpy as np
import pytest
import trimesh

from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate, plate_with_well, stacked


def solid(mesh: Mesh) -> trimesh.Trimesh:
    body = trimesh.Trimesh(*mesh, process=False)
    assert body.is_watertight
    return body


def test_plates_and_wells_have_the_right_volume() -> None:
    outline = Rectangle.centred(0.4, 0.2)
    assert solid(plate(outline, 0.0, 0.05)).volume == pytest.approx(0.4 * 0.2 * 0.05, rel=1e-3)
    well = Rectangle.centred(0.2, 0.1).moved(0.08, -0.03)
    sunk = solid(plate_with_well(outline, 0.0, 0.05, well, 0.02))
    assert sunk.volume == pytest.approx(0.4 * 0.2 * 0.05 - 0.2 * 0.1 * 0.02, rel=1e-3)
    assert 0 < solid(plate(outline, 0.0, 0.05, bevel=0.01)).volume < 0.4 * 0.2 * 0.05
    frustum = solid(stacked([(outline, 0.0), (Rectangle.centred(0.2, 0.1), 0.3)]))
    assert frustum.volume == pytest.approx(0.3 / 3 * (0.08 + 0.02 + 0.04), rel=1e-3)


def test_corners_are_round_but_for_the_square_end() -> None:
    rounded = Rectangle((0.0, -1.0), (3.0, 1.0), 0.5)
    outline = rounded.outline()
    np.testing.assert_allclose([outline.min(0), outline.max(0)], [[0, -1], [3, 1]], atol=1e-12)
    corner = np.array([3.0, 1.0])
    assert np.linalg.norm(outline - corner, axis=1).min() == pytest.approx(0.5 * (np.sqrt(2) - 1), abs=0.06)
    square = Rectangle((0.0, -1.0), (3.0, 1.0), 0.5, "high").outline()
    assert np.linalg.norm(square - corner, axis=1).min() < 1e-3
    assert np.linalg.norm(square - [0.0, 1.0], axis=1).min() > 0.15


def test_a_square_end_stays_where_it_is_when_the_rest_shrinks() -> None:
    shrunk = Rectangle((0.0, -1.0), (3.0, 1.0), 0.0, "high").shrunk(0.25)
    assert shrunk.low == (0.25, -0.75)
    assert shrunk.high == (3.0, 0.75)

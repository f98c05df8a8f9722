"""Things that stand around: simple solids and vessels, standing on y = 0 with their axis at x = z = 0."""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from captra.data.shapes import make_shape
from captra.data.shapes.curves import rounded_polyline, through
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh, grid_mesh
from captra.data.shapes.surfaces import box, capsule, revolve, rounded_box, superellipsoid, tube
from captra.geometry import axis_angle

ThingMaker = Callable[[np.random.Generator], Mesh]


def make_clutter(rng: np.random.Generator, categories: Sequence[str] = ("bottle", "mug")) -> Mesh:
    """Draw a thing, turn it about y, lay it down now and then; it may be an instance of one of these categories."""
    kinds: tuple[tuple[float, ThingMaker], ...] = (*KINDS, (1.6, partial(_instance, categories)))
    mesh = pick(rng, kinds)(rng)
    if chance(rng, 0.2):
        mesh = mesh.moved(axis_angle(np.array([1.0, 0.0, 0.0]), np.pi / 2 + between(rng, -0.1, 0.1)))
    mesh = mesh.moved(axis_angle(np.array([0.0, 1.0, 0.0]), between(rng, 0, 2 * np.pi)))
    low, high = mesh.bounds()
    return mesh.moved(translation=-np.array([(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2]))


def _block(rng: np.random.Generator) -> Mesh:
    return box(tuple(np.exp(rng.uniform(np.log(0.015), np.log(0.22), 3))))


def _book(rng: np.random.Generator) -> Mesh:
    return box((between(rng, 0.1, 0.25), between(rng, 0.008, 0.05), between(rng, 0.12, 0.3)))


def _rounded(rng: np.random.Generator) -> Mesh:
    x, y, z = np.exp(rng.uniform(np.log(0.02), np.log(0.15), 3))
    return rounded_box((x, y, z), between(rng, 2, 7), between(rng, 0.001, 0.02), segments=20)


def _blob(rng: np.random.Generator) -> Mesh:
    x, y, z = np.exp(rng.uniform(np.log(0.02), np.log(0.12), 3))
    return superellipsoid((x, y, z), between(rng, 1.6, 4.0), segments=18)


def _ball(rng: np.random.Generator) -> Mesh:
    return superellipsoid((between(rng, 0.03, 0.14),) * 3, 2.0, segments=20)


def _pillar(rng: np.random.Generator) -> Mesh:
    radius, height = between(rng, 0.008, 0.06), between(rng, 0.02, 0.28)
    top = radius * between(rng, 0.6, 1.2) if chance(rng, 0.4) else radius
    return revolve(rounded_polyline(np.array([[0, 0], [radius, 0], [top, height], [0, height]]), 0.002), segments=22)


def _vessel(rng: np.random.Generator) -> Mesh:
    radius, height = between(rng, 0.025, 0.12), between(rng, 0.015, 0.16)
    t = np.linspace(0, 1, 9)
    outer = radius * through((0, 0.5, 1), (between(rng, 0.3, 1), between(rng, 0.6, 1.1), 1), t)
    wall = between(rng, 0.0015, 0.006)
    inner = np.column_stack([outer - wall, np.maximum(t * height, wall)])[::-1]
    profile = np.concatenate([[[0, 0]], np.column_stack([outer, t * height]), inner, [[0, wall]]])
    return revolve(profile, segments=24)


def _bent(rng: np.random.Generator) -> Mesh:
    """Banana, handle or cable: a bent tube."""
    turn, length = between(rng, 0.2, 2.6), between(rng, 0.08, 0.3)
    angle = np.linspace(-turn / 2, turn / 2, 12)
    arc = length / turn * np.column_stack([np.sin(angle), np.cos(angle) * 0, np.cos(angle)])
    thick = pick(rng, ((2, between(rng, 0.01, 0.022)), (1, between(rng, 0.003, 0.008))))
    radius = thick * through(
        (0, 0.25, 0.75, 1), (between(rng, 0.3, 1), 1, 1, between(rng, 0.3, 1)), np.linspace(0, 1, 12)
    )
    return tube(arc, radius, np.array([0.0, 1.0, 0.0]))


def _rod(rng: np.random.Generator) -> Mesh:
    return capsule(between(rng, 0.08, 0.3), between(rng, 0.003, 0.018), segments=10)


def _cloth(rng: np.random.Generator) -> Mesh:
    """A crumpled sheet or bag: a bumpy dome."""
    count = 14
    axis = np.linspace(-1, 1, count)
    x, z = np.meshgrid(axis, axis)
    height = np.maximum(0, 1 - np.maximum(abs(x), abs(z)) ** between(rng, 1, 4))
    for _ in range(4):
        kx, kz, phase = rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(0, 6)
        height = height * (1 + 0.25 * np.sin(kx * x + kz * z + phase))
    size = rng.uniform(0.05, 0.15, 2)
    top = np.stack([x * size[0], height * between(rng, 0.005, 0.06), z * size[1]], -1)
    return _sheet(top)


def _sheet(grid: np.ndarray) -> Mesh:
    rows = [np.concatenate([row, row[::-1] - [0, 1e-4, 0]]) for row in grid]
    return grid_mesh(np.stack(rows), caps=True)


def _instance(categories: Sequence[str], rng: np.random.Generator) -> Mesh:
    """Another object of a rigid category: not the one that is tracked."""
    return make_shape(str(rng.choice(list(categories))), rng).parts[0]


KINDS: tuple[tuple[float, ThingMaker], ...] = (
    (2.0, _block),
    (1.0, _book),
    (1.5, _rounded),
    (1.5, _blob),
    (0.6, _ball),
    (2.0, _pillar),
    (1.5, _vessel),
    (1.5, _bent),
    (0.8, _rod),
    (0.6, _cloth),
)

"""Hands that pinch an edge between thumb and fingers: a laptop's body or lid, the rim of a bowl. Object frame."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64

from captra.data.hands import GripFrame, forearm
from captra.data.shapes.draws import between, chance
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import superellipsoid, tube


@dataclass(frozen=True)
class Edge:
    """Where a sheet ends, object frame, metres."""

    point: Float64[np.ndarray, " 3"]
    """On the edge, half-way through the sheet."""
    inward: Float64[np.ndarray, " 3"]
    """Unit vector from the edge into the sheet."""
    normal: Float64[np.ndarray, " 3"]
    """Unit normal of the sheet."""
    thickness: float
    """Of the sheet."""


def pinch(rng: np.random.Generator, edge: Edge) -> Mesh:
    """Fingers on one face, the thumb on the other, palm and forearm outside."""
    size = between(rng, 0.75, 1.2)
    face = 1.0 if chance(rng, 0.5) else -1.0
    along = np.cross(edge.inward, edge.normal)
    spacing = between(rng, 0.017, 0.022) * size
    count = int(rng.integers(2, 5))
    meshes = []
    for k in range(count):
        radius = between(rng, 0.0065, 0.0095) * size
        start = edge.point + along * (k - (count - 1) / 2) * spacing
        meshes.append(_finger(edge, start, face, radius, between(rng, 0.02, 0.07) * size))
    start = edge.point + along * between(rng, -1.2, 1.2) * spacing
    meshes.append(_finger(edge, start, -face, between(rng, 0.0085, 0.0115) * size, between(rng, 0.015, 0.06) * size))
    thick = between(rng, 0.022, 0.034) * size
    frame = GripFrame(along, np.cross(along, -edge.inward), -edge.inward)
    centre = edge.point - edge.inward * (0.02 * size + thick / 2) + edge.normal * face * between(rng, -0.01, 0.03)
    palm = (between(rng, 0.05, 0.09) * size, max(0.03, count * spacing * 1.05), thick)
    meshes.append(superellipsoid(palm, between(rng, 2.3, 4), 16).moved(frame.matrix, centre))
    meshes.append(forearm(rng, centre, frame, size))
    return merged(meshes)


def _finger(edge: Edge, start: Float64[np.ndarray, " 3"], face: float, radius: float, length: float) -> Mesh:
    """From the palm over the edge along one face."""
    lift = edge.normal * face * (edge.thickness / 2 + radius)
    inward = np.array([-0.025, -0.008, 0.004, length / 2, length])
    raised = np.array([0.2, 0.75, 1.0, 1.0, 1.0])
    curve = start + inward[:, None] * edge.inward + raised[:, None] * lift
    return tube(curve, np.linspace(1.1, 0.85, 5) * radius, np.cross(edge.inward, edge.normal))


def laptop_grip(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Holds the body at a side or its front, or the lid at a side or its upper edge."""
    low, high = vertices.min(0).astype(np.float64), vertices.max(0).astype(np.float64)
    size = high - low
    if chance(rng, 0.65):
        body = vertices[(vertices[:, 0] > low[0] + 0.6 * size[0]) & (vertices[:, 1] < low[1] + 0.05)]
        thickness = float(np.ptp(body[:, 1]))
        middle = float(body[:, 1].min()) + thickness / 2
        if chance(rng, 0.35):
            point = np.array([high[0], middle, between(rng, -0.4, 0.4) * size[2]])
            return pinch(rng, Edge(point, np.array([-1.0, 0, 0]), np.array([0.0, 1, 0]), thickness))
        side = 1.0 if chance(rng, 0.5) else -1.0
        point = np.array([low[0] + between(rng, 0.6, 0.95) * size[0], middle, side * size[2] / 2])
        return pinch(rng, Edge(point, np.array([0.0, 0, -side]), np.array([0.0, 1, 0]), thickness))
    lid = vertices[vertices[:, 1] > low[1] + 0.5 * size[1]]
    edge = _upper_edge(lid[:, :2].astype(np.float64), np.array([1.0, 0, 0]))
    if chance(rng, 0.5):
        return pinch(rng, _moved(edge, np.array([0, 0, between(rng, -0.4, 0.4) * size[2]])))
    side = 1.0 if chance(rng, 0.5) else -1.0
    down = edge.inward * between(rng, 0.02, 0.5) * size[1]
    sideways = Edge(edge.point, np.array([0.0, 0, -side]), edge.normal, edge.thickness)
    return pinch(rng, _moved(sideways, down + np.array([0, 0, side * size[2] / 2])))


def rim_grip(rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"]) -> Mesh:
    """Holds a hollow vessel at its rim: fingers on one side of the wall, the thumb on the other."""
    azimuth = between(rng, -np.pi, np.pi)
    outward = np.array([np.cos(azimuth), 0, np.sin(azimuth)])
    low, high = float(vertices[:, 1].min()), float(vertices[:, 1].max())
    turn = np.arctan2(vertices[:, 2], vertices[:, 0]) - azimuth
    near = np.abs(np.angle(np.exp(1j * turn))) < 0.2
    near &= vertices[:, 1] > low + 0.6 * (high - low)
    wall = vertices[near & (vertices @ outward > 0.5 * (vertices @ outward).max())].astype(np.float64)
    return pinch(rng, _upper_edge(np.column_stack([wall @ outward, wall[:, 1]]), outward))


def _upper_edge(section: Float64[np.ndarray, "N 2"], first: Float64[np.ndarray, " 3"]) -> Edge:
    """Upper end of a sheet's cross-section, given along `first` and y."""
    middle = section.mean(0)
    up = np.linalg.svd(section - middle, full_matrices=False)[2][0]
    up = up if up[1] > 0 else -up
    across = np.array([up[1], -up[0]])
    along, through = (section - middle) @ up, (section - middle) @ across
    end = middle + up * along.max() + across * (through.max() + through.min()) / 2
    y = np.array([0.0, 1, 0])
    normal = across[0] * first + across[1] * y
    return Edge(end[0] * first + end[1] * y, -(up[0] * first + up[1] * y), normal, float(np.ptp(through)))


def _moved(edge: Edge, shift: Float64[np.ndarray, " 3"]) -> Edge:
    return Edge(edge.point + shift, edge.inward, edge.normal, edge.thickness)

"""What lies in a bowl or on a keyboard: things that are lowered until they touch. Object frame, y up."""

import numpy as np
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene
from jaxtyping import Float, Float32

from captra.data.shapes.draws import between, pick
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import box, capsule, superellipsoid
from captra.geometry import axis_angle


def make_contents(rng: np.random.Generator, vessel: Mesh) -> list[Mesh]:
    """Fruit, cutlery and small things, one on top of the other; they may stand out above the vessel's box."""
    low, high = vessel.bounds()
    reach = 0.5 * float(min(high[0] - low[0], high[2] - low[2]))
    things: list[Mesh] = []
    for _ in range(int(rng.integers(1, 6))):
        thing = _thing(rng, reach).moved(axis_angle(np.array([0.0, 1, 0]), between(rng, 0, 2 * np.pi)))
        x, z = rng.uniform(-0.45, 0.45, 2) * reach
        above = float(max(high[1], *(mesh.bounds()[1, 1] for mesh in things)) if things else high[1])
        lifted = thing.moved(translation=np.array([x, above - float(thing.bounds()[0, 1]) + 0.01, z]))
        things.append(settled(lifted, merged([vessel, *things])))
    return things


def _thing(rng: np.random.Generator, reach: float) -> Mesh:
    kind = pick(rng, ((5, "fruit"), (2, "lump"), (1.5, "rod"), (1, "flat")))
    if kind == "fruit":
        radius = min(between(rng, 0.15, 0.5) * reach, 0.05)
        stretch = rng.uniform(0.8, 1.25, 3) * 2 * radius
        return superellipsoid((stretch[0], stretch[1], stretch[2]), between(rng, 1.9, 2.4), 18)
    if kind == "lump":
        x, y, z = rng.uniform(0.15, 0.8, 3) * min(reach, 0.08)
        return superellipsoid((x, y, z), between(rng, 2.0, 6.0), 16)
    if kind == "rod":
        rod = capsule(between(rng, 0.1, 0.22), between(rng, 0.002, 0.006), segments=8)
        return rod.moved(axis_angle(np.array([1.0, 0, 0]), np.radians(between(rng, 35, 90))))
    return box((between(rng, 0.05, 0.16), between(rng, 0.0005, 0.012), between(rng, 0.03, 0.09)))


def settled(thing: Mesh, ground: Mesh) -> Mesh:
    """Lower a thing that is above the ground along y until they touch; where there is no ground it stays."""
    onto = _distance(thing.vertices, ground, down=True)
    under = _distance(ground.vertices, thing, down=False)
    drop = min(float(onto.min(initial=np.inf)), float(under.min(initial=np.inf)))
    return thing.moved(translation=np.array([0, -drop, 0])) if np.isfinite(drop) else thing


def _distance(points: Float[np.ndarray, "N 3"], mesh: Mesh, *, down: bool) -> Float32[np.ndarray, " N"]:
    """How far each point is above (or below) a mesh; infinite beside it."""
    scene = EmbreeScene()
    TriangleMesh(scene, mesh.vertices, mesh.faces)
    directions = np.tile(np.array([0, -1 if down else 1, 0], np.float32), (len(points), 1))
    hit = scene.run(np.ascontiguousarray(points, np.float32), directions, query="INTERSECT", output=True)
    return np.where(hit["primID"] >= 0, hit["tfar"], np.inf).astype(np.float32)

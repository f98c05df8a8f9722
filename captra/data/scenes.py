"""Where an object is and what is around it: on a table among clutter, or held by a hand or gripper.

World frame: y up, metres; the object's centre starts at the origin and the camera stands towards +z.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float64
from scipy.spatial import ConvexHull

from captra.data.clutter import make_clutter
from captra.data.contents import make_contents
from captra.data.habits import Habits, habits_of
from captra.data.holders import make_holder
from captra.data.joint_states import draw_joint_values
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.shape import Shape
from captra.data.shapes.surfaces import box
from captra.geometry import axis_angle, matrix_from_quat_xyzw

X, Y = np.eye(3)[:2]

LOWEST_HELD_DEG = -60.0
"""Elevation from which cameras may look up at an object that stands on nothing."""


@dataclass(frozen=True)
class Scene:
    """An object with what stands still around it and what moves along with it."""

    shape: Shape
    """The object."""
    joint_values: Float64[np.ndarray, " J"]
    """Its joint states."""
    rotation: Float64[np.ndarray, "3 3"]
    """R_world_object; the object's centre is at the origin."""
    attached: tuple[Mesh, ...]
    """In the object frame: a hand that holds it, things that lie in it."""
    surroundings: tuple[Mesh, ...]
    """In the world frame."""
    lowest_elevation_deg: float
    """The camera may not look from further below."""


def posed_parts(shape: Shape, joint_values: Float[np.ndarray, " J"]) -> list[Mesh]:
    """The parts at these joint values, in the object frame."""
    rotation, translation = part_motions(shape, joint_values)
    return [part.moved(r, t) for part, r, t in zip(shape.parts, rotation, translation, strict=True)]


def random_rotation(rng: np.random.Generator) -> Float64[np.ndarray, "3 3"]:
    """Uniform over all rotations (normalized Gaussian quaternion)."""
    quat = rng.normal(size=4)
    return matrix_from_quat_xyzw(quat / np.linalg.norm(quat))


def make_scene(shape: Shape, rng: np.random.Generator, held_fraction: float = 0.45) -> Scene:
    """Draw a scene around an object: held in that fraction of cases, otherwise resting on something."""
    values = draw_joint_values(shape, rng)
    held = chance(rng, held_fraction * habits_of(shape.category).held)
    return held_scene(shape, values, rng) if held else table_scene(shape, values, rng)


def held_scene(
    shape: Shape, joint_values: Float64[np.ndarray, " J"], rng: np.random.Generator, clearance: float = 0.0
) -> Scene:
    """In a hand, at any orientation, above a table or against nothing at all; `clearance` metres are left to move."""
    vertices = merged(posed_parts(shape, joint_values)).vertices
    habits = habits_of(shape.category)
    attached = [make_holder(rng, vertices, shape.category)] if chance(rng, 0.95) else []
    rotation = _held_rotation(rng, habits)
    attached += _contents(rng, shape, habits, rotation)
    reach = float(np.linalg.norm(vertices, axis=1).max())
    surroundings: list[Mesh] = []
    if chance(rng, 0.7):
        drop = float((vertices @ rotation.T)[:, 1].min()) - between(rng, 0.0, 0.3) - clearance
        surroundings += [plate(rng).moved(translation=np.array([0, drop, 0]))]
        surroundings += scattered(rng, vertices @ rotation.T, drop, int(rng.integers(0, 5)), 0.0, habits)
    for _ in range(int(rng.integers(0, 4))):
        direction = rng.normal(size=3)
        at = direction / np.linalg.norm(direction) * (reach + between(rng, 0.04, 0.25) + clearance)
        surroundings.append(make_clutter(rng, habits.neighbours).moved(random_rotation(rng), at))
    if chance(rng, 0.3):
        surroundings.append(wall(rng, -reach - between(rng, 0.02, 0.4) - clearance))
    return Scene(shape, joint_values, rotation, tuple(attached), tuple(surroundings), LOWEST_HELD_DEG)


def standalone_scene(shape: Shape, joint_values: Float64[np.ndarray, " J"], rng: np.random.Generator) -> Scene:
    """Held by nothing and with nothing around it, as the paper's articulated dataset shows objects."""
    habits = habits_of(shape.category)
    return Scene(shape, joint_values, _held_rotation(rng, habits), (), (), LOWEST_HELD_DEG)


def table_scene(shape: Shape, joint_values: Float64[np.ndarray, " J"], rng: np.random.Generator) -> Scene:
    """Standing, lying or upside down on a table, a stack, a shelf or in a box, among clutter."""
    vertices = merged(posed_parts(shape, joint_values)).vertices
    habits = habits_of(shape.category)
    rotation = resting_rotation(rng, vertices, habits)
    placed = vertices @ rotation.T
    floor = float(placed[:, 1].min())
    surroundings = [plate(rng).moved(translation=np.array([0, floor, 0]))]
    lowest = 3.0
    setting = pick(rng, ((6.5, "table"), (1, "stack"), (1, "box"), (1, "wall"), (0.5, "shelf")))
    half = np.abs(placed).max(0)
    if setting == "stack":
        tall, below = between(rng, 0.01, 0.15), floor
        size = (2 * half[0] * between(rng, 0.9, 2.5), tall, 2 * half[2] * between(rng, 0.9, 2.5))
        turn = axis_angle(Y, between(rng, 0, np.pi))
        surroundings = [box(size).moved(turn, np.array([0, below - tall / 2, 0]))]
        surroundings.append(plate(rng).moved(translation=np.array([0, below - tall, 0])))
        floor = below - tall
    elif setting == "box":
        surroundings += _open_box(rng, half, floor)
        lowest = 25.0
    elif setting == "wall":
        surroundings.append(wall(rng, -half[2] - between(rng, 0.0, 0.2)))
    elif setting == "shelf":
        surroundings.append(wall(rng, -half[2] - between(rng, 0.01, 0.15)))
        above = half[1] * 2 + floor + between(rng, 0.02, 0.15)
        surroundings.append(box((1.0, 0.02, 0.3)).moved(translation=np.array([0, above, -0.1])))
    count = int(rng.integers(0, 8))
    if setting != "box":
        surroundings += scattered(rng, placed, floor, count, 0.25, habits)
    attached = [make_holder(rng, vertices, shape.category)] if chance(rng, 0.12) else []
    attached += _contents(rng, shape, habits, rotation)
    return Scene(shape, joint_values, rotation, tuple(attached), tuple(surroundings), lowest)


def _contents(
    rng: np.random.Generator, shape: Shape, habits: Habits, rotation: Float64[np.ndarray, "3 3"]
) -> list[Mesh]:
    """Things in a vessel that is not tilted much."""
    if habits.contents == 0 or rotation[1, 1] < 0.85 or not chance(rng, habits.contents):
        return []
    return make_contents(rng, shape.parts[0])


def _held_rotation(rng: np.random.Generator, habits: Habits) -> Float64[np.ndarray, "3 3"]:
    """At any orientation, or tilted a little."""
    return random_rotation(rng) if chance(rng, habits.tumbled) else _upright(rng, habits, tilt_deg=30)


def _upright(rng: np.random.Generator, habits: Habits, tilt_deg: float) -> Float64[np.ndarray, "3 3"]:
    tilt_axis = axis_angle(Y, between(rng, 0, 2 * np.pi))[:, 0]
    lean = axis_angle(tilt_axis, np.radians(rng.normal(0, tilt_deg)))
    return np.asarray(lean @ axis_angle(Y, habits.yaw(rng)))


def resting_rotation(
    rng: np.random.Generator, vertices: Float[np.ndarray, "V 3"], habits: Habits
) -> Float64[np.ndarray, "3 3"]:
    """Mostly upright; else upside down, lying on a face of the convex hull, or leaning."""
    turn = axis_angle(Y, habits.yaw(rng))
    mode = pick(rng, habits.resting)
    if mode == "upright":
        return turn
    if mode == "upside down":
        return np.asarray(turn @ axis_angle(X, np.pi))
    if mode == "leaning":
        return _upright(rng, habits, tilt_deg=15)
    hull = ConvexHull(vertices)
    corners = vertices[hull.simplices]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    normals = hull.equations[:, :3]
    weights = areas * (np.abs(normals[:, 1]) < 0.9) + 1e-12
    down = normals[int(rng.choice(len(weights), p=weights / weights.sum()))]
    axis = np.cross(down, -Y)
    sine = float(np.linalg.norm(axis))
    if sine < 1e-6:
        return turn
    return np.asarray(turn @ axis_angle(axis, np.arctan2(sine, float(down @ -Y))))


def plate(rng: np.random.Generator) -> Mesh:
    """A table top with its surface at y = 0; its edges may be near."""
    x, z = rng.uniform(0.25, 1.2, 2)
    thick = between(rng, 0.01, 0.06)
    shift = np.array([rng.uniform(-0.4, 0.4) * x, -thick / 2, rng.uniform(-0.4, 0.4) * z])
    return box((x, thick, z)).moved(axis_angle(Y, between(rng, -0.8, 0.8)), shift)


def wall(rng: np.random.Generator, z: float) -> Mesh:
    """An upright board behind the object, facing the camera more or less."""
    board = box((between(rng, 0.4, 1.5), 1.2, 0.02)).moved(translation=np.array([0, 0, -0.01]))
    return board.moved(translation=np.array([rng.uniform(-0.2, 0.2), 0, z])).moved(
        axis_angle(Y, between(rng, -0.7, 0.7))
    )


def _open_box(rng: np.random.Generator, half: Float[np.ndarray, " 3"], floor: float) -> list[Mesh]:
    inner = half[[0, 2]] + rng.uniform(0.005, 0.1, 2)
    tall, thick = between(rng, 0.03, 0.2), between(rng, 0.002, 0.015)
    turn = axis_angle(Y, between(rng, -0.8, 0.8)) if chance(rng, 0.3) else np.eye(3)
    boards = []
    for sign in (-1, 1):
        for axis in (0, 1):
            size = np.array([thick, tall, 2 * inner[1]]) if axis == 0 else np.array([2 * inner[0], tall, thick])
            at = np.array([sign * inner[0], 0, 0]) if axis == 0 else np.array([0, 0, sign * inner[1]])
            boards.append(box(size).moved(turn, turn @ at + [0, floor + tall / 2, 0]))
    return boards


def scattered(
    rng: np.random.Generator,
    placed: Float[np.ndarray, "V 3"],
    floor: float,
    count: int,
    touching: float,
    habits: Habits,
) -> list[Mesh]:
    """Things on a plane around the object that do not cut into it; a fraction of them touches it."""
    things = []
    for _ in range(count):
        thing = make_clutter(rng, habits.neighbours)
        angle = between(rng, 0, 2 * np.pi)
        direction = np.array([np.cos(angle), 0, np.sin(angle)])
        reach = float((placed @ direction).max()) - float((thing.vertices @ direction).min())
        gap = 0.001 if chance(rng, touching) else float(rng.exponential(0.06)) + 0.002
        sideways = np.cross(Y, direction) * rng.normal(0, 0.03)
        things.append(thing.moved(translation=direction * (reach + gap) + sideways + [0, floor, 0]))
    return things

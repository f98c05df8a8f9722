"""From a shape to a simulated frame around it."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float32, Float64, UInt8

from captra.categories import get_category
from captra.data.depth_camera import DepthNoise, draw_noise, observe
from captra.data.rendering import Camera, DepthPatch, cast
from captra.data.scenes import Scene, make_scene, posed_parts
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.shape import Shape
from captra.data.strays import keep_segment
from captra.data.view import View, ball_radius
from captra.geometry import axis_angle

LENS = np.diag([1.0, -1.0, -1.0])
"""A camera that looks along -z of a y-up frame, written in the axes x right, y down, z forward."""


STORED_DEPTH_M = 3.1
"""Somewhat less than the 3.27 m that int16 multiples of 0.1 mm reach."""


FARTHEST_SCALES = 4.5
"""Small pre-segmented objects are not looked at from further than that many of their scales."""
FRINGE_M = 0.03
"""What is seen around a pre-segmented object."""


class HiddenObjectError(RuntimeError):
    """Nothing worth keeping of the object is in sight, whatever was tried."""


@dataclass(frozen=True)
class ViewOptions:
    """Knobs of a view."""

    held_fraction: float = 0.45
    """How often the object is in a hand rather than on something."""
    max_rays: int = 130_000
    """Resolution limit: larger regions are cast at every second pixel or fewer."""
    points: tuple[int, int] = (5_000, 12_000)
    """Range of the number of points kept."""
    least_object_points: int = 60
    """Views with fewer are drawn again."""
    attempts: int = 12
    """Before giving up."""
    stray_share: float = 0.05
    """Pre-segmented categories: largest share of points that belong to no part (label P)."""


@dataclass(frozen=True)
class Orbit:
    """Where a camera stands around the world's origin, and where in its image the origin appears."""

    distance: float
    """Depth of the origin, metres."""
    elevation: float
    """Angle above the horizon from which it looks down, rad."""
    azimuth: float
    """Angle about the world's y axis from +z towards +x, rad."""
    roll: float
    """Rotation about the viewing direction, rad."""
    offset: tuple[float, float]
    """Tangents of the angles by which the origin appears right of and below the image's middle."""

    @property
    def rotation(self) -> Float64[np.ndarray, "3 3"]:
        """R_camera_world."""
        level = axis_angle(np.array([1.0, 0, 0]), self.elevation) @ axis_angle(np.array([0, 1.0, 0]), -self.azimuth)
        return np.asarray(LENS @ axis_angle(np.array([0, 0, 1.0]), self.roll) @ level)

    @property
    def translation(self) -> Float64[np.ndarray, " 3"]:
        """The world's origin in the camera frame, metres."""
        return self.distance * np.array([self.offset[0], self.offset[1], 1.0])


def make_view(shape: Shape, rng: np.random.Generator, options: ViewOptions | None = None) -> View:
    """Simulate one frame of an object.

    Raises:
        HiddenObjectError: if no attempt shows enough of it, which a sane shape never does.
    """
    options = options or ViewOptions()
    for _ in range(options.attempts):
        scene = make_scene(shape, rng, options.held_fraction)
        camera = Camera(focal_px=between(rng, 450, 700) if chance(rng, 0.6) else between(rng, 570, 625))
        view = photograph(scene, camera, draw_orbit(scene, camera, rng), draw_noise(rng), rng, options)
        if (view.labels < len(shape.parts)).sum() >= options.least_object_points:
            return view
    raise HiddenObjectError(f"no view of this {shape.category} shows {options.least_object_points} of its points")


def draw_orbit(scene: Scene, camera: Camera, rng: np.random.Generator) -> Orbit:
    """Look at the object from a plausible side; it need not be in the middle of the image."""
    distance = max(between(rng, 0.35, 1.1) if chance(rng, 0.75) else between(rng, 0.8, 1.6), 1.25 * scene.shape.scale)
    mean, spread = pick(rng, ((3, (38.0, 16.0)), (1, (15.0, 12.0)), (0.6, (75.0, 10.0)), (0.6, (0.0, 25.0))))
    elevation = np.radians(np.clip(rng.normal(mean, spread), scene.lowest_elevation_deg, 89.0))
    azimuth = between(rng, -0.6, 0.6)
    roll = np.radians(pick(rng, ((6, rng.normal(0, 6)), (2, rng.normal(0, 30)), (1, rng.uniform(-180, 180)))))
    spread_px = np.array([110.0, 75.0]) * between(rng, 0, 1.3)
    room_px = np.array([260.0, 190.0])
    if not get_category(scene.shape.category).background:
        distance = _segmented_distance(scene.shape, distance, between(rng, 1.05, 1.8))
        room_px = np.maximum(room_px - 0.35 * camera.focal_px * scene.shape.scale / distance, 20.0)
    offset = np.clip(rng.normal(0, spread_px), -room_px, room_px) / camera.focal_px
    return Orbit(distance, float(elevation), azimuth, float(roll), (float(offset[0]), float(offset[1])))


def _segmented_distance(shape: Shape, distance: float, nearest: float) -> float:
    """Far enough to see most of the object (`nearest` times its scale), near enough for it to have some points."""
    near = min(max(distance, nearest * shape.scale), max(FARTHEST_SCALES * shape.scale, 0.35))
    return min(near, farthest_distance(shape))


def farthest_distance(shape: Shape) -> float:
    """Depth of the object's centre beyond which its far side would leave what shards and recordings store, metres."""
    return STORED_DEPTH_M - max(_reach(posed_parts(shape, shape.joint_limits[:, end])) for end in (0, 1))


def _reach(parts: list[Mesh]) -> float:
    """Largest distance from the object's centre, metres."""
    return max(float(np.linalg.norm(mesh.vertices, axis=1).max()) for mesh in parts)


def photograph(
    scene: Scene,
    camera: Camera,
    orbit: Orbit,
    noise: DepthNoise,
    rng: np.random.Generator,
    options: ViewOptions,
    motion: tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, " 3"]] | None = None,
) -> View:
    """Take one frame; `motion` (R_world_object, position of the object's centre in the world) overrides the scene's."""
    world_rotation, world_translation = motion or (scene.rotation, np.zeros(3))
    view_rotation, view_translation = orbit.rotation, orbit.translation
    rotation = view_rotation @ world_rotation
    center = view_rotation @ world_translation + view_translation
    parts = posed_parts(scene.shape, scene.joint_values)
    segmented = not get_category(scene.shape.category).background
    radius = _reach(parts) + FRINGE_M if segmented else ball_radius(scene.shape.scale)
    bodies = [mesh.moved(rotation, center) for mesh in (*parts, *scene.attached) if len(mesh.faces)]
    bodies += [mesh.moved(view_rotation, view_translation) for mesh in scene.surroundings]
    patch = cast(_in_front(bodies), camera, center, radius, options.max_rays)
    patch = observe(patch, noise, rng)
    part_rotation, part_shift = part_motions(scene.shape, scene.joint_values)
    rest_centers = scene.shape.centers
    moved_centers = np.einsum("pij,pj->pi", part_rotation, rest_centers) + part_shift
    points, labels = _cloud(patch, len(parts), center, radius)
    if segmented:
        points, labels = keep_segment(points, labels, len(parts), options.stray_share, rng)
    count = int(rng.integers(options.points[0], options.points[1] + 1))
    if len(points) > count:
        chosen = rng.permutation(len(points))[:count]
        points, labels = points[chosen], labels[chosen]
    return View(
        points=points,
        labels=labels,
        rotation=(rotation @ part_rotation).astype(np.float32),
        translation=(moved_centers @ rotation.T + center).astype(np.float32),
        size=scene.shape.sizes,
        joint_values=scene.joint_values.astype(np.float32),
    )


def _in_front(bodies: list[Mesh]) -> list[Mesh]:
    """Drop bodies that the camera stands in, so that the inside of clutter does not fill the image."""
    kept = []
    for mesh in bodies:
        low, high = mesh.bounds()
        inside = bool((low < 0.02).all() and (high > -0.02).all())
        kept.append(Mesh(mesh.vertices + np.float32(1e3), mesh.faces) if inside else mesh)
    return kept


def _cloud(
    patch: DepthPatch, parts: int, center: Float[np.ndarray, " 3"], radius: float
) -> tuple[Float32[np.ndarray, "N 3"], UInt8[np.ndarray, " N"]]:
    """All points within a ball, and what each belongs to."""
    seen = patch.depth > 0
    points = (patch.directions() * patch.depth[..., None])[seen]
    body = patch.body[seen]
    inside = np.einsum("ij,ij->i", points - center, points - center) < radius * radius
    points, body = points[inside], body[inside]
    labels = np.where((body >= 0) & (body < parts), body, parts).astype(np.uint8)
    return points.astype(np.float32), labels

"""Simulated sequences with smooth motion, as recordings: for evaluation on instances that training never saw."""

from dataclasses import replace
from typing import Literal

import numpy as np
from jaxtyping import Float64

from captra.categories import get_category
from captra.data.depth_camera import PERFECT, draw_noise
from captra.data.joint_states import draw_joint_path
from captra.data.recordings import Recording
from captra.data.rendering import Camera
from captra.data.scenes import Scene, held_scene, standalone_scene, table_scene
from captra.data.shapes.draws import between
from captra.data.shapes.shape import Shape
from captra.data.view import View
from captra.data.views import HiddenObjectError, Orbit, ViewOptions, draw_orbit, farthest_distance, photograph
from captra.geometry import axis_angle
from captra.perturbation import perturb

Motion = Literal["hand", "table", "alone"]

FRAMES_PER_SECOND = 30
POINTS = 10_000
"""Of each cloud, as far as the camera sees that many."""
REACH_M = 0.1
"""A held object stays about that near to where it started."""
LEAST_FIRST_POINTS = 150
LEAST_POINTS = 40
LEAST_PART_POINTS = 12
"""Of each part of an articulated object in the first frame."""
ATTEMPTS = 40


def make_sequence(shape: Shape, rng_seed: int, frames: int = 100, motion: Motion = "hand") -> Recording:
    """Simulate `frames` frames at 30 Hz; the same arguments give the same recording.

    `hand`: a hand moves the object at up to 0.3 m/s and 60°/s in front of a camera that hardly moves. `table`: the
    object rests and the camera moves around it. `alone`: the object moves as if held, by itself before a perfect
    camera, as in the paper's articulated dataset (Sec. "Articulated Objects from SAPIEN"). Joints change by about the
    paper's average. The first pose is the truth of frame 0, perturbed as the category says.

    Raises:
        HiddenObjectError: if no attempt keeps the object in sight.
    """
    rng = np.random.default_rng([rng_seed, *shape.category.encode(), *motion.encode()])
    for _ in range(ATTEMPTS):
        views = _film(shape, rng, frames, motion)
        seen = [int((view.labels < len(shape.parts)).sum()) for view in views]
        if len(seen) == frames and seen[0] >= LEAST_FIRST_POINTS:
            return _recording(shape, views, rng, f"{shape.category}__procedural-{rng_seed}__{motion}")
    raise HiddenObjectError(f"no {motion} sequence of this {shape.category} keeps it in sight: choose another seed")


def _film(shape: Shape, rng: np.random.Generator, frames: int, motion: Motion) -> list[View]:
    """Take frames until the object is out of sight."""
    joints = draw_joint_path(shape, frames, rng)
    scene = _scene(shape, joints[0], rng, motion)
    camera = Camera(focal_px=between(rng, 560, 630))
    noise = PERFECT if motion == "alone" else draw_noise(rng, strongest=1.0)
    orbits = _camera_path(rng, draw_orbit(scene, camera, rng), frames, motion, scene)
    rotations, translations = _object_path(rng, scene, frames, motion)
    options = ViewOptions(points=(POINTS, POINTS), stray_share=0.0)
    views: list[View] = []
    for i in range(frames):
        moved = replace(scene, joint_values=joints[i])
        view = photograph(moved, camera, orbits[i], noise, rng, options, (rotations[i], translations[i]))
        if (view.labels < len(shape.parts)).sum() < LEAST_POINTS or (i == 0 and _hides_a_part(view)):
            break
        views.append(view)
    return views


def _scene(shape: Shape, joint_values: Float64[np.ndarray, " J"], rng: np.random.Generator, motion: Motion) -> Scene:
    if motion == "hand":
        return held_scene(shape, joint_values, rng, clearance=REACH_M)
    if motion == "table":
        return table_scene(shape, joint_values, rng)
    return standalone_scene(shape, joint_values, rng)


def _hides_a_part(view: View) -> bool:
    """Whether a part of an articulated object is out of sight: no track can start with it."""
    counts = np.bincount(view.labels, minlength=len(view.size))[: len(view.size)]
    return len(counts) > 1 and int(counts.min()) < LEAST_PART_POINTS


def smooth_walk(rng: np.random.Generator, frames: int, dimensions: int, peak_rate: float) -> Float64[np.ndarray, "F D"]:
    """Sums of slow sines from 0 whose speed peaks at `peak_rate` per second."""
    time = np.arange(frames) / FRAMES_PER_SECOND
    frequency = rng.uniform(0.1, 0.7, (3, dimensions))
    phase = rng.uniform(0, 2 * np.pi, (3, dimensions))
    weight = rng.normal(size=(3, dimensions)) / frequency
    path = (weight * np.sin(2 * np.pi * frequency * time[:, None, None] + phase)).sum(1)
    speed = np.linalg.norm(np.diff(path, axis=0), axis=1).max(initial=1e-9) * FRAMES_PER_SECOND
    return np.asarray((path - path[0]) * (peak_rate / speed))


def _object_path(
    rng: np.random.Generator, scene: Scene, frames: int, motion: Motion
) -> tuple[Float64[np.ndarray, "F 3 3"], Float64[np.ndarray, "F 3"]]:
    rotations = np.tile(scene.rotation, (frames, 1, 1))
    if motion == "table":
        return rotations, np.zeros((frames, 3))
    path = smooth_walk(rng, frames, 3, between(rng, 0.03, 0.3))
    path *= min(1.0, REACH_M / max(float(np.linalg.norm(path, axis=1).max()), 1e-9))
    turns = np.diff(smooth_walk(rng, frames, 3, np.radians(between(rng, 8, 60))), axis=0)
    for i, turn in enumerate(turns):
        angle = float(np.linalg.norm(turn))
        step = axis_angle(turn, angle) if angle > 1e-9 else np.eye(3)
        rotations[i + 1] = step @ rotations[i]
    return rotations, path


def _camera_path(rng: np.random.Generator, start: Orbit, frames: int, motion: Motion, scene: Scene) -> list[Orbit]:
    """Around the object for `table`, a slight sway for others."""
    rate, swing = (np.radians(between(rng, 5, 35)), 0.6) if motion == "table" else (np.radians(between(rng, 0, 4)), 0.1)
    angles = smooth_walk(rng, frames, 3, rate) * [1.0, 0.5, 0.3]
    angles *= min(1.0, swing / max(float(np.abs(angles).max()), 1e-9))
    nearer = smooth_walk(rng, frames, 1, 0.15 if motion == "table" else 0.02)[:, 0]
    nearer *= min(1.0, 0.2 / max(float(np.abs(nearer).max()), 1e-9))
    drift = smooth_walk(rng, frames, 2, 0.06 if motion == "table" else 0.01)
    drift *= min(1.0, 0.06 / max(float(np.abs(drift).max()), 1e-9))
    lowest, farthest = np.radians(scene.lowest_elevation_deg), farthest_distance(scene.shape)
    return [
        Orbit(
            distance=min(start.distance * float(1 + near), farthest),
            elevation=float(np.clip(start.elevation + angle[1], min(lowest, start.elevation), np.pi / 2)),
            azimuth=start.azimuth + float(angle[0]),
            roll=start.roll + float(angle[2]),
            offset=(0.7 * start.offset[0] + float(shift[0]), 0.7 * start.offset[1] + float(shift[1])),
        )
        for angle, near, shift in zip(angles, nearer, drift, strict=True)
    ]


def _recording(shape: Shape, views: list[View], rng: np.random.Generator, name: str) -> Recording:
    category = get_category(shape.category)
    return Recording(
        category=category,
        name=name,
        stamps_ns=np.arange(len(views), dtype=np.int64) * (1_000_000_000 // FRAMES_PER_SECOND),
        clouds=tuple(view.points for view in views),
        labels=tuple(view.labels for view in views),
        rotation=np.stack([view.rotation for view in views]),
        translation=np.stack([view.translation for view in views]),
        size=views[0].size,
        init=perturb(views[0].pose, category, rng),
        joint_values=np.stack([view.joint_values for view in views]),
    )

"""Pictures of posed boxes over depth images and clouds."""

from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, UInt16

from captra.geometry import Pose, box_corners

_EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if (a ^ b).bit_count() == 1]
_AXIS_COLOURS = ("tab:red", "tab:green", "tab:blue")


def cloud_from_depth(
    depth_mm: UInt16[np.ndarray, "height width"], K: Float[np.ndarray, "3 3"]
) -> Float[np.ndarray, "points 3"]:
    """Points of all pixels that have a depth, camera frame, metres."""
    v, u = np.nonzero(depth_mm)
    z = depth_mm[v, u] / 1000.0
    points = np.stack([(u - K[0, 2]) / K[0, 0] * z, (v - K[1, 2]) / K[1, 1] * z, z], axis=-1)
    return points.astype(np.float32)


def project(points: Float[np.ndarray, "points 3"], K: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "points 2"]:
    """Pixels of points in front of the camera."""
    homogeneous = points @ np.asarray(K, np.float64).T
    return np.asarray(homogeneous[:, :2] / homogeneous[:, 2:])


def draw_pose(axes: Any, pose: Pose, K: Float[np.ndarray, "3 3"], colour: str) -> None:
    """Draw every part's box and axes into a picture taken with K."""
    for part in range(pose.num_parts):
        rotation, centre, size = pose.rotation[part], pose.translation[part], pose.size[part]
        corners = project(box_corners(size) @ rotation.T + centre, K)
        for a, b in _EDGES:
            axes.plot(*corners[[a, b]].T, color=colour, linewidth=2)
        for axis, axis_colour in enumerate(_AXIS_COLOURS):
            tip = centre + 0.6 * size[axis] * rotation[:, axis]
            axes.plot(*project(np.stack([centre, tip]), K).T, color=axis_colour, linewidth=2)


def before_and_after(
    depth_mm: UInt16[np.ndarray, "height width"],
    K: Float[np.ndarray, "3 3"],
    poses: dict[str, tuple[Pose, str]],
    out: Path,
    margin_px: float = 90,
) -> None:
    """One panel a pose, titled by its key, with the box in its colour, around the first pose."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2 * len(poses), 4.6), layout="constrained")
    shown = np.where(depth_mm > 0, depth_mm, np.nan).astype(np.float64)
    first = next(iter(poses.values()))[0]
    corners = project(box_corners(first.size[0]) @ first.rotation[0].T + first.translation[0], K)
    (left, top), (right, bottom) = corners.min(axis=0) - margin_px, corners.max(axis=0) + margin_px
    near, far = 1000 * (first.translation[0, 2] - first.scale[0]), 1000 * (first.translation[0, 2] + 2 * first.scale[0])
    for axes, (title, (pose, colour)) in zip(np.atleast_1d(figure.subplots(1, len(poses))), poses.items(), strict=True):
        axes.imshow(shown, cmap="gray_r", vmin=near, vmax=far)
        draw_pose(axes, pose, K, colour)
        axes.set(title=title, xlim=(left, right), ylim=(bottom, top), xticks=[], yticks=[])
    figure.savefig(out, dpi=100)

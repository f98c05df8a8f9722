"""Lets a box settle on a mug in one frame of a real depth camera, from a rough pose given by hand.

    python benchmarks/real_mug.py path/to/red_mug.npz docs/images/tracked_mug.png

The file holds `depth_mm` (height, width) uint16 and `K` (3, 3). There is no ground truth: look at the picture.
"""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from captra.evaluation.picture import before_and_after, cloud_from_depth
from captra.geometry import Pose
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES
from captra.tracker import Tracker

Vector = tuple[float, float, float]


def rough_pose(centre: Vector, up: Vector, handle: Vector, size: Vector) -> Pose:
    """The pose of a mug that stands along `up` with its handle towards `handle`, camera frame, metres."""
    y = np.array(up) / np.linalg.norm(up)
    z = np.cross(handle, y)
    z /= np.linalg.norm(z)
    return Pose.from_size(np.stack([np.cross(y, z), y, z], axis=-1)[None], np.array([centre]), np.array([size]))


def main(
    frame: Annotated[Path, typer.Argument(help="One frame with depth_mm and K.")],
    out: Annotated[Path, typer.Argument(help="Picture to write.")],
    centre: Annotated[Vector, typer.Option(help="Centre of the box, m.")] = (-0.01, 0.03, 0.51),
    up: Annotated[Vector, typer.Option(help="Direction of the mug's axis.")] = (0.0, -0.9, -0.4),
    handle: Annotated[Vector, typer.Option(help="Direction of the handle.")] = (-1.0, 0.0, 0.1),
    size: Annotated[Vector, typer.Option(help="Size of the box, m.")] = (0.125, 0.11, 0.085),
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
    steps: Annotated[int, typer.Option(help="How often the same frame is given.")] = 30,
) -> None:
    """Track one frame over and over, print how the pose settles, and draw first and last pose."""
    with np.load(frame) as stored:
        depth_mm, K = stored["depth_mm"], stored["K"]
    cloud = cloud_from_depth(depth_mm, K)
    start = rough_pose(centre, up, handle, size)
    tracker = Tracker(OnnxNetworks.load(models / "mug", PROFILES["paper"], "cpu"), start)
    for step in range(1, steps + 1):
        result = tracker.step(cloud)
        centre_cm, size_cm = (
            ", ".join(f"{100 * v:.1f}" for v in row[0]) for row in (result.pose.translation, result.pose.size)
        )
        print(f"step {step:2d}: {result.state} ({result.confidence:.2f}), centre {centre_cm} cm, size {size_cm} cm")
    before_and_after(depth_mm, K, {"given": (start, "orange"), "tracked": (tracker.pose, "limegreen")}, out)


if __name__ == "__main__":
    typer.run(main)

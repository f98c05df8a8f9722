"""Draws the figures of docs/how-it-works.md from one step on a bundled recording.

python benchmarks/figures.py docs/images
"""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from matplotlib.figure import Figure

from captra.canonical import canonicalize
from captra.data.recordings import load_recording
from captra.evaluation.picture import draw_pose, project
from captra.geometry import Pose, box_corners
from captra.looking import choose_points, predict
from captra.observations import PointCloud
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES, build_neighborhoods
from captra.tracker import Tracker

ROOT = Path(__file__).resolve().parents[1]
RECORDING = ROOT / "recordings" / "mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"
K = np.array([[590.0, 0, 320], [0, 590, 240], [0, 0, 1]])
GIVEN, TRACKED = "tab:orange", "limegreen"
"""Colours of the last pose and the new one."""


def main(
    out: Annotated[Path, typer.Argument(help="Folder of the figures.")],
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = ROOT / "models",
) -> None:
    """Track the beginning of the recording and draw its first step."""
    recording = load_recording(RECORDING)
    networks = OnnxNetworks.load(models / recording.category.name, PROFILES["paper"], "cpu")
    cloud, last = recording.clouds[0], recording.init
    draw_step(networks, cloud, last, Tracker(networks, last).step(cloud).pose, out)
    draw_canonical(cloud, last, recording.truth(0), out)
    print(f"step.png and canonicalization.png are in {out}")


def draw_step(networks: OnnxNetworks, cloud: np.ndarray, last: Pose, new: Pose, out: Path) -> None:
    """Three panels as the camera sees them: crop and last pose, what CoordinateNet says, new pose."""
    crop = choose_points(
        PointCloud.of(cloud), last, networks.category, networks.profile.points, networks.input_sampling
    )
    canonical = canonicalize(crop.points, last)
    prediction = predict(networks, canonical, [build_neighborhoods(canonical[0], networks.profile)])
    mine, pixels = prediction.labels == 0, project(crop.points, K)
    colours = np.clip(prediction.coordinates[0][mine] + 0.5, 0, 1)
    panels = (figure := Figure(figsize=(12, 4), layout="constrained")).subplots(1, 3)
    panels[0].scatter(*pixels.T, s=3, color="0.6")
    draw_pose(panels[0], last, K, GIVEN)
    panels[1].scatter(*pixels[~mine].T, s=3, color="0.85")
    panels[1].scatter(*pixels[mine].T, s=4, color=colours)
    panels[2].scatter(*pixels[~mine].T, s=3, color="0.85")
    panels[2].scatter(*pixels[mine].T, s=3, color="0.5")
    draw_pose(panels[2], new, K, TRACKED)
    for axes, title in zip(panels, ("crop and last pose", "CoordinateNet", "new pose"), strict=True):
        axes.set(title=title, xticks=[], yticks=[])
        axes.set_aspect("equal")
        axes.invert_yaxis()
    figure.savefig(out / "step.png", dpi=80)


def draw_canonical(cloud: np.ndarray, last: Pose, truth: Pose, out: Path) -> None:
    """The same points in the camera's frame and in that of the last pose, with the true box."""
    figure = Figure(figsize=(9, 4), layout="constrained")
    seen, canonical = (figure.add_subplot(1, 2, column, projection="3d") for column in (1, 2))
    corners = box_corners(truth.size[0]) @ truth.rotation[0].T + truth.translation[0]
    shown = cloud[np.linalg.norm(cloud - truth.translation[0], axis=1) < 0.55 * truth.scale[0]]
    for axes, transform, title in (
        (seen, lambda points: points, "as the camera sees it (m)"),
        (canonical, lambda points: canonicalize(points, last)[0], "in the last pose's frame (box diagonals)"),
    ):
        points, box = transform(shown), transform(corners)
        x, y, z = points.T
        axes.scatter(x, z, -y if axes is seen else y, s=2, color="0.5")
        for a in range(8):
            for b in range(a + 1, 8):
                if (a ^ b).bit_count() == 1:
                    x, y, z = box[[a, b]].T
                    axes.plot(x, z, -y if axes is seen else y, color=TRACKED)
        axes.set_aspect("equal")
        axes.set_title(title)
        axes.locator_params(nbins=4)
    figure.savefig(out / "canonicalization.png", dpi=80)


if __name__ == "__main__":
    typer.run(main)

"""Draws instances of a category side by side: what generators make, and objects of a mesh library to compare them with.

python benchmarks/contact_sheet.py glasses --meshes ../shared/meshes --out glasses.png
"""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from jaxtyping import Float64
from matplotlib import colormaps
from matplotlib.figure import Figure

from captra.data.meshes import Use, load_meshes
from captra.data.rendering import NOTHING, Camera, cast
from captra.data.shapes.kinematics import part_motions
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.registry import make_shape
from captra.data.shapes.shape import Shape
from captra.geometry import axis_angle

CAMERA = Camera(focal_px=700.0, width=200, height=200)
COLUMNS = 8
SEED = 7
T_CAMERA_VIEW = np.diag([1.0, -1.0, -1.0])
"""Object axes with y up, seen from in front, in a camera whose y points down."""


def main(
    category: Annotated[str, typer.Argument(help="What to draw, e.g. glasses.")],
    out: Annotated[Path, typer.Option(help="The picture.")] = Path("contact_sheet.png"),
    meshes: Annotated[Path | None, typer.Option(help="Mesh library; its objects stand in the first rows.")] = None,
    count: Annotated[int, typer.Option(help="Procedural instances.")] = 40,
) -> None:
    """Draw every instance once, each from a direction of its own, with its joints somewhere in their limits."""
    rng = np.random.default_rng(SEED)
    uses: tuple[Use, ...] = ("train", "validate")
    library = [] if meshes is None else [mesh for use in uses for mesh in load_meshes(meshes, category, use)]
    shapes = [(mesh.name.partition("__")[2][:24], mesh.shape) for mesh in library]
    shapes += [("", make_shape(category, rng)) for _ in range(count)]
    rows = -(-len(shapes) // COLUMNS)
    figure = Figure(figsize=(2 * COLUMNS, 2 * rows), layout="constrained")
    axes = list(figure.subplots(rows, COLUMNS, squeeze=False).flat)
    for axis in axes:
        axis.set_axis_off()
    for axis, (name, shape) in zip(axes, shapes, strict=False):
        axis.imshow(drawn(shape, rng))
        axis.set_title(name, fontsize=6)
    figure.savefig(out, dpi=100)
    print(f"{len(library)} library objects and {count} procedural ones are in {out}")


def drawn(shape: Shape, rng: np.random.Generator) -> Float64[np.ndarray, "H W 3"]:
    """RGB in [0, 1]: one hue a part, darker where a surface is seen at a grazing angle."""
    low, high = shape.joint_limits.T
    rotations, translations = part_motions(shape, rng.uniform(low, high))
    parts = [part.moved(*motion) for part, *motion in zip(shape.parts, rotations, translations, strict=True)]
    whole = merged(parts).bounds()
    view = T_CAMERA_VIEW @ axis_angle(np.array([1.0, 0, 0]), rng.uniform(0.1, 0.9))
    view = view @ axis_angle(np.array([0, 1.0, 0]), rng.uniform(-1.0, 1.0))
    distance = 1.3 * float(np.linalg.norm(np.ptp(whole, axis=0))) * CAMERA.focal_px / CAMERA.width / 1.5
    center = np.array([0, 0, distance])
    posed = [Mesh(*part).moved(view, center - view @ whole.mean(0)) for part in parts]
    patch = cast(posed, CAMERA, center, distance, CAMERA.width * CAMERA.height)
    hues = np.array([colormaps["Set2"](body)[:3] for body in range(len(posed))])
    image: Float64[np.ndarray, "H W 3"] = hues[np.maximum(patch.body, 0)] * (0.25 + 0.75 * patch.cosine[..., None])
    image[patch.body == NOTHING] = 1.0
    return image


if __name__ == "__main__":
    typer.run(main)

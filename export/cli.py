"""`captra export` and `captra step`."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from captra.learn.plan import NetworkName

Checkpoint = Annotated[Path, typer.Option(exists=True, dir_okay=False, help="A .pt file, the authors' or ours.")]
OtherCheckpoint = Annotated[
    Path | None, typer.Option(exists=True, dir_okay=False, help="A .pt file: the network that the bundle is to have.")
]


Precision = Annotated[
    str, typer.Option(help="How weights are stored: float32, float16, int8, int6, int5, int4 or int3.")
]
Views = Annotated[
    Path | None,
    typer.Option(
        exists=True, file_okay=False, help="Views, on which errors of rounding to whole numbers are made up for."
    ),
]


def export(
    coordinate: Checkpoint,
    rotation: Checkpoint,
    category: Annotated[str, typer.Option(help="What they were trained on, e.g. mug.")],
    out: Annotated[Path, typer.Option(help="Folder of the bundle, e.g. models/mug.")],
    precision: Precision = "float16",
    views: Views = None,
    notes: Annotated[
        Path | None,
        typer.Option(
            exists=True, dir_okay=False, help="JSON with entries of the manifest to set, e.g. scores or health."
        ),
    ] = None,
) -> None:
    """Write the networks of two checkpoints as an ONNX bundle, and compare both at every profile.

    Example: captra export --coordinate coordinate.pt --rotation rotation.pt --category mug --out models/mug
    """
    with errors_for_people():
        from captra.categories import get_category
        from export.bundles import export_bundle
        from export.notes import with_notes
        from export.parity import Difference
        from export.seen import MadeUpFor, to_nearest

        def report(profile: str, difference: Difference) -> None:
            typer.echo(
                f"{profile}: differs from PyTorch by at most {difference.segmentation:.1e} in probabilities, "
                f"{difference.coordinates:.1e} in coordinates, {difference.mean_rotation_deg:.1e}° in mean rotations"
            )

        describe = with_notes(notes)
        chosen = get_category(category)
        rounding = to_nearest if views is None else MadeUpFor.on(chosen, views)
        manifest = export_bundle(
            coordinate, rotation, chosen, precision, out, rounding=rounding, describe=describe, report=report
        )
        typer.echo(f"wrote {out}: {', '.join(manifest.sha256)}, weights in {precision}")


def replace_network(
    bundle: Annotated[Path, typer.Option(exists=True, file_okay=False, help="Folder of the bundle that changes.")],
    coordinate: OtherCheckpoint = None,
    rotation: OtherCheckpoint = None,
    precision: Precision = "int8",
    views: Views = None,
) -> None:
    """Give a bundle another CoordinateNet or RotationNet and keep the other; what was measured of both goes.

    Example: captra replace-network --rotation .campaign/runs/mug/anew/rotation.pt --bundle models/mug
    """
    with errors_for_people():
        from captra.categories import get_category
        from captra.runtime.bundle import load_manifest
        from export import bundles
        from export.parity import Difference
        from export.seen import MadeUpFor, to_nearest

        name, checkpoint = _the_one(coordinate, rotation)

        def report(profile: str, difference: Difference) -> None:
            typer.echo(
                f"{profile}: differs from PyTorch by at most {difference.coordinates:.1e} in coordinates, "
                f"{difference.mean_rotation_deg:.1e}° in mean rotations"
            )

        category = get_category(load_manifest(bundle).category)
        rounding = to_nearest if views is None else MadeUpFor.on(category, views)
        manifest = bundles.replace_network(name, checkpoint, precision, bundle, rounding=rounding, report=report)
        typer.echo(
            f"{bundle} has another network for {name}, weights in {precision}; next: captra fuse --category "
            f"{manifest.category}, captra calibrate, captra evaluate --write-scores"
        )


def _the_one(coordinate: Path | None, rotation: Path | None) -> "tuple[NetworkName, Path]":
    if coordinate is not None and rotation is None:
        return "coordinate", coordinate
    if rotation is not None and coordinate is None:
        return "rotation", rotation
    raise typer.BadParameter("say either --coordinate FILE or --rotation FILE; both make a bundle: captra export")


def step(
    bundle: Annotated[Path, typer.Argument(exists=True, file_okay=False, help="Folder of a bundle.")],
    source: Annotated[
        Path, typer.Argument(metavar="IN.npz", exists=True, dir_okay=False, help="Points and last pose.")
    ],
    target: Annotated[Path, typer.Argument(metavar="OUT.npz", help="Where the answers go.")],
    provider: Annotated[str, typer.Option(help="cpu, openvino, cuda or auto.")] = "cpu",
) -> None:
    """Run one step on given arrays, without cropping or resampling, at the neighbourhoods of the profile `paper`.

    IN.npz holds `points` (N, 3) in farthest-point order, `last_scale` (P,), `last_rotation` (P, 3, 3) and
    `last_translation` (P, 3); metres.

    Example: captra step models/mug in.npz out.npz
    """
    with errors_for_people():
        import numpy as np

        from captra.archives import read_arrays
        from captra.runtime.bundle import load_manifest
        from captra.runtime.onnx_networks import OnnxNetworks
        from export.step import check_inputs, profile_for, step_arrays

        arrays = read_arrays(source)
        check_inputs(arrays, len(load_manifest(bundle).parts))
        networks = OnnxNetworks.load(bundle, profile_for(arrays["points"]), provider)
        answers = step_arrays(networks, arrays)
        with target.open("wb") as file:
            np.savez_compressed(file, allow_pickle=False, **answers)
        typer.echo(f"wrote {target}")


@contextmanager
def errors_for_people() -> Iterator[None]:
    """Errors that say what to do are printed without a traceback, and end the command with status 1."""
    try:
        yield
    except (ValueError, OSError) as error:
        typer.echo(f"Error: {error}", err=True)
        raise typer.Exit(1) from error

"""From two checkpoints to a bundle that was compared with them."""

import shutil
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import onnx

from captra.categories import Category, get_category
from captra.learn.checkpoint import load_coordinate_net, load_rotation_net
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.from_bundle import coordinate_net_of_graph, rotation_net_of_graph
from captra.learn.networks import TorchNetworks
from captra.learn.plan import NetworkName
from captra.learn.rotation_net import RotationNet
from captra.runtime.bundle import COORDINATE, ROTATION, Manifest, load_manifest, sha256_of, verify, write_manifest
from captra.runtime.onnx_networks import OnnxNetworks
from captra.sampling import PROFILES
from export.graph import OPSET
from export.onnx_export import coordinate_model, rotation_model
from export.parity import Difference, require_parity
from export.provenance import input_sampling_of, rotation_fusion_of, rotation_share_of, training_of, with_network
from export.seen import RoundingOf, to_nearest


def unchanged(manifest: Manifest) -> Manifest:
    """Add nothing to what the checkpoints say."""
    return manifest


def silent(_profile: str, _difference: Difference) -> None:
    """Tell nobody."""


def export_bundle(
    coordinate: Path,
    rotation: Path,
    category: Category,
    precision: str,
    out: Path,
    *,
    rounding: RoundingOf = to_nearest,
    describe: Callable[[Manifest], Manifest] = unchanged,
    report: Callable[[str, Difference], None] = silent,
) -> Manifest:
    """Write a bundle; the folder appears only once its graphs agree with the checkpoints at every profile.

    Args:
        coordinate: CoordinateNet's checkpoint, of the authors or ours.
        rotation: RotationNet's.
        category: of both.
        precision: of the stored weights: float32, float16, int8, int6, int5, int4 or int3.
        out: the bundle's folder; its three files are replaced if they are there.
        rounding: of weights that become whole numbers.
        describe: what to change in the manifest before it is written.
        report: told how far ONNX Runtime and PyTorch are apart at each profile.

    Raises:
        CheckpointError: a checkpoint does not fit.
        PrecisionError: the precision is unknown or too narrow.
        ParityError: the graphs compute something else than the checkpoints.
    """
    coordinate_net, rotation_net = load_coordinate_net(coordinate, category), load_rotation_net(rotation, category)
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f".{out.name}-", dir=out.parent) as scratch:
        folder = Path(scratch)
        onnx.save(coordinate_model(coordinate_net, precision, rounding(coordinate_net)), folder / COORDINATE)
        onnx.save(rotation_model(rotation_net, precision, rounding(rotation_net)), folder / ROTATION)
        manifest = describe(
            Manifest(
                category=category.name,
                parts=category.parts,
                symmetric=category.symmetric,
                precision=precision,
                opset=OPSET,
                sha256={name: sha256_of(folder / name) for name in (COORDINATE, ROTATION)},
                training=training_of(coordinate, rotation),
                input_sampling=input_sampling_of(coordinate),
                rotation_fusion=rotation_fusion_of(coordinate),
                rotation_share=rotation_share_of(rotation),
            )
        )
        _publish(folder, manifest, coordinate_net, rotation_net, precision, out, report)
    return manifest


def replace_network(
    name: NetworkName,
    checkpoint: Path,
    precision: str,
    bundle: Path,
    *,
    rounding: RoundingOf = to_nearest,
    report: Callable[[str, Difference], None] = silent,
) -> Manifest:
    """Give a bundle another CoordinateNet or RotationNet; the network that stays does so to the byte.

    What was measured of the bundle (scores, calibration, found errors) is no longer true, and goes.

    Args:
        name: of the network that is replaced.
        checkpoint: of a network that fits the bundle's category, as `captra train --only` leaves it.
        precision: of its stored weights: float32, float16, int8, int6, int5, int4 or int3.
        bundle: the folder; changed once the new graph agrees with the checkpoint at every profile.
        rounding: of weights that become whole numbers.
        report: told how far ONNX Runtime and PyTorch are apart at each profile.

    Raises:
        BundleError: the folder holds no whole bundle.
        CheckpointError: the checkpoint does not fit.
        PrecisionError: the precision is unknown or too narrow.
        ParityError: the graphs compute something else.
    """
    before = load_manifest(bundle)
    verify(bundle, before)
    category = get_category(before.category)
    if name == "rotation":
        coordinate_net = coordinate_net_of_graph(bundle / COORDINATE, category)
        rotation_net = load_rotation_net(checkpoint, category)
        replaced, graph = ROTATION, rotation_model(rotation_net, precision, rounding(rotation_net))
        changed = replace(before, rotation_share=rotation_share_of(checkpoint))
    else:
        coordinate_net = load_coordinate_net(checkpoint, category)
        rotation_net = rotation_net_of_graph(bundle / ROTATION, category)
        replaced, graph = COORDINATE, coordinate_model(coordinate_net, precision, rounding(coordinate_net))
        changed = replace(before, input_sampling=input_sampling_of(checkpoint))
    with tempfile.TemporaryDirectory(prefix=f".{bundle.name}-", dir=bundle.parent) as scratch:
        folder = Path(scratch)
        for file in (COORDINATE, ROTATION):
            shutil.copy2(bundle / file, folder / file)
        onnx.save(graph, folder / replaced)
        manifest = replace(
            changed,
            precision=_with_precision(before.precision, name, precision),
            sha256={file: sha256_of(folder / file) for file in (COORDINATE, ROTATION)},
            training=with_network(before.training, name, checkpoint),
            scores=(),
            health={},
            found_error={},
        )
        _publish(folder, manifest, coordinate_net, rotation_net, precision, bundle, report)
    return manifest


def _with_precision(before: str, name: NetworkName, precision: str) -> str:
    """Of both networks, CoordinateNet's first; said once if it is the same."""
    first, *second = before.split(" and ")
    both = (precision, *(second or [first])) if name == "coordinate" else (first, precision)
    return " and ".join(dict.fromkeys(both))


def _publish(
    folder: Path,
    manifest: Manifest,
    coordinate_net: CoordinateNet,
    rotation_net: RotationNet,
    precision: str,
    out: Path,
    report: Callable[[str, Difference], None],
) -> None:
    """Move a bundle to its place once its graphs agree with the networks at every profile."""
    write_manifest(folder, manifest)
    category = get_category(manifest.category)
    for profile in PROFILES.values():
        torch_networks = TorchNetworks(
            category, profile, coordinate_net, rotation_net, rotation_share=manifest.rotation_share
        )
        exported = OnnxNetworks.load(folder, profile, provider="cpu")
        asked_once = replace(exported, manifest=replace(manifest, mirror="none"))
        report(profile.name, require_parity(torch_networks, asked_once, precision))
    out.mkdir(exist_ok=True)
    for path in sorted(folder.iterdir()):
        shutil.move(path, out / path.name)

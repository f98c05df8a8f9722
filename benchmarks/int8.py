"""A trial of 8-bit integers against bfloat16: the mug's networks quantized, their speed and what they score.

    python -m benchmarks.int8 --provider openvino --recordings path/to/recordings

Every product of groups and centroids is quantized, but those that read coordinates: static ranges, weights per channel,
measured on simulated validation sequences that are neither trained on nor scored. `--out` keeps the quantized bundle,
which a service can be given by CAPTRA_MODELS_DIR.
"""

import shutil
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import onnx
import typer
from jaxtyping import Float32
from onnx import numpy_helper
from rich.console import Console
from rich.table import Table

from benchmarks.steps import timed
from captra.bench.machine import this_machine
from captra.evaluation.followers.served import Served
from captra.evaluation.runner import ExportedNetworks, mean_over
from captra.evaluation.sequence_cache import SequenceCache
from captra.evaluation.sequences import VALIDATION_SEED, procedural, recordings_in
from captra.evaluation.workers import workers
from captra.runtime.bundle import COORDINATE, ROTATION, load_manifest, sha256_of, write_manifest
from captra.runtime.cores import available_cores
from captra.runtime.onnx_networks import Feed, OnnxNetworks, feed
from captra.sampling import REALTIME, Neighborhoods

FEWEST_INPUTS = 32
"""Products of fewer columns read coordinates, which 8 bits are too coarse for; they cost nothing anyway."""

KEPT = ("up1", "last", "hidden", "segmentation", "coordinates", "heads")
"""Layers of single points; OpenVINO (2025.4) does not answer right when they are left alone either."""


def main(
    recordings: Annotated[Path, typer.Option(help="Folder of recordings to score on.")] = Path("recordings"),
    provider: Annotated[list[str] | None, typer.Option(help="cpu, openvino; both by default.")] = None,
    category: Annotated[str, typer.Option(help="Of the bundle.")] = "mug",
    models: Annotated[Path, typer.Option(help="Folder of bundles.")] = Path("models"),
    cache: Annotated[Path, typer.Option(help="Folder that keeps simulated sequences.")] = Path(".campaign/sequences"),
    sequences: Annotated[int, typer.Option(help="To measure ranges on.")] = 2,
    frames: Annotated[int, typer.Option(help="Of each of them.")] = 45,
    every: Annotated[int, typer.Option(help="Take every so many frames for it.")] = 3,
    repetitions: Annotated[int, typer.Option(help="Of the networks, timed.")] = 40,
    out: Annotated[Path | None, typer.Option(help="Folder of bundles to keep the quantized one in.")] = None,
) -> None:
    """Print speed and scores of the bundle as it is and quantized."""
    machine, console = this_machine(), Console(width=120)
    console.print(f"{machine.cpu}, {machine.cores} cores, Python {machine.python}, {machine.packages}")
    columns = ("provider", "networks", "ms, p10 / p50", "5°5cm", "mIoU", "R", "T cm")
    result = Table(*columns, title=f"{category}, realtime", title_justify="left")
    with tempfile.TemporaryDirectory() as folder:
        quantized = (out or Path(folder)) / category
        sources = list(procedural(category, sequences, SequenceCache.open(cache), frames, VALIDATION_SEED))
        examples = list(seen_by_networks(models / category, sources, every))
        console.print(f"ranges from {len(examples)} frames")
        quantize_bundle(models / category, quantized, examples)
        for name in provider or ["cpu", "openvino"]:
            for label, bundle in (("as shipped", models / category), ("8 bits", quantized)):
                networks = OnnxNetworks.load(bundle, REALTIME, name)
                arithmetic = "" if bundle == quantized else f", {networks.provider.arithmetic}"
                result.add_row(
                    name,
                    label + arithmetic,
                    speed(networks, examples[0], repetitions),
                    *scores(bundle, name, recordings),
                )
    console.print(result)


Seen = tuple[Float32[np.ndarray, "parts points 3"], Sequence[Neighborhoods]]


class Watched:
    """Networks that note down what they are asked."""

    def __init__(self, networks: OnnxNetworks) -> None:
        self._networks = networks
        self.seen: list[Seen] = []

    def __getattr__(self, name: str) -> Any:
        return getattr(self._networks, name)

    def rotations(
        self, points_canonical: Float32[np.ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Any:
        """As the networks answer."""
        self.seen.append((points_canonical, neighborhoods))
        return self._networks.rotations(points_canonical, neighborhoods)


def seen_by_networks(bundle: Path, sources: Sequence[Any], every: int) -> Iterator[Seen]:
    """What the networks read in the course of whole sequences."""
    for source in sources:
        watched = Watched(OnnxNetworks.load(bundle, REALTIME, "cpu"))
        Served()(watched, source.load())
        yield from watched.seen[::every]


def feeds_of(seen: Seen, rotated_points: int, root: int) -> dict[str, Feed]:
    """The inputs of both graphs, by file."""
    clouds, neighborhoods = seen
    rotation = feed(clouds, neighborhoods)
    rotation["nearest1"] = rotation["nearest1"][:, :rotated_points]
    return {COORDINATE: feed(clouds[root][None], [neighborhoods[root]]), ROTATION: rotation}


class Examples:
    """Inputs of one graph, as onnxruntime's quantization asks for them."""

    def __init__(self, feeds: Sequence[Feed]) -> None:
        self._feeds = iter(feeds)

    def get_next(self) -> Feed | None:
        """One after the other."""
        return next(self._feeds, None)


def quantize_bundle(source: Path, target: Path, examples: Sequence[Seen]) -> None:
    """The same bundle with quantized graphs."""
    shutil.copytree(source, target, dirs_exist_ok=True)
    networks = OnnxNetworks.load(source, REALTIME, "cpu")
    feeds = [feeds_of(seen, networks.rotated_points, networks.category.root) for seen in examples]
    for name in (COORDINATE, ROTATION):
        quantize_graph(source / name, target / name, [each[name] for each in feeds])
    manifest = load_manifest(target)
    digests = {name: sha256_of(target / name) for name in (COORDINATE, ROTATION)}
    write_manifest(target, replace(manifest, precision="int8", sha256=digests))


def quantize_graph(source: Path, target: Path, feeds: Sequence[Feed]) -> None:
    """Quantize inputs and weights of every product that is wide enough; answers stay floating-point numbers."""
    from onnxruntime.quantization import CalibrationMethod, QuantFormat, QuantType, quantize_static

    model = with_float_weights(onnx.load(source))
    weights = {each.name: each.dims for each in model.graph.initializer}
    products = [
        node.name
        for node in model.graph.node
        if node.op_type in ("MatMul", "Gemm")
        and weights[node.input[1]][0] >= FEWEST_INPUTS
        and not node.input[1].startswith(KEPT)
    ]
    with tempfile.TemporaryDirectory() as folder:
        plain = Path(folder, source.name)
        onnx.save(model, plain)
        quantize_static(
            plain,
            target,
            Examples(feeds),
            quant_format=QuantFormat.QDQ,
            activation_type=QuantType.QUInt8,
            weight_type=QuantType.QInt8,
            per_channel=True,
            nodes_to_quantize=products,
            calibrate_method=CalibrationMethod.MinMax,
            extra_options={"OpTypesToExcludeOutputQuantization": ["MatMul", "Gemm"], "WeightSymmetric": True},
        )


def with_float_weights(model: onnx.ModelProto) -> onnx.ModelProto:
    """Weights that are cast when the model is loaded, and multiplied by a scale if they are whole, as float32."""
    graph = model.graph
    stored = {each.name: each for each in graph.initializer}
    casts = [node for node in graph.node if node.op_type == "Cast" and node.input[0] in stored]
    for cast in casts:
        values = numpy_helper.to_array(stored[cast.input[0]]).astype(np.float32)
        turned = cast.output[0]
        for multiplied in [node for node in graph.node if node.op_type == "Mul" and node.input[0] == turned]:
            values = values * numpy_helper.to_array(stored[multiplied.input[1]])
            turned = multiplied.output[0]
            graph.node.remove(multiplied)
        graph.initializer.append(numpy_helper.from_array(values, turned))
        graph.node.remove(cast)
    for name in {cast.input[0] for cast in casts}:
        graph.initializer.remove(stored[name])
    return model


def speed(networks: OnnxNetworks, example: Seen, repetitions: int) -> str:
    """Both networks, side by side as a frame has them."""
    clouds, neighborhoods = example
    root = networks.category.root
    coordinates = partial(networks.coordinates, clouds[root], neighborhoods[root])
    rotations = partial(networks.rotations, clouds, neighborhoods)
    return timed(partial(networks.side_by_side, coordinates, rotations), repetitions)


def scores(bundle: Path, provider: str, recordings: Path) -> tuple[str, ...]:
    """Means over the recordings of the category."""
    networks = ExportedNetworks(bundle, REALTIME.name, provider, available_cores())
    sources = list(recordings_in(recordings, bundle.name))
    with workers(1) as here:
        mean = mean_over(bundle.name, networks, sources, here)
    return (
        f"{mean.within_5deg_5cm_percent:.1f} %",
        f"{mean.iou_oriented_percent:.1f} %",
        f"{mean.rotation_deg:.2f}°",
        f"{mean.translation_cm:.2f}",
    )


if __name__ == "__main__":
    typer.run(main)

"""Checkpoints: our own, and the authors' released ones, whose entries are renamed, folded and checked one by one."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from pickle import UnpicklingError
from typing import Any, cast

import torch
from torch import Tensor, nn

from captra.architecture import GLOBAL_CHANNELS, HEAD_CHANNELS, LEVEL1_CHANNELS, LEVEL2_CHANNELS, XYZ
from captra.categories import Category
from captra.errors import UserError
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.rotation_net import RotationNet

AUTHORS_PREFIX = "net."
DOUBLED_SKIP = "net.backbone.fp1.mlp_convs.0"
"""The last skip connection of the authors' CoordinateNet holds xyz twice."""

ADVICE = "check that the two networks' files are not swapped and that the category is the one they were trained on"

StateDict = Mapping[str, Tensor]


class CheckpointError(UserError, ValueError):
    """A checkpoint that does not fit the network; the message says what to do."""


@dataclass(frozen=True)
class _Layer:
    """Where one layer stands in both layouts; `norm` is empty where the layer has none."""

    ours: str
    linear: str
    norm: str = ""
    our_norm: str = ""

    @property
    def batch_norm(self) -> bool:
        return bool(self.norm) and not self.our_norm


def load_coordinate_net(path: Path, category: Category) -> CoordinateNet:
    """Read a CoordinateNet from a checkpoint of either layout, in evaluation mode.

    Raises:
        CheckpointError: the file is no checkpoint, or one of another network or category.
    """
    network = CoordinateNet(category.num_parts, category.num_classes)
    _load(network, path, list(_coordinate_layers()), f"the CoordinateNet of {category.name}")
    return network


def load_rotation_net(path: Path, category: Category) -> RotationNet:
    """Read a RotationNet from a checkpoint of either layout, in evaluation mode.

    Raises:
        CheckpointError: the file is no checkpoint, or one of another network or category.
    """
    network = RotationNet(category.num_parts, category.symmetric)
    _load(network, path, list(_rotation_layers(category.num_parts)), f"the RotationNet of {category.name}")
    return network


def save_checkpoint(path: Path, network: nn.Module, training: Mapping[str, Any]) -> None:
    """Write `{"model": …, "training": …}`; `training` says with what the network was trained, in plain values."""
    partial = path.with_name(path.name + ".partial")
    torch.save({"model": network.state_dict(), "training": dict(training)}, partial)
    partial.replace(path)


def training_info(path: Path) -> dict[str, Any]:
    """What a checkpoint says about its training: ours in full, the authors' their epoch."""
    content = _read(path)
    return dict(content.get("training", {k: content[k] for k in ("epoch", "iteration") if k in content}))


def is_authors(path: Path) -> bool:
    """Whether a checkpoint has the authors' layout."""
    return _has_authors_layout(_read(path)["model"])


def _has_authors_layout(state: StateDict) -> bool:
    return any(key.startswith(AUTHORS_PREFIX) for key in state)


def _read(path: Path) -> dict[str, Any]:
    try:
        content = torch.load(path, map_location="cpu", weights_only=True)
    except FileNotFoundError:
        raise CheckpointError(f"{path} does not exist: give the path of a .pt file") from None
    except (UnpicklingError, RuntimeError, EOFError, ValueError) as error:
        advice = "download or copy it again; if it holds other objects than tensors, save its state dict alone"
        raise CheckpointError(f"{path} is no readable checkpoint: {advice}") from error
    model = content.get("model") if isinstance(content, dict) else None
    if not isinstance(model, Mapping) or not all(isinstance(value, Tensor) for value in model.values()):
        raise CheckpointError(f'{path} holds no state dict "model": save it as {{"model": network.state_dict()}}')
    return cast("dict[str, Any]", content)


def _load(network: nn.Module, path: Path, layers: list[_Layer], wanted: str) -> None:
    state: StateDict = _read(path)["model"]
    if _has_authors_layout(state):
        state = from_authors(state, network, layers, f"{path} is not {wanted}")
    else:
        _check(
            state, {key: tuple(value.shape) for key, value in network.state_dict().items()}, f"{path} is not {wanted}"
        )
    network.load_state_dict(dict(state))
    network.eval()


def from_authors(
    state: StateDict, network: nn.Module, layers: list[_Layer], complaint: str = "the checkpoint does not fit"
) -> dict[str, Tensor]:
    """The authors' entries in our layout.

    Convolutions become matrices. A bias before batch norm only shifts the mean, so it is taken off the running mean.
    The last skip connection of their CoordinateNet holds xyz twice: both blocks of columns act on the same input and
    are added.

    Raises:
        CheckpointError: entries are missing, unknown or of another shape.
    """
    ours = network.state_dict()
    expected: dict[str, tuple[int, ...]] = {}
    for layer in layers:
        expected |= _expected(layer, ours)
    _check(state, expected, complaint)
    converted: dict[str, Tensor] = {}
    for layer in layers:
        converted |= _convert(layer, state)
    return converted


def _expected(layer: _Layer, ours: StateDict) -> dict[str, tuple[int, ...]]:
    outputs, inputs = ours[f"{layer.ours}.weight"].shape
    if _doubled_skip(layer):
        inputs += XYZ
    ones = (1, 1) if "conv_blocks" in layer.linear or ".sa3." in layer.linear else (1,)
    shapes: dict[str, tuple[int, ...]] = {
        f"{layer.linear}.weight": (outputs, inputs, *ones),
        f"{layer.linear}.bias": (outputs,),
    }
    if layer.norm:
        shapes |= {f"{layer.norm}.{name}": (outputs,) for name in ("weight", "bias")}
    if layer.batch_norm:
        shapes |= {f"{layer.norm}.{name}": (outputs,) for name in ("running_mean", "running_var")}
        shapes[f"{layer.norm}.num_batches_tracked"] = ()
    return shapes


def _convert(layer: _Layer, state: StateDict) -> dict[str, Tensor]:
    weight, bias = state[f"{layer.linear}.weight"].flatten(1), state[f"{layer.linear}.bias"]
    if _doubled_skip(layer):
        weight = torch.cat([weight[:, :XYZ] + weight[:, XYZ : 2 * XYZ], weight[:, 2 * XYZ :]], dim=1)
    converted = {f"{layer.ours}.weight": weight}
    if layer.batch_norm:
        names = ("weight", "bias", "running_mean", "running_var", "num_batches_tracked")
        converted |= {f"{layer.ours}.norm.{name}": state[f"{layer.norm}.{name}"] for name in names}
        converted[f"{layer.ours}.norm.running_mean"] = state[f"{layer.norm}.running_mean"] - bias
        return converted
    converted[f"{layer.ours}.bias"] = bias
    if layer.norm:
        converted |= {f"{layer.our_norm}.{name}": state[f"{layer.norm}.{name}"] for name in ("weight", "bias")}
    return converted


def _doubled_skip(layer: _Layer) -> bool:
    return layer.linear == DOUBLED_SKIP


def _check(state: StateDict, expected: Mapping[str, tuple[int, ...]], complaint: str) -> None:
    problems = []
    if missing := [key for key in expected if key not in state]:
        problems.append(f"{len(missing)} entries are missing, first {missing[0]!r}")
    if unknown := [key for key in state if key not in expected]:
        problems.append(f"{len(unknown)} entries are unknown, first {unknown[0]!r}")
    shapes = {key: tuple(value.shape) for key, value in state.items()}
    if wrong := [key for key, shape in expected.items() if shapes.get(key, shape) != shape]:
        first = wrong[0]
        problems.append(
            f"{len(wrong)} entries have another shape, first {first!r}: {shapes[first]} instead of {expected[first]}"
        )
    if problems:
        raise CheckpointError(f"{complaint}: {'; '.join(problems)}; {ADVICE}")


def _backbone_layers(theirs: str) -> Iterator[_Layer]:
    for level, name, channels in (("level1", "sa1", LEVEL1_CHANNELS), ("level2", "sa2", LEVEL2_CHANNELS)):
        for scale, widths in enumerate(channels):
            for i in range(len(widths)):
                source = f"{theirs}.{name}"
                yield _Layer(
                    f"backbone.{level}.scales.{scale}.{i}",
                    f"{source}.conv_blocks.{scale}.{i}",
                    f"{source}.bn_blocks.{scale}.{i}",
                )
    for level, name, count in (
        ("level3", "sa3", len(GLOBAL_CHANNELS)),
        ("up3", "fp3", 2),
        ("up2", "fp2", 2),
        ("up1", "fp1", 2),
    ):
        for i in range(count):
            yield _Layer(
                f"backbone.{level}.layers.{i}", f"{theirs}.{name}.mlp_convs.{i}", f"{theirs}.{name}.mlp_bns.{i}"
            )
    yield _Layer("backbone.last", f"{theirs}.conv1", f"{theirs}.bn1")


def _coordinate_layers() -> Iterator[_Layer]:
    yield from _backbone_layers("net.backbone")
    yield _Layer("segmentation", "net.seg_head.0")
    yield _Layer("hidden", "net.nocs_head.0", "net.nocs_head.1")
    yield _Layer("coordinates", "net.nocs_head.3")


def _rotation_layers(num_parts: int) -> Iterator[_Layer]:
    yield from _backbone_layers("net.regress_net.encoder")
    for part in range(num_parts):
        source = f"net.regress_net.pose_pred.rtvec_head.{part}.model"
        for i in range(len(HEAD_CHANNELS)):
            yield _Layer(
                f"heads.{part}.layers.{i}", f"{source}.{3 * i}", f"{source}.{3 * i + 1}", f"heads.{part}.norms.{i}"
            )
        yield _Layer(f"heads.{part}.output", f"{source}.{3 * len(HEAD_CHANNELS)}")

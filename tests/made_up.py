"""Small clouds, and untrained networks whose norms are anything but neutral."""

from pathlib import Path

import numpy as np
import onnx
import torch
from torch import nn

from captra.categories import get_category
from captra.learn.checkpoint import save_checkpoint
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.pointnet2 import TorchNeighborhoods
from captra.learn.rotation_net import RotationNet
from captra.runtime.bundle import COORDINATE, ROTATION, Manifest, Training, sha256_of, write_manifest
from captra.sampling import Profile, build_neighborhoods
from export.graph import OPSET
from export.inputs import made_up_clouds
from export.onnx_export import coordinate_model, rotation_model

TINY = Profile("tiny", 96, (24, 8), ((4, 5, 6), (3, 4)))


def batch_of_clouds(count: int, seed: int, profile: Profile = TINY) -> tuple[torch.Tensor, TorchNeighborhoods]:
    """Unrelated canonical clouds with their neighbourhoods."""
    clouds = np.concatenate([made_up_clouds(1, profile, seed + i) for i in range(count)])
    return torch.from_numpy(clouds), TorchNeighborhoods.stack([build_neighborhoods(c, profile) for c in clouds])


def shuffle_statistics(network: nn.Module, seed: int = 0) -> None:
    """Give every norm weights, biases and running statistics as training would leave them."""
    generator = torch.Generator().manual_seed(seed)
    for name, tensor in network.state_dict().items():
        if "norm" not in name or not tensor.is_floating_point():
            continue
        noise = torch.randn(tensor.shape, generator=generator)
        tensor.copy_(0.3 * noise if name.endswith(("bias", "running_mean")) else 1 + 0.2 * noise.clamp(-2, 2))


def networks_of(category: str, seed: int = 0) -> tuple[CoordinateNet, RotationNet]:
    """Untrained networks in evaluation mode."""
    chosen = get_category(category)
    torch.manual_seed(seed)
    coordinate_net = CoordinateNet(chosen.num_parts, chosen.num_classes)
    rotation_net = RotationNet(chosen.num_parts, chosen.symmetric)
    for network in (coordinate_net, rotation_net):
        shuffle_statistics(network, seed)
        network.eval()
    return coordinate_net, rotation_net


def write_checkpoints(category: str, folder: Path, training: dict[str, object] | None = None) -> tuple[Path, Path]:
    """Untrained networks of a category as checkpoints in our layout."""
    paths = (folder / "coordinate.pt", folder / "rotation.pt")
    for path, network in zip(paths, networks_of(category), strict=True):
        save_checkpoint(path, network, training or {"samples": 24, "seed": 1})
    return paths


def write_bundle(category: str, folder: Path, precision: str = "float16", rotation_share: float = 1.0) -> Path:
    """Untrained networks of a category as a bundle."""
    chosen = get_category(category)
    coordinate_net, rotation_net = networks_of(category)
    folder.mkdir(parents=True)
    onnx.save(coordinate_model(coordinate_net, precision), folder / COORDINATE)
    onnx.save(rotation_model(rotation_net, precision), folder / ROTATION)
    manifest = Manifest(
        category=category,
        parts=chosen.parts,
        symmetric=chosen.symmetric,
        precision=precision,
        opset=OPSET,
        sha256={name: sha256_of(folder / name) for name in (COORDINATE, ROTATION)},
        training=Training(data="none", steps=0),
        rotation_share=rotation_share,
    )
    write_manifest(folder, manifest)
    return folder

from collections.abc import Callable

import numpy as np
import pytest
import torch
from torch import nn

from captra.categories import get_category
from captra.geometry import Pose
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.networks import TorchNetworks
from captra.learn.pointnet2 import TorchNeighborhoods
from captra.learn.rotation_net import RotationNet
from captra.tracker import Tracker
from tests.made_up import TINY, batch_of_clouds, networks_of


@pytest.mark.parametrize("category", ["bottle", "mug", "drawers"])
def test_shapes_and_ranges(category: str) -> None:
    chosen = get_category(category)
    coordinate_net, rotation_net = networks_of(category)
    points, neighborhoods = batch_of_clouds(chosen.num_parts, seed=0)
    with torch.inference_mode():
        logits, coordinates = coordinate_net(points, neighborhoods)
        raw = rotation_net(points[None], neighborhoods)
    assert logits.shape == (chosen.num_parts, chosen.num_classes, TINY.points)
    assert coordinates.shape == (chosen.num_parts, chosen.num_parts, TINY.points, 3)
    assert coordinates.abs().max() <= 0.5
    assert raw.shape == (1, chosen.num_parts, TINY.points, 3 if chosen.symmetric else 6)


def test_each_head_sees_its_own_cloud() -> None:
    _, network = networks_of("glasses")
    points, n = batch_of_clouds(6, seed=0)
    changed = points.clone()
    changed[4] += 0.1  # part 1 of sample 1
    with torch.inference_mode():
        before = network(points.view(2, 3, TINY.points, 3), n)
        after = network(changed.view(2, 3, TINY.points, 3), n)
    differs = (before - after).abs().amax(dim=(2, 3)) > 1e-4
    assert differs.tolist() == [[False, False, False], [False, True, False]]


def test_heads_differ() -> None:
    _, network = networks_of("scissors")
    points, n = batch_of_clouds(1, seed=0)
    groups1, groups2 = (tuple(torch.cat([group, group]) for group in groups) for groups in (n.groups1, n.groups2))
    twice = TorchNeighborhoods(groups1, groups2, n.nearest1.repeat(2, 1, 1), n.nearest2.repeat(2, 1, 1))
    with torch.inference_mode():
        raw = network(points.expand(2, -1, -1)[None], twice)
    assert (raw[0, 0] - raw[0, 1]).abs().max() > 1e-2


def test_heads_may_run_on_a_prefix_of_the_points() -> None:
    _, network = networks_of("mug")
    points, n = batch_of_clouds(2, seed=0)
    with torch.inference_mode():
        everything = network(points[:, None], n)
        assert network(points[:, None], n, head_points=32).shape == (2, 1, 32, 6)
        torch.testing.assert_close(network(points[:, None], n, head_points=TINY.points), everything)


@pytest.mark.parametrize("category", ["mug", "bottle", "laptop_articulated"])
def test_training_in_bfloat16_learns(category: str) -> None:
    torch.manual_seed(0)
    chosen = get_category(category)
    network = RotationNet(chosen.num_parts, chosen.symmetric)
    points, n = batch_of_clouds(4 * chosen.num_parts, seed=0)
    clouds = points.view(4, chosen.num_parts, TINY.points, 3)
    target = torch.randn(4, chosen.num_parts, 1, 3 if chosen.symmetric else 6)
    losses = _train(network, lambda: (network(clouds, n) - target).square().mean())
    assert losses[-1] < 0.5 * losses[0]


def test_coordinate_net_learns_in_bfloat16_what_it_learns_in_float32() -> None:
    points, n = batch_of_clouds(4, seed=0)
    truth = points.clamp(-0.5, 0.5)[:, None]
    labels = (points[..., 1] > 0).long()
    final = []
    for dtype in (torch.bfloat16, torch.float32):
        torch.manual_seed(0)
        network = CoordinateNet(1, 2)

        def loss(network: CoordinateNet = network) -> torch.Tensor:
            logits, coordinates = network(points, n)
            terms = [nn.functional.cross_entropy(logits, labels), (coordinates - truth).abs().mean()]
            return torch.stack(terms).sum()

        final.append(_train(network, loss, dtype)[-1])
    assert final[0] < 0.5
    assert abs(final[0] - final[1]) < 0.15


@pytest.mark.parametrize("category", ["mug", "laptop_articulated"])
def test_torch_networks_drive_a_tracker(category: str) -> None:
    chosen = get_category(category)
    networks = TorchNetworks(chosen, TINY, *networks_of(category))
    parts = chosen.num_parts
    pose = Pose.from_size(np.tile(np.eye(3), (parts, 1, 1)), np.zeros((parts, 3)), np.full((parts, 3), 0.2))
    cloud = np.random.default_rng(0).uniform(-0.1, 0.1, (500, 3)).astype(np.float32)
    result = Tracker(networks, pose).step(cloud)
    assert np.isfinite(result.pose.rotation).all()
    assert 0 <= result.confidence <= 1


def _train(network: nn.Module, loss_of: Callable[[], torch.Tensor], dtype: torch.dtype = torch.bfloat16) -> list[float]:
    optimizer = torch.optim.Adam(network.parameters(), 3e-3)
    losses = []
    for _ in range(12):
        with torch.autocast("cpu", dtype, enabled=dtype is torch.bfloat16):
            loss = loss_of()
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(float(loss.detach()))
    return losses


def test_one_part_of_each_sample_gets_what_all_parts_together_give() -> None:
    network = RotationNet(3, symmetric=False).eval()
    points, neighborhoods = batch_of_clouds(3, seed=4)
    with torch.inference_mode():
        whole = network(points[None], neighborhoods, head_points=16)[0]
        alone = network.one_part(points, torch.tensor([0, 1, 2]), neighborhoods, head_points=16)
    torch.testing.assert_close(alone, whole)

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from torch import Tensor

from captra.learn.pointnet2 import (
    Backbone,
    PointwiseMlp,
    SetAbstraction,
    TorchNeighborhoods,
    copy_backbone,
    interpolation_weights,
)
from tests.made_up import TINY, batch_of_clouds, shuffle_statistics

SEEDS = st.integers(0, 2**31)
FEW = settings(max_examples=10, deadline=None)


def backbone(seed: int, *, positions: bool) -> Backbone:
    torch.manual_seed(seed)
    network = Backbone(positions=positions)
    shuffle_statistics(network, seed)
    return network.eval()


def plain_mlp(mlp: PointwiseMlp, inputs: Tensor) -> Tensor:
    """The layers one after another on (..., channels), nothing hoisted, exchanged or fused."""
    for layer in mlp.layers:
        hidden = inputs @ layer.weight.T
        inputs = torch.relu(layer.norm(hidden.flatten(0, -2)).view(hidden.shape))
    return inputs


def rows_at(values: Tensor, index: Tensor) -> Tensor:
    return torch.stack([cloud[rows.long()] for cloud, rows in zip(values, index, strict=True)])


def plain_abstraction(
    level: SetAbstraction, xyz: Tensor, features: Tensor | None, groups: tuple[Tensor, ...]
) -> Tensor:
    maxima = []
    for mlp, group in zip(level.scales, groups, strict=True):
        relative = rows_at(xyz, group) - xyz[:, : group.shape[1], None]
        before = (
            [rows_at(features, group)] if features is not None else [rows_at(xyz, group)] if level.positions else []
        )
        assert isinstance(mlp, PointwiseMlp)
        maxima.append(plain_mlp(mlp, torch.cat([*before, relative], dim=-1)).amax(dim=2))
    return torch.cat(maxima, dim=-1)


def plain_interpolation(fine: Tensor, coarse: Tensor, features: Tensor, nearest: Tensor) -> Tensor:
    weights = 1 / ((fine[:, :, None] - rows_at(coarse, nearest)).square().sum(dim=-1) + 1e-8)
    return (rows_at(features, nearest) * (weights / weights.sum(dim=-1, keepdim=True))[..., None]).sum(dim=2)


def plain_backbone(network: Backbone, points: Tensor, n: TorchNeighborhoods) -> Tensor:
    """The network as the paper draws it: sample, group, concatenate, MLP, maximum; interpolate, concatenate, MLP."""
    xyz1, xyz2 = points[:, : n.nearest2.shape[1]], points[:, : n.groups2[0].shape[1]]
    features1 = plain_abstraction(network.level1, points, None, n.groups1)
    features2 = plain_abstraction(network.level2, xyz1, features1, n.groups2)
    overall = plain_mlp(network.level3.layers, torch.cat([xyz2, features2], dim=-1)).amax(dim=1, keepdim=True)
    up3 = plain_mlp(network.up3.layers, torch.cat([features2, overall.expand(-1, xyz2.shape[1], -1)], dim=-1))
    up2 = plain_mlp(
        network.up2.layers, torch.cat([features1, plain_interpolation(xyz1, xyz2, up3, n.nearest2)], dim=-1)
    )
    up1 = plain_mlp(network.up1.layers, torch.cat([points, plain_interpolation(points, xyz1, up2, n.nearest1)], dim=-1))
    last = up1 @ network.last.weight.T
    return torch.relu(network.last.norm(last.flatten(0, 1)))


@pytest.mark.parametrize("training", [False, True])
@pytest.mark.parametrize("positions", [False, True])
def test_hoisting_changes_nothing(positions: bool, training: bool) -> None:
    network = backbone(1, positions=positions).train(training)
    points, neighborhoods = batch_of_clouds(3, seed=5)
    torch.testing.assert_close(
        network(points, neighborhoods), plain_backbone(network, points, neighborhoods), atol=2e-4, rtol=1e-3
    )


def test_gradients_of_the_hoisted_network_are_those_of_the_plain_one() -> None:
    network = backbone(2, positions=True).train().double()
    points, neighborhoods = batch_of_clouds(2, seed=9)
    weight = network.level2.scales[0].first_weight
    assert isinstance(weight, Tensor)
    target = torch.randn(2 * TINY.points, 128, dtype=torch.float64)

    def gradient(features: Tensor) -> Tensor:
        (result,) = torch.autograd.grad((features * target).sum(), weight)
        return result

    hoisted = gradient(network(points.double(), neighborhoods))
    torch.testing.assert_close(hoisted, gradient(plain_backbone(network, points.double(), neighborhoods)))


@FEW
@given(SEEDS)
def test_order_within_a_group_does_not_matter(seed: int) -> None:
    network = backbone(3, positions=True)
    points, n = batch_of_clouds(1, seed % 100)
    generator = torch.Generator().manual_seed(seed)

    def shuffled(groups: tuple[Tensor, ...]) -> tuple[Tensor, ...]:
        return tuple(group[:, :, torch.randperm(group.shape[2], generator=generator)] for group in groups)

    other = n._replace(groups1=shuffled(n.groups1), groups2=shuffled(n.groups2))
    with torch.inference_mode():
        torch.testing.assert_close(network(points, n), network(points, other))


@FEW
@given(SEEDS)
def test_points_that_are_no_centroids_may_come_in_any_order(seed: int) -> None:
    network = backbone(4, positions=False)
    points, n = batch_of_clouds(1, seed % 100)
    first = TINY.centroids[0]
    order = torch.cat(
        [
            torch.arange(first),
            first + torch.randperm(TINY.points - first, generator=torch.Generator().manual_seed(seed)),
        ]
    )
    place = torch.argsort(order)
    moved = n._replace(groups1=tuple(place[group.long()] for group in n.groups1), nearest1=n.nearest1[:, order])
    with torch.inference_mode():
        features, expected = network(points[:, order], moved), network(points, n)[order]
    torch.testing.assert_close(features, expected, atol=1e-5, rtol=1e-4)


def test_clouds_of_a_batch_do_not_see_each_other() -> None:
    network = backbone(5, positions=True)
    points, n = batch_of_clouds(3, seed=0)
    alone = TorchNeighborhoods(
        tuple(g[1:2] for g in n.groups1), tuple(g[1:2] for g in n.groups2), n.nearest1[1:2], n.nearest2[1:2]
    )
    with torch.inference_mode():
        together = network(points, n).view(3, TINY.points, -1)[1]
        torch.testing.assert_close(together, network(points[1:2], alone), atol=1e-5, rtol=1e-4)


@FEW
@given(SEEDS)
def test_rotation_backbone_ignores_where_the_first_level_is(seed: int) -> None:
    """Without positions the first level reads differences only."""
    network = backbone(6, positions=False)
    points, n = batch_of_clouds(1, seed % 100)
    with torch.inference_mode():
        near, far = network.level1(points, None, n.groups1), network.level1(points + 0.25, None, n.groups1)
    torch.testing.assert_close(near, far, atol=1e-4, rtol=1e-3)


def test_interpolation_at_a_reference_takes_its_value() -> None:
    points, n = batch_of_clouds(1, seed=3)
    references = points[:, : TINY.centroids[0]]
    weights = interpolation_weights(points, references, n.nearest1)
    torch.testing.assert_close(weights.sum(dim=-1), torch.ones(1, TINY.points))
    own = weights[0, : TINY.centroids[0], 0]
    torch.testing.assert_close(own, torch.ones_like(own), atol=1e-3, rtol=0)


def test_warm_start_towards_positions_computes_the_same() -> None:
    source, target = backbone(7, positions=False), backbone(8, positions=True)
    copy_backbone(source, target)
    points, n = batch_of_clouds(2, seed=1)
    with torch.inference_mode():
        torch.testing.assert_close(source(points, n), target(points, n), atol=1e-5, rtol=1e-4)


def test_warm_start_without_positions_keeps_everything_else() -> None:
    source, target = backbone(9, positions=True), backbone(10, positions=False)
    copy_backbone(source, target)
    old, new = source.state_dict(), target.state_dict()
    for name, tensor in new.items():
        torch.testing.assert_close(tensor, old[name][:, 3:] if tensor.shape != old[name].shape else old[name])
    assert {name for name in new if new[name].shape != old[name].shape} == {
        f"level1.scales.{i}.0.weight" for i in range(3)
    }

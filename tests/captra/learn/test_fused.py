from collections.abc import Callable

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from torch import Tensor, nn

from captra.learn import fused

SEEDS = st.integers(0, 2**31)
FEW = settings(max_examples=10, deadline=None)
CHANNELS = 6
SIZE = 8


def generator(seed: int) -> torch.Generator:
    return torch.Generator().manual_seed(seed)


def rows_of(seed: int, rows: int = 96) -> Tensor:
    """Values that bfloat16 holds exactly, no two of a channel alike, so that maxima are unique."""
    ranks = torch.stack([torch.randperm(rows, generator=generator(seed + c)) for c in range(CHANNELS)], dim=1)
    return (ranks.float() / 32 - 1).bfloat16()


def norm_of(seed: int) -> nn.BatchNorm1d:
    norm = nn.BatchNorm1d(CHANNELS)
    nn.init.normal_(norm.weight, generator=generator(seed))
    nn.init.normal_(norm.bias, generator=generator(seed + 1))
    return norm


def outcome(function: Callable[[Tensor], Tensor], rows: Tensor, seed: int, *parameters: nn.Parameter) -> list[Tensor]:
    """The result and all gradients of a random functional of it."""
    rows = rows.clone().requires_grad_()
    result = function(rows)
    (result.float() * torch.randn(result.shape, generator=generator(seed))).sum().backward()
    gradients = [rows.grad, *(parameter.grad for parameter in parameters)]
    assert all(gradient is not None for gradient in gradients)
    return [result.detach().float(), *(gradient.float() for gradient in gradients if gradient is not None)]


def assert_alike(sweeps: list[Tensor], plain: list[Tensor]) -> None:
    for fast, slow in zip(sweeps, plain, strict=True):
        torch.testing.assert_close(fast, slow, atol=0.02 * float(slow.abs().max()) + 1e-6, rtol=0.02)


@FEW
@given(SEEDS)
def test_norm_and_relu(seed: int) -> None:
    one, two = norm_of(seed), norm_of(seed)
    sweeps = outcome(lambda rows: fused.norm_relu(rows, one), rows_of(seed), seed, *one.parameters())
    plain = outcome(lambda rows: torch.relu(two(rows)), rows_of(seed).float(), seed, *two.parameters())
    assert_alike(sweeps, plain)
    for name, tensor in one.state_dict().items():
        torch.testing.assert_close(tensor, two.state_dict()[name], atol=1e-5, rtol=1e-4)


@FEW
@given(SEEDS)
def test_norm_relu_and_maximum(seed: int) -> None:
    one, two = norm_of(seed), norm_of(seed)

    def plainly(rows: Tensor) -> Tensor:
        return torch.relu(two(rows)).view(-1, SIZE, CHANNELS).amax(dim=1)

    sweeps = outcome(lambda rows: fused.norm_relu_max(rows, one, SIZE), rows_of(seed), seed, *one.parameters())
    assert_alike(sweeps, outcome(plainly, rows_of(seed).float(), seed, *two.parameters()))
    assert one.running_mean is not None
    torch.testing.assert_close(one.running_mean, two.running_mean, atol=1e-5, rtol=1e-4)


@FEW
@given(SEEDS)
def test_norm_of_each_cloud(seed: int) -> None:
    weight, bias = (nn.Parameter(torch.randn(CHANNELS, generator=generator(seed + i))) for i in range(2))
    copies = [nn.Parameter(parameter.detach().clone()) for parameter in (weight, bias)]

    def plainly(rows: Tensor) -> Tensor:
        channels_first = rows.view(3, -1, CHANNELS).transpose(1, 2)
        return torch.relu(nn.functional.group_norm(channels_first, 3, copies[0], copies[1])).transpose(1, 2)

    def swept(rows: Tensor) -> Tensor:
        return fused.cloud_norm_relu(rows.view(3, -1, CHANNELS), weight, bias, 2, 1e-5)

    plain = outcome(plainly, rows_of(seed).float(), seed, *copies)
    assert_alike(outcome(swept, rows_of(seed), seed, weight, bias), plain)
    torch.testing.assert_close(swept(rows_of(seed).float()).detach(), plain[0], atol=1e-5, rtol=1e-4)


@FEW
@given(SEEDS)
def test_grouped_difference(seed: int) -> None:
    points, centroids = (torch.randn(2, n, CHANNELS, generator=generator(seed)) for n in (10, 4))
    groups = torch.randint(0, 10, (2, 4, 5), dtype=torch.int32, generator=generator(seed))
    parameters = [nn.Parameter(centroids.clone()) for _ in range(2)]

    def plainly(rows: Tensor) -> Tensor:
        gathered = torch.stack([cloud[index.long()] for cloud, index in zip(rows, groups, strict=True)])
        return (gathered - parameters[1].unsqueeze(2)).flatten(0, 2)

    with torch.autocast("cpu", torch.bfloat16):
        sweeps = outcome(
            lambda rows: fused.grouped_difference(rows, parameters[0], groups), points, seed, parameters[0]
        )
    plain = outcome(plainly, points, seed, parameters[1])
    assert_alike(sweeps, plain)
    torch.testing.assert_close(fused.grouped_difference(points, centroids, groups), plain[0])


@FEW
@given(SEEDS)
def test_interpolation(seed: int) -> None:
    features = torch.randn(2, 7, CHANNELS, generator=generator(seed))
    nearest = torch.randint(0, 7, (2, 9, 3), dtype=torch.int32, generator=generator(seed))
    weights = torch.rand(2, 9, 3, generator=generator(seed))

    def plainly(rows: Tensor) -> Tensor:
        gathered = torch.stack([cloud[index.long()] for cloud, index in zip(rows, nearest, strict=True)])
        return (gathered * weights.unsqueeze(-1)).sum(dim=2)

    sweeps = outcome(lambda rows: fused.interpolate(rows, nearest, weights), features.bfloat16(), seed)
    plain = outcome(plainly, features.bfloat16().float(), seed)
    assert_alike(sweeps, plain)
    torch.testing.assert_close(fused.interpolate(features, nearest, weights), plainly(features))


def test_a_channel_that_never_varies_stays_finite() -> None:
    rows = torch.full((64, CHANNELS), 0.5).bfloat16()
    norm = norm_of(0)
    results = outcome(lambda rows: fused.norm_relu(rows, norm), rows, 0, *norm.parameters())
    assert all(torch.isfinite(result).all() for result in results)


@pytest.mark.parametrize("training", [False, True])
def test_running_statistics_serve_evaluation(training: bool) -> None:
    norm = norm_of(3).train(training)
    before = norm.running_mean.clone() if norm.running_mean is not None else None
    with torch.set_grad_enabled(training):
        fused.norm_relu(rows_of(3), norm)
    assert norm.running_mean is not None
    assert before is not None
    assert (torch.equal(norm.running_mean, before)) is not training

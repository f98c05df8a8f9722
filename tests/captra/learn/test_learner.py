from copy import deepcopy

import pytest
import torch

from captra.learn.coordinate_net import CoordinateNet
from captra.learn.learner import SMALLEST_MATRIX, Learner, optimizers_for, ramped_average
from captra.learn.plan import Plan
from captra.learn.rotation_net import RotationNet


@pytest.mark.parametrize("network", [CoordinateNet(2, 3), RotationNet(2, symmetric=False)])
def test_every_parameter_has_one_optimizer_and_hidden_matrices_have_muon(network: torch.nn.Module) -> None:
    muon, adam = optimizers_for(network, Plan())
    matrices, others = (
        [parameter for group in optimizer.param_groups for parameter in group["params"]] for optimizer in (muon, adam)
    )
    assert isinstance(muon, torch.optim.Muon)
    assert all(parameter.ndim == 2 and min(parameter.shape) >= SMALLEST_MATRIX for parameter in matrices)
    assert not any(parameter.ndim == 2 and min(parameter.shape) >= SMALLEST_MATRIX for parameter in others)
    assert {id(p) for p in matrices} | {id(p) for p in others} == {id(p) for p in network.parameters()}
    assert len(matrices) + len(others) == len(list(network.parameters()))


def test_a_step_goes_downhill_in_matrices_and_elsewhere() -> None:
    torch.manual_seed(0)
    network = CoordinateNet(1, 2)
    learner = Learner(network, Plan())
    before = {name: parameter.detach().clone() for name, parameter in network.named_parameters()}

    def loss() -> torch.Tensor:
        return torch.stack([parameter.square().sum() for parameter in network.parameters()]).sum()

    started = float(loss().detach())
    learner.step(loss(), 1e-3)
    assert float(loss().detach()) < started
    moved = {name: not torch.equal(before[name], parameter) for name, parameter in network.named_parameters()}
    assert moved["backbone.up1.layers.0.weight"]
    assert moved["coordinates.weight"]


def test_the_state_of_both_optimizers_is_kept() -> None:
    torch.manual_seed(0)
    one, other = (Learner(CoordinateNet(1, 2), Plan()) for _ in range(2))
    for _ in range(2):
        one.step(torch.stack([p.square().sum() for p in one.network.parameters()]).sum(), 1e-3)
    other.load_state_dict(deepcopy(one.state_dict()))
    for learner in (one, other):
        learner.step(torch.stack([(p - 1).square().sum() for p in learner.network.parameters()]).sum(), 1e-3)
    for mine, theirs in zip(one.network.parameters(), other.network.parameters(), strict=True):
        assert torch.equal(mine, theirs)


def test_the_average_forgets_where_it_began() -> None:
    average, current = torch.zeros(1), torch.ones(1)
    update = ramped_average(0.997)
    for count in range(20):
        update([average], [current], count)
    assert float(average) > 0.9

"""One network in training: its optimizers, and the moving average of its weights."""

from collections.abc import Callable
from typing import Any, Generic, TypeVar

import torch
from torch import nn
from torch.optim.swa_utils import AveragedModel

from captra.learn.coordinate_net import CoordinateNet
from captra.learn.plan import Plan
from captra.learn.rotation_net import RotationNet

SMALLEST_MATRIX = 32
"""Layers with a shorter side are no matrices to Muon: inputs of three coordinates, outputs of a few numbers."""

Network = TypeVar("Network", CoordinateNet, RotationNet)


Tensors = tuple[torch.Tensor, ...] | list[torch.Tensor]


def ramped_average(decay: float) -> Callable[[Tensors, Tensors, torch.Tensor | int], None]:
    """Exponential moving average whose memory grows with the run, so that it never holds on to untrained weights."""

    def update(averages: Tensors, currents: Tensors, updates: torch.Tensor | int) -> None:
        keep = min(decay, (1 + int(updates)) / (10 + int(updates)))
        for average, current in zip(averages, currents, strict=True):
            if average.is_floating_point():
                average.lerp_(current, 1 - keep)
            else:
                average.copy_(current)

    return update


def optimizers_for(network: nn.Module, plan: Plan) -> tuple[torch.optim.Optimizer, ...]:
    """Muon for the matrices of hidden layers, Adam for everything else.

    Muon's steps have the same size in all directions of a layer: losses fall faster per sample than with Adam alone,
    and trained weights are not shaken up when a run starts from them.
    """
    matrices, others = list[nn.Parameter](), list[nn.Parameter]()
    for parameter in network.parameters():
        hidden = parameter.ndim == 2 and min(parameter.shape) >= SMALLEST_MATRIX
        (matrices if hidden else others).append(parameter)
    return (
        torch.optim.Muon(matrices, lr=plan.learning_rate, weight_decay=0.0, adjust_lr_fn="match_rms_adamw"),
        torch.optim.Adam(others, lr=plan.learning_rate, weight_decay=plan.weight_decay),
    )


class Learner(Generic[Network]):
    """One network with its optimizers and the moving average of its weights."""

    def __init__(self, network: Network, plan: Plan) -> None:
        self.network: Network = network
        self.average = AveragedModel(network, multi_avg_fn=ramped_average(plan.averaging), use_buffers=True)
        self.optimizers = optimizers_for(network, plan)

    def step(self, loss: torch.Tensor, learning_rate: float) -> None:
        """One step of all optimizers down `loss`."""
        for optimizer in self.optimizers:
            for group in optimizer.param_groups:
                group["lr"] = learning_rate
            optimizer.zero_grad(set_to_none=True)
        loss.backward()
        nn.utils.clip_grad_norm_(self.network.parameters(), 10.0)
        for optimizer in self.optimizers:
            optimizer.step()
        self.average.update_parameters(self.network)

    @property
    def averaged(self) -> Network:
        """The network with averaged weights: what is exported."""
        return self.average.module  # type: ignore[return-value]

    def restart(self) -> None:
        """Forget the average: it starts again from the network's weights as they are."""
        self.averaged.load_state_dict(self.network.state_dict())

    def state_dict(self) -> dict[str, Any]:
        """All that resuming needs."""
        return {
            "network": self.network.state_dict(),
            "average": self.average.state_dict(),
            "optimizers": [optimizer.state_dict() for optimizer in self.optimizers],
        }

    def load_state_dict(self, state: dict[str, Any]) -> None:
        """The inverse of `state_dict`."""
        self.network.load_state_dict(state["network"])
        self.average.load_state_dict(state["average"])
        for optimizer, saved in zip(self.optimizers, state["optimizers"], strict=True):
            optimizer.load_state_dict(saved)

"""Normalization, activation, grouping and maximum as single steps of autograd.

In bfloat16 training on a CPU each runs in compiled sweeps over memory (`captra.learn.kernels`), which take a third off
the time of a training step; anywhere else the plain PyTorch operations run, which define what the sweeps compute.
"""

from dataclasses import dataclass
from typing import Any, cast

import numpy as np
import torch
from jaxtyping import Float, Float64, Int
from torch import Tensor, nn
from torch.autograd import Function
from torch.autograd.function import once_differentiable

from captra.learn import kernels


def norm_relu(rows: Float[Tensor, "rows channels"], norm: nn.BatchNorm1d) -> Float[Tensor, "rows channels"]:
    """Batch norm, then ReLU."""
    if not _sweeps_apply(rows, training=norm.training):
        return torch.relu(norm(rows))
    out, mean, variance = _NormRelu.apply(rows, norm.weight, norm.bias, norm.eps, 1, 1)  # type: ignore[no-untyped-call]
    _track(norm, mean[0], variance[0], rows.shape[0])
    return out  # type: ignore[no-any-return]


def norm_relu_max(
    rows: Float[Tensor, "rows channels"], norm: nn.BatchNorm1d, size: int
) -> Float[Tensor, "groups channels"]:
    """Batch norm, ReLU and the maximum of each `size` rows; ReLU comes last, since it commutes with the maximum."""
    if not _sweeps_apply(rows, training=norm.training):
        return torch.relu(norm(rows).view(-1, size, rows.shape[1]).amax(dim=1))
    out, mean, variance = _NormReluMax.apply(rows, norm.weight, norm.bias, norm.eps, size)  # type: ignore[no-untyped-call]
    _track(norm, mean[0], variance[0], rows.shape[0])
    return out  # type: ignore[no-any-return]


def cloud_norm_relu(
    rows: Float[Tensor, "batch points channels"],
    weight: Float[Tensor, " channels"],
    bias: Float[Tensor, " channels"],
    channels_per_group: int,
    eps: float,
) -> Float[Tensor, "batch points channels"]:
    """Group norm over all points of each cloud, then ReLU."""
    batch, points, channels = rows.shape
    if not _sweeps_apply(rows, training=rows.requires_grad):
        groups = channels // channels_per_group
        grouped = rows.float().view(batch, points, groups, channels_per_group)
        variance, mean = torch.var_mean(grouped, dim=(1, 3), correction=0, keepdim=True)
        normalized = ((grouped - mean) * torch.rsqrt(variance + eps)).view(rows.shape)
        return torch.relu(normalized * weight + bias).to(rows.dtype)
    flat = rows.reshape(batch * points, channels)
    out, _, _ = _NormRelu.apply(flat, weight, bias, eps, batch, channels_per_group)  # type: ignore[no-untyped-call]
    return out.view(rows.shape)  # type: ignore[no-any-return]


def grouped_difference(
    at_points: Float[Tensor, "batch points channels"],
    at_centroids: Float[Tensor, "batch M channels"],
    groups: Int[Tensor, "batch M k"],
) -> Float[Tensor, "rows channels"]:
    """Row of each group's point minus the row of its centroid, rounded to bfloat16 only afterwards."""
    if at_points.device.type == "cpu" and torch.is_autocast_enabled("cpu") and at_points.requires_grad:
        return _GroupedDifference.apply(at_points, at_centroids, groups)  # type: ignore[no-untyped-call, no-any-return]
    batch, centroids, k = groups.shape
    index = groups.reshape(batch, centroids * k, 1).long().expand(-1, -1, at_points.shape[2])
    gathered = at_points.gather(1, index).view(batch, centroids, k, -1)
    return (gathered - at_centroids.unsqueeze(2)).flatten(0, 2)


def interpolate(
    features: Float[Tensor, "batch refs channels"],
    nearest: Int[Tensor, "batch rows 3"],
    weights: Float[Tensor, "batch rows 3"],
) -> Float[Tensor, "batch rows channels"]:
    """Weighted sum of the features of the three nearest."""
    if _sweeps_apply(features, training=features.requires_grad):
        return _Interpolate.apply(features, nearest, weights)  # type: ignore[no-untyped-call, no-any-return]
    batch, rows = nearest.shape[:2]
    index = nearest.reshape(batch, rows * 3, 1).long().expand(-1, -1, features.shape[2])
    gathered = features.gather(1, index).view(batch, rows, 3, -1)
    return (gathered * weights.to(features.dtype).unsqueeze(-1)).sum(dim=2)


def _sweeps_apply(rows: Tensor, *, training: bool) -> bool:
    return training and rows.dtype == torch.bfloat16 and rows.device.type == "cpu" and torch.is_grad_enabled()


def _track(norm: nn.BatchNorm1d, mean: Tensor, variance: Tensor, rows: int) -> None:
    momentum = cast("float", norm.momentum)
    cast("Tensor", norm.num_batches_tracked).add_(1)
    cast("Tensor", norm.running_mean).lerp_(mean, momentum)
    cast("Tensor", norm.running_var).lerp_(variance * (rows / (rows - 1)), momentum)


def _bits(tensor: Tensor) -> np.ndarray:
    return tensor.detach().contiguous().view(torch.uint16).numpy()


@dataclass(frozen=True)
class _Affine:
    """Normalization of each segment as scale · x + shift, and what its gradient needs."""

    mean: Float64[np.ndarray, "segments channels"]
    """Of the channel's group."""
    variance: Float64[np.ndarray, "segments channels"]
    """Biased, of the channel's group."""
    weight: Float64[np.ndarray, " channels"]
    """Learned scale."""
    bias: Float64[np.ndarray, " channels"]
    """Learned shift."""
    eps: float
    """Added to the variance."""
    count: int
    """Values in one group."""
    width: int
    """Channels in one group."""

    @classmethod
    def measure(cls, x: np.ndarray, weight: Tensor, bias: Tensor, eps: float, segments: int, width: int) -> "_Affine":
        total, total_squared = kernels.moments(x, segments)
        count = len(x) // segments * width
        mean = _pool(total, width) / count
        variance = np.maximum(_pool(total_squared, width) / count - mean**2, 0)
        return cls(mean, variance, weight.detach().double().numpy(), bias.detach().double().numpy(), eps, count, width)

    @property
    def inverse_deviation(self) -> Float64[np.ndarray, "segments channels"]:
        return np.asarray(1 / np.sqrt(self.variance + self.eps))

    @property
    def coefficients(self) -> tuple[np.ndarray, np.ndarray]:
        """Scale and shift, float32."""
        scale = self.weight * self.inverse_deviation
        return scale.astype(np.float32), (self.bias - self.mean * scale).astype(np.float32)

    def gradient(self, total: np.ndarray, total_product: np.ndarray) -> tuple[np.ndarray, np.ndarray, Tensor, Tensor]:
        """From Σ g and Σ g x: slope and offset of the gradient of x (float32), gradients of weight and bias."""
        inverse = self.inverse_deviation
        centred = (total_product - self.mean * total) * inverse
        mean_g = _pool(self.weight * total, self.width) / self.count
        mean_product = _pool(self.weight * centred, self.width) / self.count
        slope = -(inverse**2) * mean_product
        offset = -inverse * mean_g - slope * self.mean
        weight, bias = (torch.from_numpy(part.sum(axis=0)).float() for part in (centred, total))
        return slope.astype(np.float32), offset.astype(np.float32), weight, bias


def _pool(sums: np.ndarray, width: int) -> np.ndarray:
    """Add up the channels of each group, and give each channel its group's sum."""
    if width == 1:
        return sums
    return np.repeat(sums.reshape(len(sums), -1, width).sum(axis=2), width, axis=1)


class _NormRelu(Function):
    @staticmethod
    def forward(
        ctx: Any, rows: Tensor, weight: Tensor, bias: Tensor, eps: float, segments: int, width: int
    ) -> tuple[Tensor, Tensor, Tensor]:
        out = torch.empty_like(rows, memory_format=torch.contiguous_format)
        x = _bits(rows)
        ctx.affine = _Affine.measure(x, weight, bias, eps, segments, width)
        scale, shift = ctx.affine.coefficients
        kernels.scale_relu(x, scale, shift, _bits(out))
        ctx.save_for_backward(rows)
        mean, variance = (torch.from_numpy(v).float() for v in (ctx.affine.mean, ctx.affine.variance))
        ctx.mark_non_differentiable(mean, variance)
        return out, mean, variance

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Tensor, *_: Tensor) -> tuple[Tensor | None, ...]:
        (rows,) = ctx.saved_tensors
        x, g = _bits(rows), _bits(gradient)
        scale, shift = ctx.affine.coefficients
        slope, offset, weight, bias = ctx.affine.gradient(*kernels.relu_gradient_moments(g, x, scale, shift))
        out = torch.empty_like(rows, memory_format=torch.contiguous_format)
        kernels.relu_gradient(g, x, scale, shift, slope, offset, _bits(out))
        return out, weight, bias, None, None, None


class _NormReluMax(Function):
    @staticmethod
    def forward(
        ctx: Any, rows: Tensor, weight: Tensor, bias: Tensor, eps: float, size: int
    ) -> tuple[Tensor, Tensor, Tensor]:
        x = _bits(rows)
        ctx.affine = _Affine.measure(x, weight, bias, eps, 1, 1)
        scale, shift = ctx.affine.coefficients
        sign = np.where(scale[0] < 0, np.float32(-1), np.float32(1))
        largest, ctx.where = kernels.group_maximum(x, size, sign)
        raw = largest * sign
        out = torch.from_numpy(np.maximum(scale * raw + shift, 0))
        mean, variance = (torch.from_numpy(v).float() for v in (ctx.affine.mean, ctx.affine.variance))
        ctx.mark_non_differentiable(mean, variance)
        ctx.save_for_backward(rows, out)
        ctx.raw = raw
        return out.to(rows.dtype), mean, variance

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Tensor, *_: Tensor) -> tuple[Tensor | None, ...]:
        rows, result = ctx.saved_tensors
        scale, _ = ctx.affine.coefficients
        g = torch.where(result > 0, gradient.float(), 0.0).numpy()
        sums = g.sum(axis=0, dtype=np.float64), (g * ctx.raw).sum(axis=0, dtype=np.float64)
        slope, offset, weight, bias = ctx.affine.gradient(*(s[None] for s in sums))
        out = torch.empty_like(rows, memory_format=torch.contiguous_format)
        kernels.maximum_gradient(g * scale, ctx.where, _bits(rows), slope[0], offset[0], _bits(out))
        return out, weight, bias, None, None


class _GroupedDifference(Function):
    @staticmethod
    def forward(ctx: Any, at_points: Tensor, at_centroids: Tensor, groups: Tensor) -> Tensor:
        out = torch.empty(*groups.shape, at_points.shape[2], dtype=torch.bfloat16)
        ctx.groups = groups.to(torch.int32).contiguous().numpy()
        ctx.shapes = at_points.shape, at_centroids.shape
        ctx.dtypes = at_points.dtype, at_centroids.dtype
        points, centroids = (t.detach().float().contiguous().numpy() for t in (at_points, at_centroids))
        kernels.grouped_difference(points, centroids, ctx.groups, _bits(out))
        return out.flatten(0, 2)

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        points, centroids = (torch.zeros(shape) for shape in ctx.shapes)
        g = _bits(gradient).reshape(*ctx.groups.shape, -1)
        kernels.grouped_difference_gradient(g, ctx.groups, points.numpy(), centroids.numpy())
        return points.to(ctx.dtypes[0]), centroids.to(ctx.dtypes[1]), None


class _Interpolate(Function):
    @staticmethod
    def forward(ctx: Any, features: Tensor, nearest: Tensor, weights: Tensor) -> Tensor:
        ctx.nearest = nearest.to(torch.int32).contiguous().numpy()
        ctx.weights = weights.detach().float().contiguous().numpy()
        ctx.shape = features.shape
        out = torch.empty(*nearest.shape[:2], features.shape[2], dtype=torch.bfloat16)
        kernels.weighted_rows(_bits(features), ctx.nearest, ctx.weights, _bits(out))
        return out

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Tensor) -> tuple[Tensor | None, ...]:
        out = torch.zeros(ctx.shape)
        kernels.weighted_rows_gradient(_bits(gradient), ctx.nearest, ctx.weights, out.numpy())
        return out.to(gradient.dtype), None, None

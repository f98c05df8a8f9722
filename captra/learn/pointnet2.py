"""PointNet++ with multi-scale grouping, the backbone of both networks (METHOD, "Networks").

Activations are rows of channels: every layer is one matrix product over all points of a batch, groups and neighbours
are row indices. The first linear layer of a level runs before grouping, since W [f, x − c] = W_f f + W_x x − W_x c;
likewise interpolation, a linear map too, follows the layer it feeds. Both are exact, in training as well, since the
norm comes after.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Self, cast

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from captra.architecture import (
    FEATURES,
    GLOBAL_CHANNELS,
    LEVEL1_CHANNELS,
    LEVEL2_CHANNELS,
    UP1_CHANNELS,
    UP2_CHANNELS,
    UP3_CHANNELS,
    XYZ,
)
from captra.learn.fused import grouped_difference, interpolate, norm_relu, norm_relu_max
from captra.sampling import Neighborhoods


class TorchNeighborhoods(NamedTuple):
    """`captra.sampling.Neighborhoods` of a batch of clouds."""

    groups1: tuple[Int[Tensor, "batch M1 k"], ...]
    """Per radius, the points around each of the first M1 points."""
    groups2: tuple[Int[Tensor, "batch M2 k"], ...]
    """Per radius, the first-level centroids around each of the first M2."""
    nearest1: Int[Tensor, "batch N 3"]
    """For each point, its three nearest first-level centroids."""
    nearest2: Int[Tensor, "batch M1 3"]
    """For each first-level centroid, its three nearest second-level ones."""

    @classmethod
    def stack(cls, neighborhoods: Sequence[Neighborhoods]) -> Self:
        """Batch the neighbourhoods of several clouds."""

        def batch(arrays: list[np.ndarray]) -> Tensor:
            return torch.from_numpy(np.stack(arrays))

        return cls(
            groups1=tuple(batch(list(groups)) for groups in zip(*(n.groups1 for n in neighborhoods), strict=True)),
            groups2=tuple(batch(list(groups)) for groups in zip(*(n.groups2 for n in neighborhoods), strict=True)),
            nearest1=batch([n.nearest1 for n in neighborhoods]),
            nearest2=batch([n.nearest2 for n in neighborhoods]),
        )


class NormalizedLinear(nn.Module):
    """Matrix product, batch norm and ReLU; the product needs no bias, since the norm subtracts the mean."""

    def __init__(self, inputs: int, outputs: int) -> None:
        super().__init__()
        self.weight = nn.Parameter(torch.empty(outputs, inputs))
        self.norm = nn.BatchNorm1d(outputs)
        nn.init.kaiming_uniform_(self.weight, a=5**0.5)

    def forward(self, rows: Float[Tensor, "rows inputs"]) -> Float[Tensor, "rows outputs"]:
        """Product, norm, ReLU."""
        return norm_relu(nn.functional.linear(rows, self.weight), self.norm)


class PointwiseMlp(nn.ModuleList):
    """Normalized layers one after another, the same for every row."""

    def __init__(self, inputs: int, channels: tuple[int, ...]) -> None:
        super().__init__(NormalizedLinear(i, o) for i, o in zip((inputs, *channels[:-1]), channels, strict=True))

    @property
    def layers(self) -> list[NormalizedLinear]:
        """All of them; the first one's product is computed by whoever knows its inputs."""
        return cast("list[NormalizedLinear]", list(self))

    @property
    def first_weight(self) -> Float[Tensor, "outputs inputs"]:
        """Of the first layer."""
        return self.layers[0].weight

    def after_product(self, product: Float[Tensor, "rows outputs"]) -> Float[Tensor, "rows outputs"]:
        """Everything after the first layer's product."""
        first, *rest = self.layers
        hidden = norm_relu(product, first.norm)
        for layer in rest:
            hidden = layer(hidden)
        return hidden

    def maximum_after_product(
        self, product: Float[Tensor, "rows outputs"], size: int
    ) -> Float[Tensor, "groups outputs"]:
        """Everything after the first layer's product, and the maximum of each `size` rows."""
        first, *rest, last = self.layers
        hidden = norm_relu(product, first.norm)
        for layer in rest:
            hidden = layer(hidden)
        return norm_relu_max(nn.functional.linear(hidden, last.weight), last.norm, size)


def _exact(xyz: Float[Tensor, "*rows 3"], weight: Float[Tensor, "outputs 3"]) -> Float[Tensor, "flat_rows outputs"]:
    """Product with coordinates in float32: in bfloat16 their rounding would be a tenth of the smallest radius."""
    with torch.autocast(xyz.device.type, enabled=False):
        return nn.functional.linear(xyz.flatten(0, 1), weight)


class SetAbstraction(nn.Module):
    """Groups around the first points, at several radii; a point-wise MLP, then the maximum of each group.

    Grouped channels are [features, xyz − centroid]; with `positions`, [xyz, xyz − centroid].
    """

    def __init__(self, features: int, channels: tuple[tuple[int, ...], ...], *, positions: bool = False) -> None:
        super().__init__()
        self.features = features
        self.positions = positions
        self.scales = nn.ModuleList(PointwiseMlp(features + XYZ * (1 + positions), widths) for widths in channels)
        self.outputs = sum(widths[-1] for widths in channels)

    def forward(
        self,
        xyz: Float[Tensor, "batch points 3"],
        features: Float[Tensor, "rows channels"] | None,
        groups: tuple[Int[Tensor, "batch centroids k"], ...],
    ) -> Float[Tensor, "centroid_rows outputs"]:
        """Features of each centroid."""
        parts = []
        for mlp, group in zip(cast("Iterable[PointwiseMlp]", self.scales), groups, strict=True):
            product = self._grouped(mlp.first_weight, xyz, features, group)
            parts.append(mlp.maximum_after_product(product, group.shape[2]))
        return torch.cat(parts, dim=1)

    def _grouped(
        self,
        weight: Float[Tensor, "outputs inputs"],
        xyz: Float[Tensor, "batch points 3"],
        features: Float[Tensor, "rows channels"] | None,
        group: Int[Tensor, "batch centroids k"],
    ) -> Float[Tensor, "grouped_rows outputs"]:
        """The first layer's product: computed for points and centroids, then gathered and subtracted."""
        batch = xyz.shape[0]
        relative = weight[:, -XYZ:]
        at_points = _exact(xyz, relative + weight[:, :XYZ] if self.positions else relative)
        if features is not None:
            at_points = at_points + nn.functional.linear(features, weight[:, : self.features])
        at_centroids = _exact(xyz[:, : group.shape[1]], relative)
        return grouped_difference(at_points.unflatten(0, (batch, -1)), at_centroids.unflatten(0, (batch, -1)), group)


class GlobalAbstraction(nn.Module):
    """A point-wise MLP on [xyz, features], then the maximum over each cloud."""

    def __init__(self, features: int, channels: tuple[int, ...]) -> None:
        super().__init__()
        self.layers = PointwiseMlp(XYZ + features, channels)

    def forward(
        self, xyz: Float[Tensor, "batch points 3"], features: Float[Tensor, "rows channels"]
    ) -> Float[Tensor, "batch outputs"]:
        """One row a cloud."""
        weight = self.layers.first_weight
        product = _exact(xyz, weight[:, :XYZ]) + nn.functional.linear(features, weight[:, XYZ:])
        return self.layers.maximum_after_product(product, xyz.shape[1])


def interpolation_weights(
    points: Float[Tensor, "batch points 3"],
    references: Float[Tensor, "batch refs 3"],
    nearest: Int[Tensor, "batch points 3"],
) -> Float[Tensor, "batch points 3"]:
    """1 / (squared distance + 1e-8) to the three nearest, normalized."""
    batch, count = nearest.shape[:2]
    index = nearest.reshape(batch, count * 3, 1).long().expand(-1, -1, XYZ)
    neighbors = references.gather(1, index).view(batch, count, 3, XYZ)
    weights = 1 / ((points.unsqueeze(2) - neighbors).square().sum(dim=-1) + 1e-8)
    return weights / weights.sum(dim=-1, keepdim=True)


class FeaturePropagation(nn.Module):
    """A point-wise MLP on [skip features, interpolated features]."""

    def __init__(self, skip: int, coarse: int, channels: tuple[int, ...]) -> None:
        super().__init__()
        self.skip = skip
        self.layers = PointwiseMlp(skip + coarse, channels)

    def forward(
        self, skip: Float[Tensor, "rows outputs"], coarse: Float[Tensor, "rows outputs"]
    ) -> Float[Tensor, "rows outputs"]:
        """From the first layer's products with both inputs, each with a row for every finer point."""
        return self.layers.after_product(skip.to(coarse.dtype) + coarse)

    @property
    def skip_weight(self) -> Tensor:
        """The first layer's weight for the skip features."""
        return self.layers.first_weight[:, : self.skip]

    def spread(
        self,
        coarse: Float[Tensor, "coarse_rows channels"],
        nearest: Int[Tensor, "batch points 3"],
        weights: Float[Tensor, "batch points 3"],
    ) -> Float[Tensor, "rows outputs"]:
        """The first layer's product with the interpolated features: first the product, then the interpolation."""
        product = self.coarse_product(coarse).unflatten(0, (nearest.shape[0], -1))
        return interpolate(product, nearest, weights).flatten(0, 1)

    def coarse_product(self, coarse: Float[Tensor, "coarse_rows channels"]) -> Float[Tensor, "coarse_rows outputs"]:
        """The first layer's product with the coarser level's features."""
        return nn.functional.linear(coarse, self.layers.first_weight[:, self.skip :])


class Backbone(nn.Module):
    """From a canonical cloud to features of each point.

    With `positions` the first level groups [xyz, xyz − centroid] (CoordinateNet), otherwise [xyz − centroid]
    (RotationNet).
    """

    def __init__(self, *, positions: bool) -> None:
        super().__init__()
        self.level1 = SetAbstraction(0, LEVEL1_CHANNELS, positions=positions)
        self.level2 = SetAbstraction(self.level1.outputs, LEVEL2_CHANNELS)
        self.level3 = GlobalAbstraction(self.level2.outputs, GLOBAL_CHANNELS)
        self.up3 = FeaturePropagation(self.level2.outputs, GLOBAL_CHANNELS[-1], UP3_CHANNELS)
        self.up2 = FeaturePropagation(self.level1.outputs, UP3_CHANNELS[-1], UP2_CHANNELS)
        self.up1 = FeaturePropagation(XYZ, UP2_CHANNELS[-1], UP1_CHANNELS)
        self.last = NormalizedLinear(UP1_CHANNELS[-1], FEATURES)

    def forward(
        self, points: Float[Tensor, "batch points 3"], neighborhoods: TorchNeighborhoods
    ) -> Float[Tensor, "rows 128"]:
        """Features of each point, clouds one after another; `points` in farthest-point order, canonical units."""
        groups1, groups2, nearest1, nearest2 = neighborhoods
        xyz1, xyz2 = points[:, : groups1[0].shape[1]], points[:, : groups2[0].shape[1]]
        features1 = self.level1(points, None, groups1)
        features2 = self.level2(xyz1, features1, groups2)
        overall = self.level3(xyz2, features2)

        linear = nn.functional.linear
        spread = self.up3.coarse_product(overall).repeat_interleave(xyz2.shape[1], dim=0)
        up2 = self.up3(linear(features2, self.up3.skip_weight), spread)
        spread = self.up2.spread(up2, nearest2, interpolation_weights(xyz1, xyz2, nearest2))
        up1 = self.up2(linear(features1, self.up2.skip_weight), spread)
        spread = self.up1.spread(up1, nearest1, interpolation_weights(points, xyz1, nearest1))
        up0 = self.up1(_exact(points, self.up1.skip_weight), spread)
        return self.last(up0)  # type: ignore[no-any-return]


def copy_backbone(source: Backbone, target: Backbone) -> None:
    """Warm-start one network's backbone from the other's: every tensor that has the same shape is copied as it is.

    Only the first layers differ: with positions they read [xyz, xyz − centroid], without them [xyz − centroid].
    Towards a backbone without positions the columns of xyz are cut off, and the running statistics of the norm after
    them are only a start; towards one with positions its columns of xyz become zero, which computes the same.
    """
    state = source.state_dict()
    for name, tensor in target.state_dict().items():
        if tensor.shape == state[name].shape:
            tensor.copy_(state[name])
        else:
            relative = tensor.zero_()[:, -XYZ:]
            relative.copy_(state[name][:, -XYZ:])

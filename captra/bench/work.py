"""Multiply-adds of the networks as exported: what a frame needs, whatever runs it."""

import itertools
from collections.abc import Sequence

from captra.architecture import (
    FEATURES,
    GLOBAL_CHANNELS,
    HEAD_CHANNELS,
    LEVEL1_CHANNELS,
    LEVEL2_CHANNELS,
    UP1_CHANNELS,
    UP2_CHANNELS,
    UP3_CHANNELS,
    XYZ,
)
from captra.categories import Category
from captra.sampling import Profile


def multiply_adds(category: Category, profile: Profile, rotated_points: int) -> int:
    """Of one frame: CoordinateNet on one cloud, RotationNet on one for each part, its heads on so many points."""
    points, parts = profile.points, category.num_parts
    coordinate_heads = points * (FEATURES * (category.num_classes + FEATURES) + FEATURES * XYZ * parts)
    width = 3 if category.symmetric else 6
    rotation_head = rotated_points * _mlp((FEATURES, *HEAD_CHANNELS, width))
    coordinate_net = _backbone(profile, points, inputs=2 * XYZ) + coordinate_heads
    return coordinate_net + parts * (_backbone(profile, rotated_points, inputs=XYZ) + rotation_head)


def _backbone(profile: Profile, answered: int, inputs: int) -> int:
    """One cloud, with features for the first `answered` points."""
    first, second = profile.centroids
    level1 = sum(
        first * size * _mlp((inputs, *widths)) for size, widths in zip(profile.groups[0], LEVEL1_CHANNELS, strict=True)
    )
    features1 = sum(widths[-1] for widths in LEVEL1_CHANNELS)
    features2 = sum(widths[-1] for widths in LEVEL2_CHANNELS)
    level2 = sum(
        (first * (features1 + XYZ) + second * XYZ) * widths[0] + second * size * _mlp(widths)
        for size, widths in zip(profile.groups[1], LEVEL2_CHANNELS, strict=True)
    )
    level3 = second * _mlp((XYZ + features2, *GLOBAL_CHANNELS))
    up3 = second * _mlp((features2, *UP3_CHANNELS)) + GLOBAL_CHANNELS[-1] * UP3_CHANNELS[0]
    up2 = first * _mlp((features1, *UP2_CHANNELS)) + second * UP3_CHANNELS[-1] * UP2_CHANNELS[0]
    up1 = answered * _mlp((XYZ, *UP1_CHANNELS)) + first * UP2_CHANNELS[-1] * UP1_CHANNELS[0]
    return level1 + level2 + level3 + up3 + up2 + up1 + answered * UP1_CHANNELS[-1] * FEATURES


def _mlp(widths: Sequence[int]) -> int:
    """Of one row."""
    return sum(i * o for i, o in itertools.pairwise(widths))

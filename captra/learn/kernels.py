"""Sweeps over rows of bfloat16 channels, for training on a CPU: what lies between two matrix products.

NumPy has no bfloat16, so rows come as their bits (uint16); arithmetic is float32. Segments are equally many rows each,
with coefficients of their own: one segment for batch norm, one a cloud for the norm of RotationNet's heads.
"""

import numpy as np
from jaxtyping import Float32, Int32, UInt16, UInt32

from captra.compiled import compiled

_ROWS_PER_SUM = 256
"""Rows added up in one float32 sum before it is carried over to float64."""


@compiled
def _widen(bits: UInt16[np.ndarray, " n"], out: UInt32[np.ndarray, " n"]) -> None:
    for i in range(len(bits)):
        out[i] = np.uint32(bits[i]) << np.uint32(16)


@compiled
def _narrow(values: UInt32[np.ndarray, " n"], out: UInt16[np.ndarray, " n"]) -> None:
    for i in range(len(values)):
        rounding = np.uint32(0x7FFF) + ((values[i] >> np.uint32(16)) & np.uint32(1))
        out[i] = np.uint16((values[i] + rounding) >> np.uint32(16))


@compiled
def moments(x: UInt16[np.ndarray, "rows channels"], segments: int) -> tuple[np.ndarray, np.ndarray]:
    """Σ x and Σ x² of each channel over the rows of each segment, float64 (segments, channels)."""
    rows, channels = x.shape
    length = rows // segments
    total, total_squared = np.zeros((segments, channels)), np.zeros((segments, channels))
    part, part_squared = np.zeros(channels, np.float32), np.zeros(channels, np.float32)
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for segment in range(segments):
        for start in range(segment * length, (segment + 1) * length, _ROWS_PER_SUM):
            part[:] = 0
            part_squared[:] = 0
            for r in range(start, min(start + _ROWS_PER_SUM, (segment + 1) * length)):
                _widen(x[r], bits)
                for c in range(channels):
                    part[c] += value[c]
                    part_squared[c] += value[c] * value[c]
            total[segment] += part
            total_squared[segment] += part_squared
    return total, total_squared


@compiled
def scale_relu(
    x: UInt16[np.ndarray, "rows channels"],
    scale: Float32[np.ndarray, "segments channels"],
    shift: Float32[np.ndarray, "segments channels"],
    out: UInt16[np.ndarray, "rows channels"],
) -> None:
    """Compute max(scale · x + shift, 0)."""
    rows, channels = x.shape
    length = rows // len(scale)
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for segment in range(len(scale)):
        a, b = scale[segment], shift[segment]
        for r in range(segment * length, (segment + 1) * length):
            _widen(x[r], bits)
            for c in range(channels):
                value[c] = max(value[c] * a[c] + b[c], np.float32(0))
            _narrow(bits, out[r])


@compiled
def relu_gradient_moments(
    gradient: UInt16[np.ndarray, "rows channels"],
    x: UInt16[np.ndarray, "rows channels"],
    scale: Float32[np.ndarray, "segments channels"],
    shift: Float32[np.ndarray, "segments channels"],
) -> tuple[np.ndarray, np.ndarray]:
    """Σ g and Σ g x over each segment, float64, where g is the gradient of what `scale_relu` let through."""
    rows, channels = x.shape
    segments = len(scale)
    length = rows // segments
    total, total_product = np.zeros((segments, channels)), np.zeros((segments, channels))
    part, part_product = np.zeros(channels, np.float32), np.zeros(channels, np.float32)
    x_bits, g_bits = np.empty(channels, np.uint32), np.empty(channels, np.uint32)
    value, g = x_bits.view(np.float32), g_bits.view(np.float32)
    for segment in range(segments):
        a, b = scale[segment], shift[segment]
        for start in range(segment * length, (segment + 1) * length, _ROWS_PER_SUM):
            part[:] = 0
            part_product[:] = 0
            for r in range(start, min(start + _ROWS_PER_SUM, (segment + 1) * length)):
                _widen(x[r], x_bits)
                _widen(gradient[r], g_bits)
                for c in range(channels):
                    through = g[c] if value[c] * a[c] + b[c] > 0 else np.float32(0)
                    part[c] += through
                    part_product[c] += through * value[c]
            total[segment] += part
            total_product[segment] += part_product
    return total, total_product


@compiled
def relu_gradient(
    gradient: UInt16[np.ndarray, "rows channels"],
    x: UInt16[np.ndarray, "rows channels"],
    scale: Float32[np.ndarray, "segments channels"],
    shift: Float32[np.ndarray, "segments channels"],
    slope: Float32[np.ndarray, "segments channels"],
    offset: Float32[np.ndarray, "segments channels"],
    out: UInt16[np.ndarray, "rows channels"],
) -> None:
    """Compute scale · g + slope · x + offset, where g is the gradient of what `scale_relu` let through."""
    rows, channels = x.shape
    length = rows // len(scale)
    x_bits, g_bits = np.empty(channels, np.uint32), np.empty(channels, np.uint32)
    value, g = x_bits.view(np.float32), g_bits.view(np.float32)
    for segment in range(len(scale)):
        a, b, p, q = scale[segment], shift[segment], slope[segment], offset[segment]
        for r in range(segment * length, (segment + 1) * length):
            _widen(x[r], x_bits)
            _widen(gradient[r], g_bits)
            for c in range(channels):
                through = g[c] if value[c] * a[c] + b[c] > 0 else np.float32(0)
                g[c] = a[c] * through + p[c] * value[c] + q[c]
            _narrow(g_bits, out[r])


@compiled
def group_maximum(
    x: UInt16[np.ndarray, "rows channels"], size: int, sign: Float32[np.ndarray, " channels"]
) -> tuple[np.ndarray, np.ndarray]:
    """Largest sign · x of each group of `size` rows, and the row within the group that holds it first."""
    rows, channels = x.shape
    groups = rows // size
    largest, where = np.empty((groups, channels), np.float32), np.zeros((groups, channels), np.int32)
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for group in range(groups):
        best, best_row = largest[group], where[group]
        best[:] = -np.inf
        for j in range(size):
            _widen(x[group * size + j], bits)
            for c in range(channels):
                candidate = value[c] * sign[c]
                better = candidate > best[c]
                best[c] = candidate if better else best[c]
                best_row[c] = np.int32(j) if better else best_row[c]
    return largest, where


@compiled
def maximum_gradient(
    gradient: Float32[np.ndarray, "groups channels"],
    where: Int32[np.ndarray, "groups channels"],
    x: UInt16[np.ndarray, "rows channels"],
    slope: Float32[np.ndarray, " channels"],
    offset: Float32[np.ndarray, " channels"],
    out: UInt16[np.ndarray, "rows channels"],
) -> None:
    """Compute slope · x + offset, plus the group's gradient in the row that held its maximum."""
    groups, channels = gradient.shape
    size = len(x) // groups
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for group in range(groups):
        g, row = gradient[group], where[group]
        for j in range(size):
            _widen(x[group * size + j], bits)
            for c in range(channels):
                chosen = g[c] if row[c] == j else np.float32(0)
                value[c] = slope[c] * value[c] + offset[c] + chosen
            _narrow(bits, out[group * size + j])


@compiled
def grouped_difference(
    points: Float32[np.ndarray, "batch points channels"],
    centroids: Float32[np.ndarray, "batch M channels"],
    groups: Int32[np.ndarray, "batch M k"],
    out: UInt16[np.ndarray, "batch M k channels"],
) -> None:
    """Compute points[groups] − centroids."""
    batch, count, k = groups.shape
    channels = points.shape[2]
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for b in range(batch):
        for m in range(count):
            centroid = centroids[b, m]
            for j in range(k):
                point = points[b, groups[b, m, j]]
                for c in range(channels):
                    value[c] = point[c] - centroid[c]
                _narrow(bits, out[b, m, j])


@compiled
def grouped_difference_gradient(
    gradient: UInt16[np.ndarray, "batch M k channels"],
    groups: Int32[np.ndarray, "batch M k"],
    points: Float32[np.ndarray, "batch points channels"],
    centroids: Float32[np.ndarray, "batch M channels"],
) -> None:
    """Add each row's gradient to its point and take it from its centroid; both outputs start at zero."""
    batch, count, k = groups.shape
    channels = points.shape[2]
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for b in range(batch):
        for m in range(count):
            centroid = centroids[b, m]
            for j in range(k):
                _widen(gradient[b, m, j], bits)
                point = points[b, groups[b, m, j]]
                for c in range(channels):
                    point[c] += value[c]
                    centroid[c] -= value[c]


@compiled
def weighted_rows(
    features: UInt16[np.ndarray, "batch refs channels"],
    nearest: Int32[np.ndarray, "batch rows 3"],
    weights: Float32[np.ndarray, "batch rows 3"],
    out: UInt16[np.ndarray, "batch rows channels"],
) -> None:
    """Compute Σ weights · features[nearest]."""
    batch, rows, _ = nearest.shape
    channels = features.shape[2]
    bits, sum_bits = np.empty(channels, np.uint32), np.empty(channels, np.uint32)
    value, total = bits.view(np.float32), sum_bits.view(np.float32)
    for b in range(batch):
        for r in range(rows):
            total[:] = 0
            for j in range(3):
                weight = weights[b, r, j]
                _widen(features[b, nearest[b, r, j]], bits)
                for c in range(channels):
                    total[c] += weight * value[c]
            _narrow(sum_bits, out[b, r])


@compiled
def weighted_rows_gradient(
    gradient: UInt16[np.ndarray, "batch rows channels"],
    nearest: Int32[np.ndarray, "batch rows 3"],
    weights: Float32[np.ndarray, "batch rows 3"],
    out: Float32[np.ndarray, "batch refs channels"],
) -> None:
    """Add each row's weighted gradient to its three sources; `out` starts at zero."""
    batch, rows, channels = gradient.shape
    bits = np.empty(channels, np.uint32)
    value = bits.view(np.float32)
    for b in range(batch):
        for r in range(rows):
            _widen(gradient[b, r], bits)
            for j in range(3):
                weight = weights[b, r, j]
                target = out[b, nearest[b, r, j]]
                for c in range(channels):
                    target[c] += weight * value[c]

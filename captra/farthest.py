"""Farthest point sampling, exact, with whole blocks of points skipped where a new choice cannot change them."""

import numpy as np
from jaxtyping import Float32, Int64

from captra.compiled import compiled, compiled_without_nan

BLOCK = 64
"""Points that share a bounding box."""

_BITS = 5
_CELLS = 2**_BITS - 1
_ROUNDING = np.float32(1 - 1e-5)
_FARTHEST_OF_ALL = np.float32(np.inf)
_NEVER = np.float32(-1.0)


@compiled
def _spread_bits(value: int) -> int:
    """Move bits 0, 1, 2, … of a small number to 0, 3, 6, … ."""
    spread = 0
    for bit in range(_BITS):
        spread |= ((value >> bit) & 1) << (3 * bit)
    return spread


@compiled
def _along_curve(points: Float32[np.ndarray, "points 3"]) -> Int64[np.ndarray, " points"]:
    """Order of the points along a Morton curve, so that neighbours in it are neighbours in space; a counting sort."""
    low = np.array([points[:, 0].min(), points[:, 1].min(), points[:, 2].min()])
    high = np.array([points[:, 0].max(), points[:, 1].max(), points[:, 2].max()])
    cells = _CELLS / max(high[0] - low[0], high[1] - low[1], high[2] - low[2], np.float32(1e-9))
    codes = np.empty(len(points), np.int64)
    starts = np.zeros(2 ** (3 * _BITS) + 1, np.int64)
    for i in range(len(points)):
        code = 0
        for axis in range(3):
            code |= _spread_bits(int((points[i, axis] - low[axis]) * cells)) << axis
        codes[i] = code
        starts[code + 1] += 1
    starts = np.cumsum(starts)
    order = np.empty(len(points), np.int64)
    for i in range(len(points)):
        order[starts[codes[i]]] = i
        starts[codes[i]] += 1
    return order


@compiled_without_nan
def farthest_order(
    points: Float32[np.ndarray, "points 3"], weights: Float32[np.ndarray, " points"], count: int
) -> Int64[np.ndarray, " count"]:
    """The first `count` (at most all) points in farthest-point order from index 0; equals go by index.

    Squared distances of point i are multiplied by weights[i]². The blocks' bounding boxes bound how near a new choice
    can be to any of their points (as in QuickFPS, Han et al. 2023); the result is that of the plain algorithm.
    Coordinates are finite. Loops are kept apart so that each is vectorized.
    """
    curve = _along_curve(points)
    total = len(points)
    blocks = (total + BLOCK - 1) // BLOCK
    x, y, z = np.zeros((3, blocks * BLOCK), np.float32)
    squared_weight = np.zeros(blocks * BLOCK, np.float32)
    low = np.full((3, blocks), _FARTHEST_OF_ALL)
    high = np.full((3, blocks), -_FARTHEST_OF_ALL)
    lightest = np.full(blocks, _FARTHEST_OF_ALL)
    for i in range(total):
        block, j = i // BLOCK, curve[i]
        squared_weight[i] = weights[j] * weights[j]
        lightest[block] = min(lightest[block], squared_weight[i])
        x[i], y[i], z[i] = points[j, 0], points[j, 1], points[j, 2]
        for axis in range(3):
            low[axis, block] = min(low[axis, block], points[j, axis])
            high[axis, block] = max(high[axis, block], points[j, axis])
    distance = np.full(blocks * BLOCK, _FARTHEST_OF_ALL)
    distance[total:] = _NEVER
    block_farthest = np.full(blocks, _FARTHEST_OF_ALL)
    bound = np.empty(blocks, np.float32)
    order = np.empty(count, np.int64)
    chosen = 0
    for step in range(count):
        order[step] = chosen
        cx, cy, cz = points[chosen, 0], points[chosen, 1], points[chosen, 2]
        for block in range(blocks):
            dx = max(low[0, block] - cx, cx - high[0, block], np.float32(0))
            dy = max(low[1, block] - cy, cy - high[1, block], np.float32(0))
            dz = max(low[2, block] - cz, cz - high[2, block], np.float32(0))
            bound[block] = (dx * dx + dy * dy + dz * dz) * lightest[block] * _ROUNDING
        farthest = _NEVER
        for block in range(blocks):
            if bound[block] < block_farthest[block]:
                largest = _NEVER
                for i in range(block * BLOCK, block * BLOCK + BLOCK):
                    ex, ey, ez = x[i] - cx, y[i] - cy, z[i] - cz
                    nearest = min(distance[i], (ex * ex + ey * ey + ez * ez) * squared_weight[i])
                    distance[i] = nearest
                    largest = max(largest, nearest)
                block_farthest[block] = largest
            farthest = max(farthest, block_farthest[block])
        chosen = total
        for block in range(blocks):
            if block_farthest[block] == farthest:
                for i in range(block * BLOCK, min(block * BLOCK + BLOCK, total)):
                    if distance[i] == farthest:
                        chosen = min(chosen, curve[i])
    return order

"""Farthest point sampling, exact, with whole blocks of points skipped where a new choice cannot change them."""

import numpy as np
from jaxtyping import Float32, Int64

from captra.compiled import compiled

BLOCK = 32
"""Points that share a bounding box."""

_CELLS = 63
_ROUNDING = np.float32(1 - 1e-5)


@compiled
def _spread_bits(value: int) -> int:
    """Move bits 0, 1, 2, … of a six-bit number to 0, 3, 6, … ."""
    spread = 0
    for bit in range(6):
        spread |= ((value >> bit) & 1) << (3 * bit)
    return spread


@compiled
def _along_curve(points: Float32[np.ndarray, "points 3"]) -> Int64[np.ndarray, " points"]:
    """Order of the points along a Morton curve, so that neighbours in it are neighbours in space."""
    low = np.array([points[:, 0].min(), points[:, 1].min(), points[:, 2].min()])
    high = np.array([points[:, 0].max(), points[:, 1].max(), points[:, 2].max()])
    cells = _CELLS / max(high[0] - low[0], high[1] - low[1], high[2] - low[2], np.float32(1e-9))
    codes = np.empty(len(points), np.int64)
    for i in range(len(points)):
        code = 0
        for axis in range(3):
            code |= _spread_bits(int((points[i, axis] - low[axis]) * cells)) << axis
        codes[i] = code
    return np.argsort(codes, kind="mergesort")


@compiled
def farthest_order(
    points: Float32[np.ndarray, "points 3"], weights: Float32[np.ndarray, " points"], count: int
) -> Int64[np.ndarray, " count"]:
    """The first `count` (at most all) points in farthest-point order from index 0; equals go by index.

    Squared distances of point i are multiplied by weights[i]². The blocks' bounding boxes bound how near a new choice
    can be to any of their points (as in QuickFPS, Han et al. 2023); the result is that of the plain algorithm.
    """
    curve = _along_curve(points)
    total = len(points)
    blocks = (total + BLOCK - 1) // BLOCK
    xyz = np.empty((total, 3), np.float32)
    squared_weight = np.empty(total, np.float32)
    low = np.full((blocks, 3), np.float32(np.inf))
    high = np.full((blocks, 3), np.float32(-np.inf))
    lightest = np.full(blocks, np.float32(np.inf))
    for i in range(total):
        block = i // BLOCK
        squared_weight[i] = weights[curve[i]] * weights[curve[i]]
        lightest[block] = min(lightest[block], squared_weight[i])
        for axis in range(3):
            value = points[curve[i], axis]
            xyz[i, axis] = value
            low[block, axis] = min(low[block, axis], value)
            high[block, axis] = max(high[block, axis], value)
    distance = np.full(total, np.float32(np.inf))
    block_farthest = np.full(blocks, np.float32(np.inf))
    block_index = np.zeros(blocks, np.int64)
    order = np.empty(count, np.int64)
    chosen = 0
    for step in range(count):
        order[step] = chosen
        cx, cy, cz = points[chosen, 0], points[chosen, 1], points[chosen, 2]
        farthest = np.float32(-1.0)
        for block in range(blocks):
            dx = max(low[block, 0] - cx, cx - high[block, 0], np.float32(0))
            dy = max(low[block, 1] - cy, cy - high[block, 1], np.float32(0))
            dz = max(low[block, 2] - cz, cz - high[block, 2], np.float32(0))
            bound = (dx * dx + dy * dy + dz * dz) * lightest[block] * _ROUNDING
            if bound < block_farthest[block]:
                largest, index = np.float32(-1.0), total
                for i in range(block * BLOCK, min(block * BLOCK + BLOCK, total)):
                    ex, ey, ez = xyz[i, 0] - cx, xyz[i, 1] - cy, xyz[i, 2] - cz
                    squared = (ex * ex + ey * ey + ez * ez) * squared_weight[i]
                    distance[i] = min(distance[i], squared)
                    if distance[i] > largest or (distance[i] == largest and curve[i] < index):
                        largest, index = distance[i], curve[i]
                block_farthest[block], block_index[block] = largest, index
            if block_farthest[block] > farthest or (block_farthest[block] == farthest and block_index[block] < chosen):
                farthest, chosen = block_farthest[block], block_index[block]
    return order

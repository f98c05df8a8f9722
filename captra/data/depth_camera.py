"""What a depth camera makes of true depth: noise, quantization, missing and mixed pixels, from none to strong."""

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float32
from scipy import ndimage

from captra.data.rendering import NOTHING, DepthPatch
from captra.data.shapes.draws import between, chance

MIXED = -2
"""Body index of flying pixels, which lie on no surface."""

_EDGE_M = 0.012


@dataclass(frozen=True)
class DepthNoise:
    """Parameters of one camera in one frame; all zero is a perfect camera."""

    axial_m: float = 0.0
    """Standard deviation of independent depth noise near the camera."""
    axial_per_m: float = 0.0
    """Its growth with the square of the distance, 1/m (stereo and structured light)."""
    lateral_px: float = 0.0
    """Standard deviation of the shift of pixels: what makes edges ragged."""
    warp_m: float = 0.0
    """Standard deviation at 1 m of depth errors shared by image regions, growing with the square of the distance."""
    warp_px: float = 30.0
    """Extent of these regions."""
    grain_m: float = 0.0
    """Standard deviation at 1 m of noise shared by a few neighbouring pixels, as matching windows make it."""
    grain_px: float = 2.5
    """Extent of the grain."""
    disparity_step_px: float = 0.0
    """Step of the measured disparity; 0 measures continuously."""
    baseline_m: float = 0.05
    """Distance between the camera's eyes, for disparity steps and shadows."""
    depth_step_m: float = 0.0
    """Step of the reported depth."""
    window_px: int = 0
    """Half the matching window: surfaces are smoothed and foregrounds grow by up to that much."""
    grazing_cosine: float = 0.0
    """Surfaces seen at a smaller cosine are lost, with a soft limit."""
    edge_loss: float = 0.0
    """Fraction of pixels next to depth edges that are lost."""
    mixing: float = 0.0
    """Fraction of pixels next to depth edges whose depth lies between both sides."""
    shadow: int = 0
    """Background that only one eye sees is lost left (1) or right (-1) of what hides it; 0 keeps it."""
    speckle_loss: float = 0.0
    """Fraction of pixels lost anywhere."""
    patch_loss: float = 0.0
    """Fraction of the surface lost in patches, on the bodies that it strikes."""
    struck: float = 0.0
    """Fraction of bodies that patches strike."""


PERFECT = DepthNoise(depth_step_m=1e-4)
"""As good as what is stored."""


def draw_noise(rng: np.random.Generator, strongest: float = 1.6) -> DepthNoise:
    """A camera drawn from none to strong noise; kinds of errors are switched on independently.

    At strength 1 a plane 1 m away is measured to a few millimetres; `strongest` bounds the draw.
    """
    if chance(rng, 0.06):
        return PERFECT
    strength = float(rng.beta(1.3, 1.8)) * strongest

    def some(probability: float, high: float) -> float:
        return between(rng, 0.1, 1.0) * high * strength if chance(rng, probability) else 0.0

    return DepthNoise(
        axial_m=some(0.9, 0.0018),
        axial_per_m=some(0.8, 0.0028),
        lateral_px=some(0.7, 1.1),
        warp_m=some(0.6, 0.005),
        warp_px=between(rng, 12, 90),
        grain_m=some(0.7, 0.0035),
        grain_px=between(rng, 1.2, 6),
        disparity_step_px=float(rng.choice([0.0, 1 / 32, 1 / 16, 1 / 8])) * min(strength * 1.3, 1.0),
        baseline_m=between(rng, 0.045, 0.09),
        depth_step_m=0.001 if chance(rng, 0.6) else 1e-4,
        window_px=int(rng.integers(0, 5)) if chance(rng, 0.5) else 0,
        grazing_cosine=between(rng, 0.03, 0.25) if chance(rng, 0.6) else 0.0,
        edge_loss=some(0.6, 0.9),
        mixing=some(0.6, 0.5),
        shadow=int(rng.choice([-1, 0, 1], p=[0.1, 0.55, 0.35])),
        speckle_loss=some(0.4, 0.15),
        patch_loss=between(rng, 0.05, 0.6) if chance(rng, 0.3) else 0.0,
        struck=between(rng, 0.2, 1.0),
    )


def observe(patch: DepthPatch, noise: DepthNoise, rng: np.random.Generator) -> DepthPatch:
    """The depth image that a camera with this noise reports; lost pixels have depth 0."""
    truth = patch
    patch = _shifted(patch, noise, rng)
    depth, body = patch.depth.copy(), patch.body.copy()
    lost = _lost(patch, noise, rng)
    near, far = _neighbour_range(depth, max(1, round(noise.window_px / patch.stride)))
    edge = (far - near > _EDGE_M * np.maximum(depth, 0.3) / 0.6) & (depth > 0)
    if noise.window_px > 0:
        depth = _smoothed(depth, edge, max(1, round(noise.window_px / patch.stride)))
    depth = _perturbed(depth, noise, rng, patch.stride)
    if noise.mixing > 0:
        mixed = edge & (rng.random(depth.shape) < noise.mixing)
        weight = rng.random(int(mixed.sum())).astype(np.float32)
        depth[mixed] = near[mixed] * weight + far[mixed] * (1 - weight)
        body[mixed] = np.where(np.abs(depth[mixed] - patch.depth[mixed]) < 0.004, body[mixed], MIXED)
    if noise.edge_loss > 0:
        lost |= edge & (rng.random(depth.shape) < noise.edge_loss)
    if noise.shadow != 0:
        lost |= _shadow(truth, noise)
    depth = _quantized(depth, noise, patch.camera.focal_px)
    depth[lost | (body == NOTHING)] = 0
    body = np.where(depth > 0, body, NOTHING).astype(np.int16)
    return replace(patch, depth=depth.astype(np.float32), body=body)


def _shifted(patch: DepthPatch, noise: DepthNoise, rng: np.random.Generator) -> DepthPatch:
    """Each pixel reports what a neighbour sees; within a matching window the nearest surface tends to win."""
    height, width = patch.depth.shape
    rows, columns = np.mgrid[:height, :width]
    if noise.window_px > 0:
        reach = max(1, round(noise.window_px / patch.stride))
        size = (2 * reach + 1, 2 * reach + 1)
        field = ndimage.uniform_filter(rng.random((height, width), dtype=np.float32), size) * np.sqrt(12) * size[0]
        offset = np.clip(np.rint((field - field.mean()) * 0.7 * reach), -reach, reach).astype(int)
        other = np.clip(columns + offset, 0, width - 1)
        nearer = (patch.depth[rows, other] > 0) & (patch.depth[rows, other] < patch.depth - _EDGE_M)
        columns = np.where(nearer, other, columns)
    if noise.lateral_px > 0:
        sigma = noise.lateral_px / patch.stride
        rows = np.clip(np.rint(rows + rng.normal(0, sigma, rows.shape)), 0, height - 1).astype(int)
        columns = np.clip(np.rint(columns + rng.normal(0, sigma, rows.shape)), 0, width - 1).astype(int)
    return replace(
        patch, depth=patch.depth[rows, columns], body=patch.body[rows, columns], cosine=patch.cosine[rows, columns]
    )


def _neighbour_range(
    depth: Float32[np.ndarray, "H W"], reach: int
) -> tuple[Float32[np.ndarray, "H W"], Float32[np.ndarray, "H W"]]:
    size = 2 * min(reach, 2) + 1
    near = ndimage.minimum_filter(np.where(depth > 0, depth, np.float32(1e3)), size)
    far = ndimage.maximum_filter(depth, size)
    return near, far


def _smoothed(
    depth: Float32[np.ndarray, "H W"], edge: Bool[np.ndarray, "H W"], reach: int
) -> Float32[np.ndarray, "H W"]:
    """Mean over the window wherever it holds a single surface."""
    whole = (depth > 0) & ~edge
    weight = ndimage.uniform_filter(whole.astype(np.float32), 2 * reach + 1)
    total = ndimage.uniform_filter(np.where(whole, depth, 0), 2 * reach + 1)
    return np.where(whole & (weight > 0.2), total / np.maximum(weight, 1e-6), depth).astype(np.float32)


def _perturbed(
    depth: Float32[np.ndarray, "H W"], noise: DepthNoise, rng: np.random.Generator, stride: int
) -> Float32[np.ndarray, "H W"]:
    squared = depth * depth
    out = depth + (noise.axial_m + noise.axial_per_m * squared) * rng.standard_normal(depth.shape, dtype=np.float32)
    if noise.grain_m > 0:
        out += noise.grain_m * squared * _field(rng, depth.shape, max(noise.grain_px / stride, 0.5))
    if noise.warp_m > 0:
        out += noise.warp_m * squared * _field(rng, depth.shape, noise.warp_px / stride)
    return np.asarray(out, np.float32)


def _field(rng: np.random.Generator, shape: tuple[int, int], extent: float) -> Float32[np.ndarray, "H W"]:
    """Smooth Gaussian field of unit variance whose features are `extent` pixels wide."""
    coarse = max(1.0, extent / 2)
    small = (int(shape[0] / coarse) + 3, int(shape[1] / coarse) + 3)
    field = ndimage.gaussian_filter(
        rng.standard_normal(small, dtype=np.float32), extent / coarse / 2 + 0.3, mode="wrap"
    )
    if coarse > 1:
        rows = np.arange(shape[0], dtype=np.float32) / coarse
        columns = np.arange(shape[1], dtype=np.float32) / coarse
        field = _bilinear(field, rows, columns)
    else:
        field = field[: shape[0], : shape[1]]
    return np.asarray(field / max(float(field.std()), 1e-6), np.float32)


def _bilinear(
    field: Float32[np.ndarray, "h w"], rows: Float32[np.ndarray, " H"], columns: Float32[np.ndarray, " W"]
) -> Float32[np.ndarray, "H W"]:
    r, c = rows.astype(int), columns.astype(int)
    fr, fc = (rows - r)[:, None], columns - c
    between_rows = field[r] * (1 - fr) + field[r + 1] * fr
    return np.asarray(between_rows[:, c] * (1 - fc) + between_rows[:, c + 1] * fc, np.float32)


def _lost(patch: DepthPatch, noise: DepthNoise, rng: np.random.Generator) -> Bool[np.ndarray, "H W"]:
    lost = patch.depth <= 0
    if noise.grazing_cosine > 0:
        limit = noise.grazing_cosine * (0.7 + 0.6 * rng.random(patch.depth.shape, dtype=np.float32))
        lost |= patch.cosine < limit
    if noise.speckle_loss > 0:
        lost |= rng.random(patch.depth.shape, dtype=np.float32) < noise.speckle_loss
    if noise.patch_loss > 0:
        field = _field(rng, patch.depth.shape, between(rng, 6, 50) / patch.stride)
        bodies = np.unique(patch.body)
        struck = bodies[rng.random(len(bodies)) < noise.struck]
        limit = np.quantile(field, noise.patch_loss)
        lost |= (field < limit) & np.isin(patch.body, struck)
    return lost


def _shadow(patch: DepthPatch, noise: DepthNoise) -> Bool[np.ndarray, "H W"]:
    """Pixels that the second eye does not see: something beside them maps to their column there, or beyond it."""
    depth = np.where(patch.depth > 0, patch.depth, 10.0)[:, :: noise.shadow]
    disparity = patch.camera.focal_px * noise.baseline_m / depth / patch.stride
    mapped = np.arange(depth.shape[1]) - disparity
    ahead = np.minimum.accumulate(mapped[:, ::-1], axis=1)[:, ::-1]
    return np.asarray((mapped > ahead + 1.0)[:, :: noise.shadow])


def _quantized(depth: Float32[np.ndarray, "H W"], noise: DepthNoise, focal_px: float) -> Float32[np.ndarray, "H W"]:
    valid = depth > 1e-3
    out = depth
    if noise.disparity_step_px > 0:
        unit = focal_px * noise.baseline_m / noise.disparity_step_px
        out = np.where(valid, unit / np.maximum(np.rint(unit / np.where(valid, depth, 1)), 1), 0)
    if noise.depth_step_m > 0:
        out = np.rint(out / noise.depth_step_m) * noise.depth_step_m
    return np.asarray(np.where(valid, out, 0), np.float32)

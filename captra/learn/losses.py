"""All losses of the paper, in canonical units (Sec. "Training Protocol", appendix "Coordinate Supervision")."""

import torch
from jaxtyping import Float, Int
from torch import Tensor, nn

from captra.categories import Category
from captra.learn.samples import Batch

DISTANCE_POINTS = 128
"""Points of each sample whose pairwise distances are compared."""

CORNER_SIGNS = torch.tensor([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
AXIS_SIGNS = torch.tensor([[0.0, y, 0.0] for y in (-0.5, 0.5)])


def rotation_from_6d(vector: Float[Tensor, "*batch 6"]) -> Float[Tensor, "*batch 3 3"]:
    """As `captra.geometry.rotation_from_6d`, differentiable."""
    x = nn.functional.normalize(vector[..., :3], dim=-1)
    z = nn.functional.normalize(torch.linalg.cross(x, vector[..., 3:]), dim=-1)
    return torch.stack([x, torch.linalg.cross(z, x), z], dim=-1)


def masked_mean(values: Float[Tensor, "*batch N"], mask: Float[Tensor, "*batch N"]) -> Float[Tensor, ""]:
    """Mean over the points of each mask, then over the masks that hold any."""
    count = mask.sum(dim=-1)
    per_mask = (values * mask).sum(dim=-1) / count.clamp(min=1)
    return per_mask.sum() / (count > 0).sum().clamp(min=1)


def part_masks(labels: Int[Tensor, "batch N"], parts: int) -> Float[Tensor, "batch parts N"]:
    """One mask a part from class labels."""
    return torch.stack([(labels == part).float() for part in range(parts)], dim=1)


def segmentation_loss(logits: Float[Tensor, "batch classes N"], labels: Int[Tensor, "batch N"]) -> Float[Tensor, ""]:
    """Relaxed IoU (Yi et al. 2018) and cross entropy, which gives it a slope where masks do not overlap yet.

    Points whose label is none of the classes, strays on a pre-segmented object, do not count.
    """
    classes = logits.shape[1]
    counted = (labels < classes).unsqueeze(1)
    probability = logits.softmax(dim=1) * counted
    truth = nn.functional.one_hot(labels.clamp(max=classes - 1), classes).movedim(-1, 1) * counted.to(logits.dtype)
    shared = (probability * truth).sum(dim=-1)
    union = (probability + truth - probability * truth).sum(dim=-1)
    present = (truth.sum(dim=-1) > 0).float()
    relaxed = ((1 - shared / union.clamp(min=1e-6)) * present).sum() / present.sum()
    return relaxed + nn.functional.cross_entropy(logits, labels.masked_fill(labels >= classes, -100), ignore_index=-100)


def coordinate_loss(
    predicted: Float[Tensor, "batch parts N 3"],
    truth: Float[Tensor, "batch parts N 3"],
    mask: Float[Tensor, "batch parts N"],
) -> Float[Tensor, ""]:
    """Distance between predicted and true coordinates over each part's points."""
    return masked_mean(_norm(predicted - truth), mask)


def symmetric_coordinate_loss(
    predicted: Float[Tensor, "batch parts N 3"],
    truth: Float[Tensor, "batch parts N 3"],
    mask: Float[Tensor, "batch parts N"],
) -> Float[Tensor, ""]:
    """Distance in (radius, height) about y, which a turn about y leaves alone."""

    def profile(points: Tensor) -> Tensor:
        return torch.stack([_norm(points[..., [0, 2]]), points[..., 1]], dim=-1)

    return masked_mean(_norm(profile(predicted) - profile(truth)), mask)


def pairwise_distance_loss(
    predicted: Float[Tensor, "batch parts N 3"],
    truth: Float[Tensor, "batch parts N 3"],
    mask: Float[Tensor, "batch parts N"],
) -> Float[Tensor, ""]:
    """Difference of the distance matrices of a few points of the object."""
    noise = torch.rand_like(mask) + mask
    chosen = noise.topk(DISTANCE_POINTS, dim=-1).indices
    used = mask.gather(-1, chosen)

    def distances(points: Tensor) -> Tensor:
        few = points.gather(-2, chosen[..., None].expand(*chosen.shape, 3))
        return _norm(few[..., :, None, :] - few[..., None, :, :])

    pairs = used[..., :, None] * used[..., None, :]
    return masked_mean((distances(predicted) - distances(truth)).abs().flatten(-2), pairs.flatten(-2))


def pose_losses(
    predicted: Float[Tensor, "batch parts N 3"], batch: Batch, mask: Float[Tensor, "batch parts N"], category: Category
) -> tuple[Float[Tensor, ""], Float[Tensor, ""], Float[Tensor, ""]]:
    """Errors of scale, translation and box corners that follow from the coordinates, given the true rotation and mask.

    Scale and translation are the closed form of `captra.fitting.scale_and_translation`, translation at the true scale.
    """
    if category.symmetric:
        predicted = _turned_about_y(predicted, batch.coordinates, mask)
    weight = mask / mask.sum(dim=-1, keepdim=True).clamp(min=1)
    rotated = predicted @ batch.rotation.mT
    points = batch.points
    centre_w = (rotated * weight[..., None]).sum(dim=-2, keepdim=True)
    centre_c = (points * weight[..., None]).sum(dim=-2, keepdim=True)
    w, c = rotated - centre_w, points - centre_c
    scale = (weight * (w * c).sum(-1)).sum(-1) / (weight * (w * w).sum(-1)).sum(-1).clamp(min=1e-4)
    translation = (centre_c - batch.scale[..., None, None] * centre_w).squeeze(-2)
    present = (mask.sum(dim=-1) > 3).float()

    def mean(values: Tensor) -> Tensor:
        return (values * present).sum() / present.sum().clamp(min=1)

    scale_error = mean((scale / batch.scale - 1).abs().clamp(max=2))
    translation_error = mean(_norm(translation - batch.translation))
    fitted = (centre_c - scale[..., None, None] * centre_w).squeeze(-2)
    signs = AXIS_SIGNS if category.symmetric else CORNER_SIGNS
    corners = (signs * batch.aspect[..., None, :]) @ batch.rotation.mT
    true_corners = corners * batch.scale[..., None, None] + batch.translation[..., None, :]
    fitted_corners = corners * scale[..., None, None] + fitted[..., None, :]
    return scale_error, translation_error, mean(_norm(fitted_corners - true_corners).mean(-1).clamp(max=2))


def rotation_losses(
    raw: Float[Tensor, "batch parts N width"], batch: Batch, mask: Float[Tensor, "batch parts N"], category: Category
) -> tuple[Float[Tensor, ""], Float[Tensor, ""]]:
    """Squared Frobenius distance to the true residual rotation per point, and distance of the box corners it turns.

    Symmetric objects: squared distance of the y axes, and of the two points where the axis leaves the box.
    """
    if category.symmetric:
        axis = nn.functional.normalize(raw, dim=-1)
        true_axis = batch.rotation[..., :, 1].unsqueeze(-2)
        error = (axis - true_axis).square().sum(-1)
        return masked_mean(error, mask), masked_mean(_norm(axis - true_axis) * batch.aspect[..., 1:2] / 2, mask)
    rotation = rotation_from_6d(raw)
    difference = rotation - batch.rotation.unsqueeze(-3)
    corners = CORNER_SIGNS * batch.aspect[..., None, :]
    moved = difference @ corners.mT.unsqueeze(-3)
    return masked_mean(difference.square().sum((-1, -2)), mask), masked_mean(_norm(moved.mT).mean(-1), mask)


def upright_loss(
    raw: Float[Tensor, "batch parts N 6"], batch: Batch, mask: Float[Tensor, "batch parts N"]
) -> Float[Tensor, ""]:
    """Squared distance of the y axes: tilt alone, untouched by a turn about y that the view may leave open."""
    axis = rotation_from_6d(raw)[..., :, 1]
    return masked_mean((axis - batch.rotation[..., :, 1].unsqueeze(-2)).square().sum(-1), mask)


def _turned_about_y(
    predicted: Float[Tensor, "batch parts N 3"],
    truth: Float[Tensor, "batch parts N 3"],
    mask: Float[Tensor, "batch parts N"],
) -> Float[Tensor, "batch parts N 3"]:
    """Turn predicted coordinates about y to where they fit the true ones best."""
    weight = (mask / mask.sum(dim=-1, keepdim=True).clamp(min=1))[..., None]
    p = predicted - (predicted * weight).sum(dim=-2, keepdim=True)
    t = truth - (truth * weight).sum(dim=-2, keepdim=True)
    dot = (weight[..., 0] * (p[..., 0] * t[..., 0] + p[..., 2] * t[..., 2])).sum(-1)
    cross = (weight[..., 0] * (t[..., 0] * p[..., 2] - t[..., 2] * p[..., 0])).sum(-1)
    length = torch.sqrt(dot.square() + cross.square() + 1e-12)
    cosine, sine = (dot / length)[..., None], (cross / length)[..., None]
    x, y, z = predicted.unbind(-1)
    return torch.stack([cosine * x + sine * z, y, cosine * z - sine * x], dim=-1)


def _norm(vector: Float[Tensor, "*batch 3"]) -> Float[Tensor, "*batch"]:
    return torch.sqrt(vector.square().sum(-1) + 1e-8)

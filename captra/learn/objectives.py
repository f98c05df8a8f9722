"""What each network minimizes: the paper's losses with its authors' weights.

RotationNet has one term more: the weakly observed turn of an upright object about y, say of a mug whose handle is
hidden, outweighs its tilt in the Frobenius distance by far, so that tilt is learned last; the y axis alone is therefore
compared too.
"""

import torch
from jaxtyping import Float
from torch import Tensor

from captra.categories import Category
from captra.learn import losses
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.rotation_net import RotationNet
from captra.learn.samples import Batch

Terms = dict[str, Float[Tensor, ""]]


def coordinate_objective(network: CoordinateNet, batch: Batch, category: Category) -> tuple[Float[Tensor, ""], Terms]:
    """Total loss of CoordinateNet and its terms by name."""
    logits, coordinates = network(batch.points[:, category.root], batch.root_neighborhoods)
    logits, coordinates = logits.float(), coordinates.float()
    mask = losses.part_masks(batch.labels, category.num_parts)
    scale, translation, corners = losses.pose_losses(coordinates, batch, mask, category)
    terms = {"segmentation": losses.segmentation_loss(logits, batch.labels)}
    if category.symmetric:
        terms["coordinates"] = 5 * losses.symmetric_coordinate_loss(coordinates, batch.coordinates, mask)
        terms["distances"] = 5 * losses.pairwise_distance_loss(coordinates, batch.coordinates, mask)
    else:
        terms["coordinates"] = 10 * losses.coordinate_loss(coordinates, batch.coordinates, mask)
    terms |= {"scale": 5 * scale, "translation": 5 * translation, "corners": 10 * corners}
    return torch.stack(list(terms.values())).sum(), terms


def rotation_objective(
    network: RotationNet, batch: Batch, category: Category, head_points: int
) -> tuple[Float[Tensor, ""], Terms]:
    """Total loss of RotationNet on one part a sample and the first `head_points` points, and its terms by name."""
    part = batch.rotation_part
    chosen = torch.arange(len(part)), part
    raw = network.one_part(batch.points[chosen], part, batch.rotation_neighborhoods, head_points).unsqueeze(1)
    mask = (batch.labels[:, :head_points] == part[:, None]).float().unsqueeze(1)
    truth = batch._replace(rotation=batch.rotation[chosen].unsqueeze(1), aspect=batch.aspect[chosen].unsqueeze(1))
    rotation, corners = losses.rotation_losses(raw, truth, mask, category)
    terms = {"rotation": 10 * rotation, "corners": corners}
    if not category.symmetric:
        terms["upright"] = 20 * losses.upright_loss(raw, truth, mask)
    return torch.stack(list(terms.values())).sum(), terms

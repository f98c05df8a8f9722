"""Rounding that is made up for on clouds as training shows them."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float32

from captra.categories import Category
from captra.data.dataset import ViewDataset
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.perturbation import PerturbationMix
from captra.learn.plan import Plan
from captra.learn.rotation_net import RotationNet
from captra.learn.samples import SampleMaker
from captra.runtime.onnx_networks import feed, rotated_points_of
from captra.sampling import REALTIME, NoPointsError, build_neighborhoods
from export.onnx_export import coordinate_model, rotation_model
from export.products import Feed, coarseness, second_moments
from export.rounding import NEAREST, Compensated, Rounding

VIEWS = 64
"""So many show every product a hundred times as many inputs as it has."""
ANSWERED = 12
"""On so many of them it is seen what rounding one matrix does to the answers."""

RoundingOf = Callable[[CoordinateNet | RotationNet], Rounding]
"""How the weights of a network are rounded."""


def to_nearest(_network: CoordinateNet | RotationNet) -> Rounding:
    """Whatever the network, every weight by itself."""
    return NEAREST


@dataclass(frozen=True)
class MadeUpFor:
    """Each network's rounding errors are made up for on views, perturbed as in training; bits go where they count."""

    category: Category
    """Of the networks."""
    views: ViewDataset
    """As `captra generate` makes them."""
    seed: int = 0
    """Of which are taken, and of how they are perturbed."""

    @staticmethod
    def on(category: Category, folder: Path) -> "MadeUpFor":
        """On the views of a folder.

        Raises:
            ViewsError: there are none, or they show objects of other parts.
        """
        views = ViewDataset(folder)
        if len(views) == 0:
            raise ViewsError(
                f"there are no views in {folder}: make some with "
                f"captra generate --category {category.name} --count 200 --seed 1 --out {folder}"
            )
        if (parts := len(views[0].rotation)) != category.num_parts:
            raise ViewsError(
                f"the views in {folder} are of {parts} part(s), but {category.name} has {category.num_parts}: "
                "give those that it was trained on"
            )
        return MadeUpFor(category, views)

    def __call__(self, network: CoordinateNet | RotationNet) -> Rounding:
        """Made up for on what the network's products are given when it looks at the views."""
        if isinstance(network, CoordinateNet):
            model, feeds = coordinate_model(network, "float32"), list(self._of_coordinate_net())
        else:
            model, feeds = rotation_model(network, "float32"), list(self._of_rotation_net())
        moments = second_moments(model, feeds)
        return Compensated(moments, coarseness(model, moments, feeds[:ANSWERED]))

    def _of_coordinate_net(self) -> Iterator[Feed]:
        for points in self._clouds():
            cloud = points[self.category.root]
            yield feed(cloud[None], [build_neighborhoods(cloud, REALTIME)])

    def _of_rotation_net(self) -> Iterator[Feed]:
        rotated = rotated_points_of(Plan.rotation_share, REALTIME)
        for points in self._clouds():
            inputs = feed(points, [build_neighborhoods(cloud, REALTIME) for cloud in points])
            yield inputs | {"nearest1": inputs["nearest1"][:, :rotated]}

    def _clouds(self) -> Iterator[Float32[np.ndarray, "parts points 3"]]:
        """Canonical clouds of all parts; views of which nothing is left are passed over."""
        rng = np.random.default_rng(self.seed)
        make_sample = SampleMaker(self.category, Plan().density, PerturbationMix.for_category(self.category))
        for index in rng.permutation(len(self.views))[:VIEWS]:
            try:
                yield make_sample(self.views[int(index)], REALTIME, rng).points
            except NoPointsError:
                continue


class ViewsError(ValueError):
    """There is nothing to learn from them."""

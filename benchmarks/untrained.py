"""Bundles of untrained networks: speed does not depend on weights."""

import tempfile
from dataclasses import replace
from pathlib import Path

from captra.categories import get_category
from captra.learn.checkpoint import save_checkpoint
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.plan import Plan
from captra.learn.rotation_net import RotationNet
from captra.runtime.bundle import Manifest, Training
from export.bundles import export_bundle


def write_untrained(category_name: str, out: Path) -> None:
    """Networks as training starts with them, exported."""
    category = get_category(category_name)
    coordinate_net = CoordinateNet(category.num_parts, category.num_classes)
    rotation_net = RotationNet(category.num_parts, category.symmetric)

    def untrained(manifest: Manifest) -> Manifest:
        return replace(manifest, training=Training("none", 0), rotation_share=Plan().rotation_share)

    with tempfile.TemporaryDirectory() as folder:
        checkpoints = [Path(folder, f"{name}.pt") for name in ("coordinate", "rotation")]
        for path, network in zip(checkpoints, (coordinate_net, rotation_net), strict=True):
            save_checkpoint(path, network, {"samples": 0})
        export_bundle(*checkpoints, category, "float16", out, describe=untrained)

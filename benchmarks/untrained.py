"""A models folder for benchmarks: the bundles that ship, and untrained networks of categories that have none.

Speed does not depend on weights. `make bench` calls it:

    .venv/bin/python -m benchmarks.untrained .bench/models drawers
"""

import sys
import tempfile
from dataclasses import replace
from pathlib import Path

from captra import shipped
from captra.categories import get_category
from captra.learn.checkpoint import save_checkpoint
from captra.learn.coordinate_net import CoordinateNet
from captra.learn.plan import Plan
from captra.learn.rotation_net import RotationNet
from captra.runtime.bundle import Manifest, Training, find_bundles
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


def main(out: Path, categories: list[str]) -> None:
    """Links to the bundles that ship; the others are written unless they are there."""
    out.mkdir(parents=True, exist_ok=True)
    bundles = find_bundles(shipped.MODELS)
    for name, folder in bundles.items():
        link = out / name
        if not link.is_symlink():
            link.symlink_to(folder.resolve())
    for name in categories:
        if name not in bundles and not (out / name).exists():
            print(f"{name} has no bundle: its networks are untrained, which changes nothing about their speed")
            write_untrained(name, out / name)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])

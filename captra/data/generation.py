"""Views in bulk: deterministic, resumable, one shard at a time."""

import json
import os
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np

from captra.categories import get_category
from captra.data.dataset import SHARD_PATTERN, pack, read_shard, write_shard
from captra.data.shapes.shape import Shape
from captra.data.view import View
from captra.data.views import HiddenObjectError, ViewOptions, make_view
from captra.errors import UserError

VIEWS_PER_SHARD = 500
CONTENT = "views.json"
"""Says whose views a folder holds; those of earlier versions have none."""


class OtherViewsError(UserError):
    """A folder holds views of another category."""


def generate_view(
    category: str, draw_shape: Callable[[np.random.Generator], Shape], seed: int, index: int, options: ViewOptions
) -> View:
    """View number `index` of a seed; it depends on nothing else."""
    rng = np.random.default_rng([seed, index, *category.encode()])
    while True:
        try:
            return make_view(draw_shape(rng), rng, options)
        except HiddenObjectError:
            continue  # another shape: the stream of random numbers has moved on


def generate_views(
    category: str,
    count: int,
    seed: int,
    folder: Path,
    draw_shape: Callable[[np.random.Generator], Shape],
    options: ViewOptions | None = None,
    progress: Callable[[int], None] = lambda _: None,
    views_per_shard: int = VIEWS_PER_SHARD,
) -> None:
    """Write `count` views as shards; shards that are there already are kept, so it can be stopped at any time.

    Raises:
        OtherViewsError: the shards that are there are of another category.
    """
    folder = Path(folder)
    keep_for(category, folder)
    for start in range(0, count, views_per_shard):
        target = folder / f"seed-{seed:04d}_shard-{start // views_per_shard:05d}"
        stop = min(start + views_per_shard, count)
        if target.exists() and len(read_shard(target)) >= stop - start:
            progress(stop)
            continue
        shutil.rmtree(target, ignore_errors=True)
        views = [generate_view(category, draw_shape, seed, i, options or ViewOptions()) for i in range(start, stop)]
        write_shard(target, pack(views))
        progress(stop)


def keep_for(category: str, folder: Path) -> None:
    """Make a folder for views of a category, and note that; shards of an earlier version are looked at instead.

    Raises:
        OtherViewsError: it holds views of another one.
    """
    folder.mkdir(parents=True, exist_ok=True)
    note, shard = folder / CONTENT, next(folder.glob(SHARD_PATTERN), None)
    if note.exists():
        held = json.loads(note.read_text())["category"]
    else:
        held = category if shard is None or _may_show(category, shard) else "another category"
    if held != category:
        raise OtherViewsError(
            f"{folder} holds views of {held}, and those of {category} would bear the same names: name another folder "
            f"by --out, such as .campaign/views/{category}/train"
        )
    if shard is None and not note.exists():
        partial = folder / f".{CONTENT}.{os.getpid()}"
        partial.write_text(json.dumps({"category": category}) + "\n")
        partial.replace(note)


def _may_show(category: str, shard: Path) -> bool:
    views, known = read_shard(shard), get_category(category)
    return (views.rotation.shape[1], views.joint_values.shape[1]) == (known.num_parts, len(known.joints))


def write_sources(folder: Path, sources: Mapping[str, str]) -> None:
    """Note which library objects (name → licence and author) views of a folder were made from, beside earlier ones."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "sources.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    path.write_text(json.dumps({**known, **sources}, indent=2, sort_keys=True) + "\n")

"""Where test sequences come from."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from captra.data.recordings import Recording, load_recording

TEST_SEED = 900_000
"""Procedural test instances are drawn from seeds that training never uses."""

VALIDATION_SEED = 800_000
"""Likewise those for choosing checkpoints and fitting the confidence."""


def recordings_in(folder: Path, category: str) -> Iterator[Recording]:
    """All recordings of a category in a folder, by name."""
    for path in sorted(folder.glob(f"{category}__*.npz")):
        yield load_recording(path)


def procedural(category: str, count: int, frames: int = 100, first_seed: int = TEST_SEED) -> Iterator[Recording]:
    """Sequences of unseen procedural instances, half of them held and half on a table."""
    from captra.data.sequences import make_sequence
    from captra.data.shapes.registry import make_shape

    for index in range(count):
        seed = first_seed + index
        shape = make_shape(category, np.random.default_rng(seed))
        yield make_sequence(shape, seed, frames=frames, motion="hand" if index % 2 else "table")

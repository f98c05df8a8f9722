"""Where test sequences come from; a source is small, so that the process that tracks a sequence can load it itself."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

import numpy as np

from captra.categories import get_category
from captra.data.recordings import Recording, load_recording
from captra.data.shapes.shape import Shape
from captra.evaluation.model_points import ModelPoints, from_recording, from_shape
from captra.evaluation.sequence_cache import SequenceCache, shape_digest

if TYPE_CHECKING:
    from captra.data.sequences import Motion

TEST_SEED = 900_000
"""Procedural test instances are drawn from seeds that training never uses."""

VALIDATION_SEED = 800_000
"""Likewise those for choosing checkpoints and fitting the confidence."""

RESEEDS = 5
RESEED_STRIDE = 10_000
"""Between the seeds that are tried until a sequence keeps the object in sight."""

MOTIONS: "tuple[Motion, ...]" = ("table", "hand")
"""As objects are met; a standalone one is only met in the paper's articulated dataset."""


@dataclass(frozen=True)
class Sequence:
    """A recording and the true surface of its object."""

    recording: Recording
    """With its truth."""
    model: ModelPoints
    """Points of each part in the part's own frame, metres."""


class SequenceSource(Protocol):
    """One test sequence, not loaded yet."""

    @property
    def name(self) -> str:
        """Of the recording."""

    def load(self) -> Sequence:
        """Read or simulate it."""


@dataclass(frozen=True)
class RecordingFile:
    """A recording on disk."""

    path: Path
    """Of the file."""
    meshes: Path | None = None
    """Library that may hold the recorded object."""

    @property
    def name(self) -> str:
        """The file's name without its ending."""
        return self.path.stem

    def load(self) -> Sequence:
        """Read it; the surface is that of the object's mesh, or else what the recording shows of it."""
        recording = load_recording(self.path)
        shape = self._shape(recording)
        return Sequence(recording, from_recording(recording) if shape is None else from_shape(shape))

    def _shape(self, recording: Recording) -> Shape | None:
        if self.meshes is None:
            return None
        from captra.data.meshes import find_mesh

        return find_mesh(self.meshes, recording.category.name, "__".join(self.name.split("__")[1:-1]))


@dataclass(frozen=True)
class SimulatedSequence:
    """A shape that is filmed, or was."""

    name: str
    """Of the object and its motion."""
    draw_shape: Callable[[], Shape]
    """Gives the object; can be sent to another process."""
    seed: int
    """Of scene, motion and noise."""
    motion: "Motion"
    """As `captra.data.sequences.make_sequence` has it."""
    frames: int
    """At 30 Hz."""
    cache: SequenceCache
    """Keeps it."""

    def load(self) -> Sequence:
        """Film the shape, unless that was done before."""
        shape = self.draw_shape()
        key = f"{shape_digest(shape)}-{self.seed}-{self.frames}"
        return Sequence(self.cache.get(self.name, key, partial(self._film, shape)), from_shape(shape))

    def _film(self, shape: Shape) -> Recording:
        from captra.data.sequences import make_sequence
        from captra.data.views import HiddenObjectError

        for attempt in range(RESEEDS):
            try:
                seed = self.seed + attempt * RESEED_STRIDE
                return replace(make_sequence(shape, seed, self.frames, self.motion), name=self.name)
            except HiddenObjectError:
                continue
        raise HiddenObjectError(f"{self.name} hides its object from every seed: leave it out")


def recordings_in(folder: Path, category: str, meshes: Path | None = None) -> Iterator[RecordingFile]:
    """All recordings of a category in a folder, by name."""
    for path in sorted(folder.glob(f"{category}__*.npz")):
        yield RecordingFile(path, meshes)


def procedural(
    category: str, count: int, cache: SequenceCache, frames: int = 100, first_seed: int = TEST_SEED
) -> Iterator[SimulatedSequence]:
    """Sequences of unseen procedural instances, half of them held and half on a table."""
    for index in range(count):
        yield _of_instance(category, first_seed + index, MOTIONS[index % len(MOTIONS)], cache, frames)


def standalone(category: str, count: int, cache: SequenceCache, frames: int = 100) -> Iterator[SimulatedSequence]:
    """Sequences of the same unseen instances, each by itself before a perfect camera, as in the paper's SAPIEN dataset.

    That has articulated objects only: of others there are none.
    """
    for index in range(0 if get_category(category).background else count):
        yield _of_instance(category, TEST_SEED + index, "alone", cache, frames)


def library(folder: Path, category: str, cache: SequenceCache, frames: int = 100) -> Iterator[SimulatedSequence]:
    """Every object of a library that is for validation, once held and once on a table.

    Raises:
        LibraryError: the folder has no INDEX.json.
    """
    from captra.data.meshes import load_meshes

    for index, mesh in enumerate(load_meshes(folder, category, "validate")):
        for motion in MOTIONS:
            name = f"{category}__{mesh.name.split('/')[1]}__{motion}"
            yield SimulatedSequence(name, partial(_same, mesh.shape), TEST_SEED + index, motion, frames, cache)


def _of_instance(category: str, seed: int, motion: "Motion", cache: SequenceCache, frames: int) -> SimulatedSequence:
    name = f"{category}__procedural-{seed}__{motion}"
    return SimulatedSequence(name, partial(_procedural_shape, category, seed), seed, motion, frames, cache)


def _procedural_shape(category: str, seed: int) -> Shape:
    from captra.data.shapes.registry import make_shape

    return make_shape(category, np.random.default_rng(seed))


def _same(shape: Shape) -> Shape:
    return shape

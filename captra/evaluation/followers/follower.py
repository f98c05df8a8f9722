"""What follows an object, and what comes out of it."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from jaxtyping import Float32

from captra.evaluation.sequences import Sequence
from captra.geometry import Pose
from captra.health import State
from captra.looking import Networks
from captra.sampling import NoPointsError


@dataclass(frozen=True)
class Track:
    """A follower's answers for all frames but the first."""

    poses: tuple[Pose, ...]
    """One a frame."""
    states: tuple[State, ...] = ()
    """Likewise; empty for followers that do not judge themselves."""


class Follower(Protocol):
    """Follows one object; small and hashable, so that other processes can have it."""

    @property
    def label(self) -> str:
        """As tables name it."""

    def __call__(self, networks: Networks, sequence: Sequence) -> Track:
        """Follow the object from the sequence's first pose."""


def follow(
    sequence: Sequence, start: Pose, step: Callable[[Float32[np.ndarray, "all 3"], int, Pose], Pose]
) -> tuple[Pose, ...]:
    """Poses of frames 1, 2, … when `step` gives each from its cloud, its number and the pose before.

    A frame without points keeps the last pose.
    """
    poses, pose = [], start
    for frame in range(1, len(sequence.recording)):
        with suppress(NoPointsError):
            pose = step(sequence.recording.clouds[frame], frame, pose)
        poses.append(pose)
    return tuple(poses)

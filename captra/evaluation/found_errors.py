"""By how much networks err on one object all the time: what the first frame of a track tells of the frames after it."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from jaxtyping import Float64

from captra.categories import Y_AXIS, Category
from captra.data.recordings import Recording
from captra.evaluation.followers.follower import follow
from captra.evaluation.observability import symmetric_frames
from captra.evaluation.runner import NetworksSource, loaded
from captra.evaluation.sequences import SequenceSource
from captra.evaluation.workers import Workers
from captra.fitting import rotation_about_axis
from captra.geometry import Pose, rotation_vector
from captra.pose_memory import NO_ERROR, USUAL_ERROR, FoundError, PerAxis
from captra.size_memory import SizeMemory
from captra.tracker import Tracker, TrackerOptions

LARGEST_CENTRE, LARGEST_ROTATION_DEG = 0.15, 8.0
"""Of single frames, in units of the scale and in degrees; larger errors count as no more: the track is lost, and it is
not for the given pose to put that right."""

LARGEST_SIDE = 0.3
"""Likewise of scales, in logarithms, and of sides, in units of the scale."""

Errors = tuple[Float64[np.ndarray, "frames parts 3"], Float64[np.ndarray, "frames parts 3"]]
"""Of centres in units of the scale, along the axes of each part, and of rotations in degrees, about them; NaN for what
nothing in the frame tells."""

SizeErrors = tuple[Float64[np.ndarray, "parts 1"], Float64[np.ndarray, "parts 3"]]
"""Of scales, in logarithms, and of boxes' sides, in units of the scale, in the mean of a track; NaN for parts that were
never seen."""


def measure_found_error(
    category: Category, networks: NetworksSource, sources: Sequence[SequenceSource], workers: Workers
) -> FoundError:
    """Standard deviations of what stays the same in the errors of a track, over sequences of as many objects.

    What comes and goes from frame to frame is no business of the memory: a constant error's variance is the covariance
    of the first frame's error with that of the others. Sizes are measured in the mean of a track, and never taken to be
    told better than usual, since an object unlike all of these is told worse; how much the given ones count while
    centres are measured is what the networks come with.
    """
    centres, turns, scales, sides = zip(*workers.map(partial(_errors, networks), sources), strict=True)
    found = FoundError(
        centre=_lasting(centres, LARGEST_CENTRE),
        rotation_deg=_lasting(turns, LARGEST_ROTATION_DEG),
        scale=tuple((float(scale),) for (scale,) in np.maximum(_spread(scales), USUAL_ERROR.scale)),
        side=tuple((float(x), float(y), float(z)) for x, y, z in np.maximum(_spread(sides), USUAL_ERROR.side)),
    )
    return _round_about_y(found) if category.symmetric else found


def _round_about_y(error: FoundError) -> FoundError:
    """Of an object that looks the same all round: which of its axes is called x is chance."""

    def even(rows: PerAxis) -> PerAxis:
        return tuple((mean, y, mean) for x, y, z in rows for mean in [round(float(np.hypot(x, z) / np.sqrt(2)), 4)])

    return replace(error, centre=even(error.centre), rotation_deg=even(error.rotation_deg), side=even(error.side))


def describe(error: FoundError) -> str:
    """For people: the largest and the smallest of all parts and axes."""
    centre_percent, side_percent = 100 * np.array(error.centre), 100 * np.array(error.side)
    rotation_deg = np.array(error.rotation_deg)
    return (
        f"centres stay off by {centre_percent.min():.1f} to {centre_percent.max():.1f} % of the scale, rotations by "
        f"{rotation_deg.min():.1f} to {rotation_deg.max():.1f}° (standard deviations along and about the axes of "
        f"parts), sides of boxes by {side_percent.min():.1f} to {side_percent.max():.1f} % of the scale"
    )


def _lasting(errors: Sequence[Float64[np.ndarray, "frames parts 3"]], largest: float) -> PerAxis:
    """Standard deviation of the constant part of errors, each from one sequence; 0 where nothing was ever told."""
    bounded = [np.clip(one, -largest, largest) for one in errors]
    products = np.stack([one[0] * _mean(one[1:]) for one in bounded])
    variance = np.maximum(np.nan_to_num(_mean(products)), 0.0)
    return tuple((float(x), float(y), float(z)) for x, y, z in np.sqrt(variance).round(4))


def _spread(errors: Sequence[Float64[np.ndarray, "parts numbers"]]) -> Float64[np.ndarray, "parts numbers"]:
    """Of errors, each from one sequence, about zero; 0 where nothing was ever told."""
    squared = np.square(np.clip(np.stack(errors), -LARGEST_SIDE, LARGEST_SIDE))
    return np.asarray(np.sqrt(np.nan_to_num(_mean(squared))).round(4))


def _mean(rows: Float64[np.ndarray, "rows parts 3"]) -> Float64[np.ndarray, "parts 3"]:
    """Over the rows that tell something; NaN where none does."""
    told = np.isfinite(rows)
    count = told.sum(axis=0)
    return np.asarray(np.where(told, rows, 0.0).sum(axis=0) / np.where(count, count, np.nan))


def _errors(networks: NetworksSource, source: SequenceSource) -> tuple[np.ndarray, ...]:
    """Track a sequence with networks that are taken at their word about where parts are: `Errors`, `SizeErrors`."""
    sequence = source.load()
    recording = sequence.recording
    known = loaded(networks)
    taken_at_their_word = replace(known.found_error, centre=NO_ERROR.centre, rotation_deg=NO_ERROR.rotation_deg)
    tracker = Tracker(known, recording.init, options=TrackerOptions(found_error=taken_at_their_word))
    poses = follow(sequence, recording.init, lambda cloud, *_: tracker.step(cloud).pose)
    symmetric = symmetric_frames(recording)
    turn_is_unknown = symmetric & (not recording.category.symmetric)
    rows = [_error(pose, recording, frame, symmetric=bool(symmetric[frame])) for frame, pose in enumerate(poses, 1)]
    centres, turns = (np.stack(column) for column in zip(*rows, strict=True))
    turns[turn_is_unknown[1:], :, 1] = np.nan
    return centres, turns, *_size_error(tracker.size, recording.truth(0))


def _size_error(remembered: SizeMemory, truth: Pose) -> SizeErrors:
    """Of what the frames of a track measured, whatever size was given."""
    seen = (remembered.frames > 0)[:, None]
    scale = remembered.mean_log_scale - np.log(truth.scale)
    side = (np.exp(remembered.mean_log_size) - truth.size) / truth.scale[:, None]
    return np.where(seen, scale[:, None], np.nan), np.where(seen, side, np.nan)


def _error(pose: Pose, recording: Recording, frame: int, *, symmetric: bool) -> Errors:
    """Of one frame; that of an object which looks the same all round is its tilt."""
    truth = recording.truth(frame)
    to_part = np.swapaxes(truth.rotation, -1, -2)
    centre = (to_part @ (pose.translation - truth.translation)[..., None])[..., 0] / truth.scale[:, None]
    turned = to_part @ pose.rotation
    if symmetric:
        turned = np.stack([one @ rotation_about_axis(one, np.array(Y_AXIS)).T for one in turned])
    return centre, np.degrees(rotation_vector(turned))

"""One step of the method on arrays that are given, without cropping or resampling: for comparison with other code."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from jaxtyping import Float32

from captra.canonical import canonicalize
from captra.geometry import Pose
from captra.looking import Networks, predict
from captra.sampling import PAPER, Profile, build_neighborhoods
from captra.solving import solve

INPUTS = ("points", "last_scale", "last_rotation", "last_translation")


class StepInputError(ValueError):
    """Arrays that no step can start from."""


def profile_for(points: Float32[np.ndarray, "N 3"]) -> Profile:
    """The profile `paper` for as many points as there are."""
    return replace(PAPER, points=len(points))


def check_inputs(arrays: Mapping[str, np.ndarray], parts: int) -> None:
    """Look at names, shapes and numbers.

    Raises:
        StepInputError: an array is missing, has another shape, or holds what is no number; a scale is none.
    """
    if missing := [name for name in INPUTS if name not in arrays]:
        raise StepInputError(f"the input lacks {', '.join(missing)}: it needs {', '.join(INPUTS)}")
    shapes = {"last_scale": (parts,), "last_rotation": (parts, 3, 3), "last_translation": (parts, 3)}
    for name, shape in shapes.items():
        if arrays[name].shape != shape:
            raise StepInputError(f"{name} has shape {arrays[name].shape}: the bundle's {parts} part(s) need {shape}")
    points = arrays["points"]
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < PAPER.centroids[0]:
        raise StepInputError(
            f"points have shape {points.shape}: at least {PAPER.centroids[0]} rows of x, y, z are needed"
        )
    for name in INPUTS:
        if arrays[name].dtype.kind not in "iuf" or not np.isfinite(arrays[name]).all():
            raise StepInputError(f"{name} holds NaN, infinity or no numbers at all: give numbers, metres")
    if not (arrays["last_scale"] > 0).all():
        raise StepInputError(f"last_scale is {arrays['last_scale'].tolist()}: give the diagonals of the boxes, metres")


def step_arrays(networks: Networks, arrays: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
    """One step.

    Args:
        networks: at `profile_for(points)`.
        arrays: `points` (N, 3) m in farthest-point order, `last_scale` (P,) m, `last_rotation` (P, 3, 3) and
            `last_translation` (P, 3) m.

    Returns:
        `seg` (C, N) softmax, `coords` (3P, N) part-major, `labels` (N,), `delta_point_rotation` (P, N, 3, 3), and the
        new `rotation` (P, 3, 3), `scale` (P,) m and `translation` (P, 3) m.

    Raises:
        StepInputError: as by `check_inputs`.
    """
    category = networks.category
    check_inputs(arrays, category.num_parts)
    points = arrays["points"].astype(np.float32)
    scale = arrays["last_scale"].astype(np.float64)
    last = Pose(
        rotation=arrays["last_rotation"].astype(np.float64),
        translation=arrays["last_translation"].astype(np.float64),
        scale=scale,
        size=np.repeat(scale[:, None] / np.sqrt(3), 3, axis=1),
    )
    points_canonical = canonicalize(points, last)
    neighborhoods = [build_neighborhoods(part, networks.profile) for part in points_canonical]
    prediction = predict(networks, points_canonical, neighborhoods)
    pose, _ = solve(points, prediction, last, category, networks.rotation_fusion)
    return {
        "seg": prediction.segmentation,
        "coords": np.swapaxes(prediction.coordinates, 1, 2).reshape(-1, len(points)),
        "labels": prediction.labels.astype(np.int8),
        "delta_point_rotation": prediction.delta_rotations.astype(np.float32),
        "rotation": pose.rotation.astype(np.float32),
        "scale": pose.scale.astype(np.float32),
        "translation": pose.translation.astype(np.float32),
    }

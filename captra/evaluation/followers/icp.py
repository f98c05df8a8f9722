"""Oracle ICP: the true surface of every part is fitted to the cloud, from where it was in the frame before."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Float32, Float64

from captra.evaluation.followers.follower import Track, follow
from captra.evaluation.sequences import Sequence
from captra.geometry import Pose, project_to_rotation
from captra.looking import Networks
from captra.observations import PointCloud
from captra.sampling import crop_ball
from captra.solving import FEWEST_POINTS

LARGEST_POINTS = 2000
"""Of a cloud; more of them tell ICP nothing new."""
ITERATIONS = 30
REACH_SHARE = 0.25
"""Points pair up within that share of the part's diagonal."""


@dataclass(frozen=True)
class OracleIcp:
    """Knows the true model and size, and starts from the true pose.

    As in the paper it is told which points of an articulated object belong to which part, while a rigid object is
    cropped from its surroundings by the last pose, as for the networks; `told_points` tells it those too.
    """

    label: str = "oracle ICP"
    """As tables name it."""
    told_points: bool = False
    """Whether a rigid object's points are known too."""

    def __call__(self, networks: Networks, sequence: Sequence) -> Track:
        """Follow the object without the networks."""
        recording = sequence.recording
        targets = [_target(points) for points in sequence.model]

        def step(cloud: Float32[np.ndarray, "all 3"], frame: int, last: Pose) -> Pose:
            parts = []
            for part, target in enumerate(targets):
                if self.told_points or not networks.category.background:
                    points = cloud[recording.labels[frame] == part]
                else:
                    points = crop_ball(PointCloud.of(cloud), last, part).points
                parts.append(_aligned(target, points, last.part(part)))
            rotation, translation = (
                np.concatenate([getattr(p, f) for p in parts]) for f in ("rotation", "translation")
            )
            return Pose(rotation, translation, last.scale, last.size)

        return Track(follow(sequence, recording.truth(0), step))


Target = tuple[object, object]


def _target(points_part: Float32[np.ndarray, "points 3"]) -> Target:
    import small_gicp

    cloud = small_gicp.PointCloud(points_part.astype(np.float64))
    return cloud, small_gicp.KdTree(cloud)


def _aligned(target: Target, points: Float32[np.ndarray, "points 3"], last: Pose) -> Pose:
    """Point-to-point ICP in the part's frame; a part with too few points stays where it was."""
    import small_gicp

    if len(points) < FEWEST_POINTS:
        return last
    chosen = points[:: -(-len(points) // LARGEST_POINTS)].astype(np.float64)
    found = small_gicp.align(
        target[0],
        small_gicp.PointCloud(chosen),
        target[1],
        init_T_target_source=_inverse(last.rotation[0], last.translation[0]),
        registration_type="ICP",
        max_correspondence_distance=REACH_SHARE * float(last.scale[0]),
        max_iterations=ITERATIONS,
        translation_epsilon=1e-4,
    )
    T_part_camera = np.asarray(found.T_target_source)
    if not np.isfinite(T_part_camera).all():
        return last
    rotation = project_to_rotation(T_part_camera[:3, :3].T)
    return Pose(rotation[None], (-rotation @ T_part_camera[:3, 3])[None], last.scale, last.size)


def _inverse(rotation: Float[np.ndarray, "3 3"], translation: Float[np.ndarray, " 3"]) -> Float64[np.ndarray, "4 4"]:
    """T_part_camera of a part's pose."""
    result = np.eye(4)
    result[:3, :3] = rotation.T
    result[:3, 3] = -rotation.T @ translation
    return result

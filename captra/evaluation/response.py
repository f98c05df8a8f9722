"""The response test: what one look leaves of a known rotation error, axis by axis.

Of a look alone: a track that is given a pose takes it for a hint of what cannot be seen, and keeps some of its error.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float64

from captra.data.recordings import Recording
from captra.evaluation.observability import symmetric_frames
from captra.fitting import angle_about_axis
from captra.geometry import Pose, axis_angle
from captra.looking import Networks, look
from captra.observations import PointCloud

ANGLES_DEG = (-15.0, -10.0, -5.0, 5.0, 10.0, 15.0)
AXES = "xyz"


@dataclass(frozen=True)
class Response:
    """What one look leaves of rotations about one axis of one part."""

    part: str
    """Name of the part."""
    axis: str
    """x, y or z of the part."""
    left: Float64[np.ndarray, "frames angles"]
    """Remaining over given angle; 0 is perfect, 1 is no reaction."""

    @property
    def median_left(self) -> float:
        """The median over frames of the mean over angles."""
        return float(np.median(np.mean(self.left, axis=1)))


def response(networks: Networks, recording: Recording, every: int = 6) -> list[Response]:
    """Turn the true pose of every so many frames about one axis, look once, and read off what is left.

    Symmetric objects are not turned about y, and frames that do not show an axis are left out.
    """
    hidden = symmetric_frames(recording)
    results = []
    for part, name in enumerate(recording.category.parts):
        for axis in range(3):
            about_y = AXES[axis] == "y"
            frames = [f for f in range(0, len(recording), every) if not (about_y and hidden[f])]
            if not frames or (about_y and recording.category.symmetric):
                continue
            left = [[_left(networks, recording, f, part, np.eye(3)[axis], a) for a in ANGLES_DEG] for f in frames]
            results.append(Response(name, AXES[axis], np.array(left)))
    return results


def _left(
    networks: Networks, recording: Recording, frame: int, part: int, axis: Float64[np.ndarray, "3"], angle_deg: float
) -> float:
    truth = recording.truth(frame)
    turned = truth.rotation.copy()
    turned[part] = turned[part] @ axis_angle(axis, np.radians(angle_deg))
    around = Pose(turned, truth.translation, truth.scale, truth.size)
    pose = look(networks, PointCloud.of(recording.clouds[frame]), around).pose
    remaining = angle_about_axis(truth.rotation[part].T @ pose.rotation[part], axis)
    return float(np.degrees(remaining) / angle_deg)

"""PyTorch against ONNX Runtime on the same clouds, at every profile."""

from dataclasses import dataclass

import numpy as np

from captra.fitting import mean_axis_rotation, mean_rotation
from captra.geometry import rotation_angle
from captra.looking import Networks
from captra.sampling import build_neighborhoods
from captra.solving import per_point_rotations
from export.inputs import made_up_clouds


class ParityError(ValueError):
    """An exported graph computes something else than the network it was written from."""


@dataclass(frozen=True)
class Difference:
    """How far two implementations of the same networks are apart on one cloud."""

    segmentation: float
    """Largest difference of a class probability."""
    coordinates: float
    """Largest difference of a normalized coordinate."""
    point_rotation: float
    """Largest difference of an entry of a per-point rotation matrix."""
    mean_rotation_deg: float
    """Largest angle between the parts' mean rotations."""

    def within(self, tolerance: "Difference") -> bool:
        """Whether nothing differs by more."""
        return all(getattr(self, name) <= getattr(tolerance, name) for name in vars(self))


TOLERANCES = {
    "float32": Difference(segmentation=1e-4, coordinates=1e-4, point_rotation=1e-2, mean_rotation_deg=0.05),
    "float16": Difference(segmentation=0.05, coordinates=0.02, point_rotation=2.0, mean_rotation_deg=1.0),
    "int8": Difference(segmentation=0.1, coordinates=0.05, point_rotation=2.0, mean_rotation_deg=3.0),
    "int6": Difference(segmentation=0.8, coordinates=0.15, point_rotation=2.0, mean_rotation_deg=5.0),
    "int5": Difference(segmentation=0.9, coordinates=0.3, point_rotation=2.0, mean_rotation_deg=8.0),
    "int4": Difference(segmentation=1.0, coordinates=0.5, point_rotation=2.0, mean_rotation_deg=12.0),
    "int3": Difference(segmentation=1.0, coordinates=0.7, point_rotation=2.0, mean_rotation_deg=20.0),
}
"""By precision of the weights. Single points whose raw rotation is nearly degenerate amplify rounding, and with few
bits single points at the edge of a part change sides."""


def compare(one: Networks, other: Networks, seed: int = 0) -> Difference:
    """Run both on the same made-up cloud; both need the same category and profile."""
    category, profile = one.category, one.profile
    clouds = made_up_clouds(category.num_parts, profile, seed)
    neighborhoods = [build_neighborhoods(cloud, profile) for cloud in clouds]
    root = category.root
    answers = [networks.coordinates(clouds[root], neighborhoods[root]) for networks in (one, other)]
    rotations = [per_point_rotations(n.rotations(clouds, neighborhoods), category) for n in (one, other)]
    mean = mean_axis_rotation if category.symmetric else mean_rotation
    angles = [rotation_angle(mean(a).T @ mean(b)) for a, b in zip(*rotations, strict=True)]
    return Difference(
        segmentation=float(np.abs(answers[0][0] - answers[1][0]).max()),
        coordinates=float(np.abs(answers[0][1] - answers[1][1]).max()),
        point_rotation=float(np.abs(rotations[0] - rotations[1]).max()),
        mean_rotation_deg=float(np.degrees(np.max(angles))),
    )


def require_parity(one: Networks, other: Networks, precision: str) -> Difference:
    """Compare, and complain when the difference exceeds what the precision of the weights explains.

    Raises:
        ParityError: it does.
    """
    difference = compare(one, other)
    if not difference.within(TOLERANCES[precision]):
        raise ParityError(
            f"ONNX Runtime and PyTorch disagree at profile {one.profile.name}: {difference}, allowed is "
            f"{TOLERANCES[precision]}; check the weights, and try --precision float32"
        )
    return difference

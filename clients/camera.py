"""The depth camera that a session's images come from."""

from dataclasses import asdict, dataclass
from typing import Any, Self

import numpy as np
from jaxtyping import Float

from captra.depth_images import Intrinsics


@dataclass(frozen=True)
class Camera:
    """A pinhole without distortion, which depth cameras' images are, or become by rectification (ROS: image_proc).

    A point (x, y, z) in the optical frame (x right, y down, z forward) is seen at u = fx·x/z + cx, v = fy·y/z + cy.
    """

    fx: float
    """Focal length in columns, pixels."""
    fy: float
    """Focal length in rows, pixels."""
    cx: float
    """Column of the principal point, pixels; 0 is the middle of the first one."""
    cy: float
    """Row of the principal point, pixels."""
    width: int
    """Columns of every image."""
    height: int
    """Rows of every image."""
    metres_per_unit: float = 0.001
    """What one unit of a 16-bit pixel is worth, metres: a millimetre, unless the device says otherwise."""

    @classmethod
    def from_matrix(cls, K: Float[np.ndarray, "3 3"], width: int, height: int, metres_per_unit: float = 0.001) -> Self:
        """From the matrix of intrinsics [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], as CameraInfo's `k` reshaped to (3, 3).

        Raises:
            ValueError: it is no such matrix; one that is transposed is told.
        """
        matrix = np.asarray(K, np.float64)
        if matrix.shape != (3, 3) or not np.allclose(matrix[[0, 1, 2, 2, 2], [1, 0, 0, 1, 2]], [0, 0, 0, 0, 1]):
            raise ValueError(
                f"a matrix of intrinsics is [[fx, 0, cx], [0, fy, cy], [0, 0, 1]], not {matrix.tolist()}: "
                "is it transposed, or of another shape?"
            )
        (fx, _, cx), (_, fy, cy), _ = matrix.tolist()
        return cls(fx, fy, cx, cy, width, height, metres_per_unit)

    @property
    def intrinsics(self) -> Intrinsics:
        """What depth becomes points with."""
        return Intrinsics(self.fx, self.fy, self.cx, self.cy)

    def body(self) -> dict[str, Any]:
        """As `POST /v1/sessions` takes it."""
        return asdict(self)

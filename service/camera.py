"""The depth camera of a session."""

from dataclasses import dataclass

from captra.depth_images import Intrinsics


@dataclass(frozen=True)
class Camera:
    """What turns depth images into points."""

    intrinsics: Intrinsics
    """Pinhole model, pixels."""
    metres_per_unit: float
    """What one unit of a 16-bit pixel is worth."""
    width: int | None
    """Columns of every image; none where images tell it themselves."""
    height: int | None
    """Rows of every image."""

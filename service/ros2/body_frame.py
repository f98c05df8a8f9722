"""Part poses as REP 103 wants bodies: z up, x forward, y left.

Boxes of the wire contract have y up and x forward (NOCS). Turning the axes by −90° about x gives those of REP 103: the
new y is the old −z, the new z the old y. The place of the box does not change, its extents change places.
"""

from math import copysign, sqrt

HALF = sqrt(0.5)
"""Sine and cosine of half of 90°."""


def body_quat_xyzw(quat_xyzw: tuple[float, ...]) -> tuple[float, ...]:
    """Rotation of the REP 103 axes, from that of the part's own; both into the frame of the cloud, with w ≥ 0."""
    x, y, z, w = quat_xyzw
    w_body = HALF * (w + x)
    scale = copysign(HALF, w_body)  # the product of the quaternion with (−½√2, 0, 0, ½√2), either sign of which will do
    return (scale * (x - w), scale * (y - z), scale * (z + y), abs(w_body))


def body_size(size: tuple[float, ...]) -> tuple[float, ...]:
    """Extents along the REP 103 axes, from those along the part's own, metres."""
    length, height, width = size
    return (length, width, height)

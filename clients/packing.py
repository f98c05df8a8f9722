"""From what a camera sees to what goes over the wire."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from jaxtyping import Float

from clients.camera import Camera
from clients.clouds import Cloud, CloudEncoding
from clients.depth import DepthImage, DepthPng
from clients.point_cloud2 import PointCloud2
from clients.regions import Region

Observation = Float[np.ndarray, "*shape 3"] | DepthImage | DepthPng | PointCloud2
"""What can be sent: points (N, 3) or (rows, columns, 3) in metres, an image, or a message of ROS 2."""


class Frame(NamedTuple):
    """What was seen, with the time at which it was, and where the object is in it."""

    observation: Observation
    """In the camera's frame."""
    stamp_ns: int | None = None
    """Capture time in nanoseconds, on whatever clock the results shall be matched with; by default the present."""
    mask: Region | None = None
    """A `Mask` or `Box`, in sessions that were opened with `masks`; without one CoordinateNet decides."""


@dataclass(frozen=True, eq=False)
class Packed:
    """One frame as it goes over the wire."""

    media_type: str
    """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
    payload: bytes
    """Cloud, image or message."""
    region: bytes
    """Mask (PNG) or box (8 bytes), which follows number and stamp in the attachment; empty where there is none."""
    shown: Callable[[], np.ndarray | bytes]
    """What viewers are shown: points (N, 3), metres, or the message as it is."""


@dataclass(frozen=True)
class Packer:
    """Packs the frames of one session, and refuses what the service could not read."""

    encoding: CloudEncoding
    """Of points."""
    camera: Camera | None
    """That the session was opened with."""
    masks: str | None
    """What the session was opened with: `object`, `parts`, or nothing."""

    def pack(self, observation: Observation, mask: Region | None) -> Packed:
        """One frame.

        Raises:
            ValueError: it cannot be sent in this session; the message says what to change.
        """
        sent = (
            observation
            if isinstance(observation, DepthImage | DepthPng | PointCloud2)
            else Cloud(np.asarray(observation), self.encoding)
        )
        return Packed(
            sent.media_type,
            sent.payload(self.camera),
            b"" if mask is None else self._region(sent, mask),
            lambda: sent.shown(self.camera),
        )

    def _region(self, sent: Cloud | DepthImage | DepthPng | PointCloud2, mask: Region) -> bytes:
        if self.masks is None:
            raise ValueError(
                "this session takes no masks: open it with masks='object' (zero is background) or masks='parts' "
                "(k is part k of the category)"
            )
        return sent.region(mask)

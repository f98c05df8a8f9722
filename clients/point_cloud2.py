"""Clouds as ROS 2 has them, sent as they are."""

from dataclasses import dataclass

from clients.camera import Camera
from clients.regions import Box, Region


@dataclass(frozen=True, eq=False)
class PointCloud2:
    """A `sensor_msgs/msg/PointCloud2` in CDR; stamp and frame of its results are those of its header."""

    cdr: bytes
    """The message as it is on the wire or in a bag; in a node, `rclpy.serialization.serialize_message(message)`."""

    @property
    def media_type(self) -> str:
        """Zenoh's `Encoding`, and `Content-Type` over HTTP."""
        return "application/cdr"

    def payload(self, camera: Camera | None) -> bytes:  # noqa: ARG002 - points need none
        """The message."""
        return self.cdr

    def region(self, region: Region) -> bytes:
        """A mask or box as it travels with this cloud; the service checks whether its size is that of the cloud."""
        return region.to_bytes() if isinstance(region, Box) else region.to_png()

    def shown(self, camera: Camera | None) -> bytes:  # noqa: ARG002 - points need none
        """The message: viewers know it."""
        return self.cdr

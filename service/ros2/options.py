"""What ROS 2 sees of one session."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Ros2Options:
    """Names of one session in ROS 2."""

    name: str
    """Begins its topics and its child frames: letters, digits and single `_`, no digit first."""
    points_topic: str | None
    """Topic of PointCloud2 messages that it tracks; none where clouds come in other ways alone."""

    @property
    def detections_topic(self) -> str:
        """Where boxes are published."""
        return f"/captra/{self.name}/detections"

    @property
    def joints_topic(self) -> str:
        """Where joint values are published."""
        return f"/captra/{self.name}/joint_states"

    def frame_of(self, part: str) -> str:
        """Name of the child frame of a part."""
        return f"{self.name}/{part}"


def default_name(category: str, session_id: str) -> str:
    """The name of a session that was given none."""
    return f"{category}_{session_id}"

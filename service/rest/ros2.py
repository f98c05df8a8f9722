"""From what a client wants ROS 2 to see of a session to its names there."""

from collections.abc import Callable

from service.rejections import UnsupportedOptionError
from service.rest.inputs import NewSession
from service.ros2.options import Ros2Options, default_name
from service.security.wiring import clouds_need_secrets
from service.settings import Settings


def ros2_names(body: NewSession, settings: Settings) -> Callable[[str], Ros2Options | None]:
    """The session's names in ROS 2, given its id; none where the service is no node.

    Raises:
        UnsupportedOptionError: the service is no node of ROS 2, or clouds need secrets, which ROS 2 cannot send.
    """
    if not settings.ros2:
        if body.ros2 is not None:
            raise UnsupportedOptionError(
                "this service is no node of ROS 2: start it with captra serve --ros2 or CAPTRA_ROS2=true"
            )
        return lambda session_id: None  # noqa: ARG005 - of one signature
    asked, topic = body.ros2, settings.ros2_points_topic
    if asked is not None and asked.points_topic is not None:
        topic = asked.points_topic
    if topic is not None and clouds_need_secrets(settings):
        raise UnsupportedOptionError(
            f"clouds need the secret of their session here, which whoever publishes {topic} does not know: put clouds "
            "as captra's clients do, or let everybody who reaches the router put them, with CAPTRA_CLOUD_SECRETS=false"
        )
    name = None if asked is None else asked.name
    return lambda session_id: Ros2Options(name or default_name(body.category, session_id), topic)

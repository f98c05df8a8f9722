"""From what a client wants ROS 2 to see of a session to its names there."""

from collections.abc import Callable, Iterable

from service.rejections import InvalidRequestError, Mistake, UnsupportedOptionError
from service.rest.inputs import NewSession
from service.ros2.options import Ros2Options, default_name
from service.security.wiring import clouds_need_secrets
from service.session import Session
from service.settings import Settings


def check_name_free(body: NewSession, sessions: Iterable[Session]) -> None:
    """Refuse a name that an open session has: both would publish to the same topics and frames.

    Raises:
        InvalidRequestError: one has it.
    """
    name = None if body.ros2 is None else body.ros2.name
    for session in sessions:
        if name is not None and session.record.ros2 is not None and session.record.ros2.name == name:
            raise InvalidRequestError(
                Mistake(
                    "/body/ros2/name",
                    f"session {session.session_id} is called {name!r} already: choose another name, or DELETE it",
                )
            )


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

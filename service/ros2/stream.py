"""One session in ROS 2: its results go out as topics, and a topic of clouds comes in where it has one."""

import logging
from collections.abc import Callable
from contextlib import ExitStack

import zenoh

from captra.observations import Observation
from service.envelopes import NumberedHeader
from service.results import Event, Result
from service.ros2 import outputs
from service.ros2.messages import DETECTIONS, JOINT_STATE, POINT_CLOUD2
from service.ros2.names import Domain, Topic
from service.ros2.options import Ros2Options
from service.ros2.publisher import TopicPublisher
from service.ros2.subscription import PointsSubscription
from service.session import Session

logger = logging.getLogger(__name__)


class Ros2Stream:
    """Observes a session for ROS 2 and feeds it from its topic."""

    def __init__(
        self,
        zenoh_session: zenoh.Session,
        domain: Domain,
        node: str,
        next_entity: Callable[[], int],
        tf: TopicPublisher,
        session: Session,
        options: Ros2Options,
    ) -> None:
        self._options = options
        self._tf = tf
        self._subscriptions: tuple[PointsSubscription, ...] = ()
        with ExitStack() as resources:

            def publisher(topic: Topic) -> TopicPublisher:
                made = TopicPublisher(zenoh_session, domain, node, next_entity(), topic)
                resources.callback(made.close)
                return made

            self._detections = publisher(Topic(options.detections_topic, DETECTIONS))
            self._joints = tuple(
                publisher(Topic(options.joints_topic, JOINT_STATE)) for _ in session.category.joints[:1]
            )
            session.observe(self)
            resources.callback(session.unobserve, self)
            if options.points_topic is not None:
                topic = Topic(options.points_topic, POINT_CLOUD2)
                subscription = PointsSubscription(zenoh_session, domain, node, next_entity(), topic, session)
                resources.callback(subscription.close)
                self._subscriptions = (subscription,)
            self._resources = resources.pop_all()

    def announce(self) -> None:
        """ROS 2 sees the topics as they are made."""

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """ROS 2 knows its clouds."""

    def result(self, result: Result) -> None:
        """Publish it; a network that is gone must not undo the frame."""
        if not outputs.has_ros_stamp(result):
            logger.debug("no stamp of ROS", extra={"session_id": result.session_id, "stamp_ns": result.stamp_ns})
            return
        try:
            self._detections.put(outputs.detections(result, self._options))
            if outputs.known(result):
                self._tf.put(outputs.transforms(result, self._options))
                for joints in self._joints:
                    joints.put(outputs.joint_states(result))
        except zenoh.ZError:
            logger.exception("could not publish to ROS 2", extra={"session_id": result.session_id})

    def event(self, event: Event) -> None:
        """ROS 2 has no message for it."""

    def stop_receiving(self) -> None:
        """Take no more clouds."""
        for subscription in self._subscriptions:
            subscription.stop_receiving()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the one in hand; whether it was done within `timeout_s`, if that is given."""
        return all(subscription.finish(timeout_s) for subscription in self._subscriptions)

    def close(self) -> None:
        """Withdraw the topics."""
        self._resources.close()

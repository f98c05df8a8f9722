"""PointCloud2 topics on their way in: as rmw_zenoh and as zenoh-bridge-ros2dds put them."""

import logging

import zenoh

from service.codecs import CDR
from service.envelopes import Envelope, pack_attachment
from service.feeds import Feed, arrival_s
from service.rejections import MalformedAttachmentError, RejectedError, UnknownSessionError
from service.ros2.attachments import RmwAttachment
from service.ros2.names import Domain, Topic
from service.session import Session

logger = logging.getLogger(__name__)


class TopicNumbers:
    """Numbers a topic's clouds on from the session's last processed frame, so that gaps in the publisher's count show.

    A publisher that starts again counts from one under another id, which must not make its clouds look old.
    """

    def __init__(self) -> None:
        self._last: RmwAttachment | None = None

    def number(self, attachment: RmwAttachment, last_seq: int | None) -> int | None:
        """Number of a cloud, given that of the last frame processed; none where the session shall number it."""
        last = self._last
        if last is None or last_seq is None or last.gid != attachment.gid:
            return None
        return last_seq + max(0, attachment.seq - last.seq)

    def processed(self, attachment: RmwAttachment) -> None:
        """The cloud with this attachment was the last one processed."""
        self._last = attachment


class PointsSubscription:
    """Feeds a session from a topic; who may put on it is up to the router."""

    def __init__(
        self, zenoh_session: zenoh.Session, domain: Domain, node: str, entity: int, topic: Topic, session: Session
    ) -> None:
        self._session = session
        self._numbers = TopicNumbers()
        self._router_id = str(zenoh_session.zid())
        name = f"captra-ros2-{session.session_id}"
        self._token = zenoh_session.liveliness().declare_token(
            domain.topic_token(self._router_id, node, entity, "MS", topic)
        )
        self._feeds = (
            Feed(zenoh_session, domain.subscriber_key(topic), self._take_rmw, name),
            Feed(zenoh_session, topic.bridge_key, self._take_bridged, name),
        )

    def stop_receiving(self) -> None:
        """Take no more clouds."""
        for feed in self._feeds:
            feed.stop()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the one in hand; whether it was done within `timeout_s`, if that is given."""
        return all(feed.finish(timeout_s) for feed in self._feeds)

    def close(self) -> None:
        """Withdraw the subscription."""
        self._token.undeclare()

    def _take_rmw(self, sample: zenoh.Sample) -> None:
        attachment = b"" if sample.attachment is None else sample.attachment.to_bytes()
        try:
            sent = RmwAttachment.unpack(attachment)
        except MalformedAttachmentError as rejection:
            self._session.refuse(rejection)
            return
        if self._track(sample, self._numbers.number(sent, self._session.last_seq)):
            self._numbers.processed(sent)

    def _take_bridged(self, sample: zenoh.Sample) -> None:
        self._track(sample, None)

    def _track(self, sample: zenoh.Sample, seq: int | None) -> bool:
        """Whether the cloud was processed."""
        try:
            self._session.codecs.check_size(len(sample.payload))
        except RejectedError as rejection:
            self._session.refuse(rejection)
            return False
        attachment = None if seq is None else pack_attachment(seq, 0)  # the stamp is the message's
        envelope = Envelope(CDR, sample.payload.to_bytes(), attachment, arrival_s(sample, self._router_id))
        try:
            self._session.process(envelope)
        except UnknownSessionError:
            logger.debug("cloud for a closed session", extra={"session_id": self._session.session_id})
            return False
        except RejectedError:
            return False  # counted, and told as an event
        return True

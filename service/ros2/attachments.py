"""What rmw_zenoh sends along with every message."""

import struct
from dataclasses import dataclass

from service.envelopes import ATTACHMENT
from service.rejections import MalformedAttachmentError, MissingAttachmentError

GID_BYTES = 16
RMW = struct.Struct(f"<qqB{GID_BYTES}s")
"""Sequence number, source time in nanoseconds, and the publisher's id behind its length."""


@dataclass(frozen=True)
class RmwAttachment:
    """Who published a message, and when."""

    seq: int
    """Number of the message, rising by one for one publisher."""
    source_ns: int
    """When it was published."""
    gid: bytes
    """Id of the publisher, 16 bytes."""

    def pack(self) -> bytes:
        """The 33 bytes."""
        return RMW.pack(self.seq, self.source_ns, GID_BYTES, self.gid)

    @staticmethod
    def unpack(attachment: bytes) -> "RmwAttachment":
        """From the 33 bytes.

        Raises:
            MalformedAttachmentError: they are not of this form.
        """
        if len(attachment) != RMW.size or attachment[16] != GID_BYTES:
            raise MalformedAttachmentError(
                f"the attachment has {len(attachment)} bytes: rmw_zenoh sends {RMW.size}, captra's clients "
                f"{ATTACHMENT.size}; a message without one is numbered by the service"
            )
        seq, source_ns, _, gid = RMW.unpack(attachment)
        return RmwAttachment(seq, source_ns, gid)


def seq_of(attachment: bytes | None) -> int | None:
    """Number of a message: from our attachment, from that of rmw_zenoh, or none where there is no attachment.

    Raises:
        MalformedAttachmentError: the attachment has neither form.
        MissingAttachmentError: it is empty.
    """
    if attachment is None:
        return None
    if not attachment:
        raise MissingAttachmentError(
            f"the attachment is empty: rmw_zenoh sends {RMW.size} bytes, captra's clients {ATTACHMENT.size}"
        )
    if len(attachment) == ATTACHMENT.size:
        seq: int = ATTACHMENT.unpack(attachment)[0]
        return seq
    return RmwAttachment.unpack(attachment).seq

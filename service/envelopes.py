"""One frame as it comes off the wire, before its points are read."""

import struct
from dataclasses import dataclass

from service.rejections import MalformedAttachmentError, MissingAttachmentError

ATTACHMENT = struct.Struct("<Qq")
"""Attachment of a cloud: `seq` (uint64) and `stamp_ns` (int64), little-endian."""


@dataclass(frozen=True)
class FrameHeader:
    """What came with a cloud."""

    seq: int | None
    """Number of the frame, rising; none where the session shall number it."""
    stamp_ns: int
    """When the sensor saw it, on the client's clock."""
    frame_id: str | None = None
    """Frame of the coordinates where the message names one; otherwise the session's."""


@dataclass(frozen=True)
class NumberedHeader(FrameHeader):
    """The header of a frame that has its place among the others."""

    seq: int
    """Number of the frame, rising."""


@dataclass(frozen=True)
class Envelope:
    """One cloud as it came off the wire."""

    encoding: str
    """Media type, perhaps with parameters."""
    payload: bytes
    """The cloud."""
    attachment: bytes | None
    """What travelled beside it."""
    arrived_s: float
    """When it reached the service, on the clock of `time.perf_counter`."""
    looks: int | None = None
    """How many looks it may take, where it repeats a frame that took so many; none leaves it to the track."""


def pack_attachment(seq: int, stamp_ns: int) -> bytes:
    """The sixteen bytes that accompany a cloud."""
    return ATTACHMENT.pack(seq, stamp_ns)


def unpack_attachment(attachment: bytes | None) -> FrameHeader:
    """Sequence number and stamp of a cloud.

    Raises:
        MissingAttachmentError: there is none.
        MalformedAttachmentError: it does not have sixteen bytes.
    """
    if attachment is None:
        raise MissingAttachmentError("a cloud needs an attachment of 16 bytes: seq (uint64 LE) and stamp_ns (int64 LE)")
    if len(attachment) != ATTACHMENT.size:
        raise MalformedAttachmentError(
            f"the attachment has {len(attachment)} bytes, not 16: seq (uint64 LE) and stamp_ns (int64 LE)"
        )
    return FrameHeader(*ATTACHMENT.unpack(attachment))

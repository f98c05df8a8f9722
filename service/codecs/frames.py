"""What a codec makes of a message."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from captra.observations import Observation
from service.envelopes import Envelope, FrameHeader


@dataclass(frozen=True)
class Frame:
    """A message whose header has been read."""

    header: FrameHeader
    """Number, stamp and frame."""
    observe: Callable[[], Observation]
    """Reads the rest; raises a FrameRejectedError where it is malformed."""


class FrameCodec(Protocol):
    """Reads messages of one encoding."""

    @property
    def encoding(self) -> str:
        """Media type, lower case, without parameters."""

    def open(self, envelope: Envelope) -> Frame:
        """Read the header; raises a FrameRejectedError where it is missing or malformed."""

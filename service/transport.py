"""How sessions are reached other than by HTTP."""

from collections.abc import Callable
from contextlib import ExitStack
from typing import Protocol

from service.envelopes import Envelope
from service.keys import SessionKeys
from service.session import Session


class Stream(Protocol):
    """One session's connection."""

    def announce(self) -> None:
        """Tell whoever listens for sessions that this one is there; not before it can be found by its id."""

    def stop_receiving(self) -> None:
        """Take no more clouds; more than once does no harm."""

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the one in hand; whether it was done within `timeout_s`, if that is given."""

    def close(self) -> None:
        """Withdraw what was declared; nothing can be told afterwards."""


class Streams:
    """Several connections of one session."""

    def __init__(self, streams: tuple[Stream, ...]) -> None:
        self._streams = streams

    def announce(self) -> None:
        """Tell of the session on all of them."""
        for stream in self._streams:
            stream.announce()

    def stop_receiving(self) -> None:
        """Take no more clouds on any of them."""
        for stream in self._streams:
            stream.stop_receiving()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for those in hand; whether all were done within `timeout_s` each, if that is given."""
        return all(stream.finish(timeout_s) for stream in self._streams)

    def close(self) -> None:
        """Withdraw all, the last one first."""
        for stream in reversed(self._streams):
            stream.close()


class Transport(Protocol):
    """Connects sessions with their clients."""

    @property
    def endpoints(self) -> tuple[str, ...]:
        """Where clients connect to."""

    def open(self) -> None:
        """Start listening; raises TransportError when that is impossible."""

    def keys(self, session_id: str) -> SessionKeys:
        """Where a session is reached."""

    def attach(self, session: Session) -> Stream:
        """Connect a session, without telling others of it yet."""

    def subscribe_previews(self, take: Callable[[str, Envelope], None]) -> ExitStack:
        """Call `take` with the name and the cloud of whatever comes on preview keys, until the stack is closed.

        `take` may close it.
        """

    def put(self, key: str, envelope: Envelope) -> None:
        """Put a cloud, as a client would."""

    def close(self) -> None:
        """Stop listening, after all streams are closed."""


class TransportError(RuntimeError):
    """The transport cannot listen; says what to do."""

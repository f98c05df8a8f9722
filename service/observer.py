"""Who hears of a session: its Zenoh stream today, recorders and viewers as well later."""

from typing import Protocol

from service.results import Event, Result


class Observer(Protocol):
    """Hears what happens to a session, in order; called while the session is locked, so its methods return quickly."""

    def result(self, result: Result) -> None:
        """A frame was processed."""

    def event(self, event: Event) -> None:
        """Something else happened."""


class NullObserver:
    """Nobody listens."""

    def result(self, result: Result) -> None:
        """Nothing to do."""

    def event(self, event: Event) -> None:
        """Nothing to do."""

"""Who hears of a session: its Zenoh stream always, recorders and viewers while there are any."""

from typing import Protocol

from captra.observations import Observation
from service.envelopes import NumberedHeader
from service.results import Event, Result


class Observer(Protocol):
    """Hears what happens to a session, in order; called while the session is locked, so its methods return quickly."""

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """What a sensor saw is about to be tracked; a result, or an event that it was rejected, follows.

        It is shared: it may be kept, and is never written to.
        """

    def result(self, result: Result) -> None:
        """A frame was processed."""

    def event(self, event: Event) -> None:
        """Something else happened."""


class Observers:
    """Any number of observers, told one after the other; they may come and go at any time."""

    def __init__(self) -> None:
        self._all: tuple[Observer, ...] = ()

    def add(self, observer: Observer) -> None:
        """Tell one more from now on."""
        self._all = (*self._all, observer)

    def remove(self, observer: Observer) -> None:
        """Tell it no more; nothing happens to one that is not told."""
        self._all = tuple(each for each in self._all if each is not observer)

    def cloud(self, header: NumberedHeader, observation: Observation) -> None:
        """Tell all of a cloud."""
        for observer in self._all:
            observer.cloud(header, observation)

    def result(self, result: Result) -> None:
        """Tell all of a result."""
        for observer in self._all:
            observer.result(result)

    def event(self, event: Event) -> None:
        """Tell all of an event."""
        for observer in self._all:
            observer.event(event)

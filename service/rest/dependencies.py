"""What routes share: the service, its worker threads, a session by its id."""

from collections.abc import Callable, Iterator
from contextlib import AbstractAsyncContextManager, contextmanager, nullcontext
from typing import Annotated, TypeVar
from weakref import WeakKeyDictionary

import anyio
from fastapi import Depends, Path, Request

from service.rejections import TooManyFramesError
from service.session import Session
from service.tracking_service import TrackingService

Answer = TypeVar("Answer")

MOST_FRAMES = 64
"""Frames of one session that may be in hand or wait by HTTP."""
MOST_BYTES = 512 * 2**20
"""What the bodies of all frames that are in hand or wait by HTTP may take of the memory, of all sessions together."""


def get_service(request: Request) -> TrackingService:
    """The service that an application serves."""
    service: TrackingService = request.app.state.service
    return service


Service = Annotated[TrackingService, Depends(get_service)]
SessionId = Annotated[str, Path(description="As `POST /v1/sessions` answered.", max_length=100)]


class Held:
    """Memory that one frame takes while it arrives and waits."""

    def __init__(self, reserve: Callable[[int], None]) -> None:
        self._reserve = reserve
        self._bytes = 0

    def grow_to(self, size_bytes: int) -> None:
        """Take so much in all.

        Raises:
            TooManyFramesError: there is not so much left.
        """
        self._reserve(size_bytes - self._bytes)
        self._bytes = size_bytes


class Workers:
    """Threads for work that takes more than a moment, so that the event loop stays free."""

    def __init__(self, threads: int = 16) -> None:
        self._limiter = anyio.CapacityLimiter(threads)
        self._turns: WeakKeyDictionary[Session, anyio.Lock] = WeakKeyDictionary()
        self._places: WeakKeyDictionary[Session, anyio.Semaphore] = WeakKeyDictionary()
        self._naming = anyio.Lock()
        self._held_bytes = 0

    @contextmanager
    def place(self, session: Session) -> Iterator[Held]:
        """A place among the frames of one session, whose bodies take memory while they wait.

        Raises:
            TooManyFramesError: all are taken.
        """
        places = self._places.setdefault(session, anyio.Semaphore(MOST_FRAMES))
        try:
            places.acquire_nowait()
        except anyio.WouldBlock:
            raise TooManyFramesError(
                f"{MOST_FRAMES} frames of session {session.session_id} wait already, which is the limit: "
                "wait for their results before you send more"
            ) from None
        held = Held(self._reserve)
        try:
            yield held
        finally:
            held.grow_to(0)
            places.release()

    def _reserve(self, more_bytes: int) -> None:
        if more_bytes > 0 and self._held_bytes + more_bytes > MOST_BYTES:
            raise TooManyFramesError(
                f"frames of all sessions that wait take the {MOST_BYTES} bytes that they may: "
                "wait for their results before you send more"
            )
        self._held_bytes += more_bytes

    def turn(self, session: Session) -> anyio.Lock:
        """What work on one session takes turns by: whoever waits for it takes no thread from others meanwhile."""
        return self._turns.setdefault(session, anyio.Lock())

    def naming(self, *, named: bool) -> AbstractAsyncContextManager[None]:
        """What sessions with names of their own are opened in, one at a time, so that no two get the same."""
        return self._naming if named else nullcontext()

    async def run_in_turn(self, session: Session, work: Callable[[], Answer]) -> Answer:
        """The answer of work on one session."""
        async with self.turn(session):
            return await self.run(work)

    async def run(self, work: Callable[[], Answer]) -> Answer:
        """The answer of `work`, done on a thread."""
        return await anyio.to_thread.run_sync(work, limiter=self._limiter)


def get_workers(request: Request) -> Workers:
    """The threads of an application."""
    workers: Workers = request.app.state.workers
    return workers


async def get_session(service: Service, session_id: SessionId) -> Session:
    """An open session; raises UnknownSessionError."""
    return service.registry.get(session_id)


OnThread = Annotated[Workers, Depends(get_workers)]
OpenSession = Annotated[Session, Depends(get_session)]

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


def get_service(request: Request) -> TrackingService:
    """The service that an application serves."""
    service: TrackingService = request.app.state.service
    return service


Service = Annotated[TrackingService, Depends(get_service)]
SessionId = Annotated[str, Path(description="As `POST /v1/sessions` answered.", max_length=100)]


class Workers:
    """Threads for work that takes more than a moment, so that the event loop stays free."""

    def __init__(self, threads: int = 16) -> None:
        self._limiter = anyio.CapacityLimiter(threads)
        self._turns: WeakKeyDictionary[Session, anyio.Lock] = WeakKeyDictionary()
        self._places: WeakKeyDictionary[Session, anyio.Semaphore] = WeakKeyDictionary()
        self._naming = anyio.Lock()

    @contextmanager
    def place(self, session: Session) -> Iterator[None]:
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
        try:
            yield
        finally:
            places.release()

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

"""One websocket a viewer: it says what it looks at, and is shown that, at a rate that never holds tracking up."""

import time
from typing import Annotated, Literal
from urllib.parse import urlsplit

import anyio
import orjson
from fastapi import APIRouter, WebSocket
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from starlette.websockets import WebSocketDisconnect

from service.codecs import build_codecs
from service.rejections import ForbiddenError, RejectedError
from service.rest.problems import remark
from service.security.access import Caller, Permission
from service.tracking_service import TrackingService
from service.viewer.clouds import encode
from service.viewer.outbox import Outbox
from service.viewer.previews import Previews
from service.viewer.summaries import overview
from service.viewer.watching import NothingWatched, PreviewWatch, SessionWatch, Watch

CLOUD_INTERVAL_S = 0.1
"""Ten clouds a second and viewer; results all go out."""
OVERVIEW_INTERVAL_S = 0.5
FOREIGN = 4403
"""Close code: a page of another host asks."""

router = APIRouter()
Name = Annotated[str, Field(max_length=100)]


class Look(BaseModel):
    """Look at a session, at a preview, or at nothing."""

    model_config = ConfigDict(extra="forbid")

    type: Literal["watch"]
    session: Name | None = None
    preview: Name | None = None


class Feed(BaseModel):
    """Let a preview's clouds be tracked by a session, whose secret whoever opened it knows."""

    model_config = ConfigDict(extra="forbid")

    type: Literal["feed"]
    session: Name
    preview: Name
    secret: Annotated[str, Field(pattern=r"^([0-9a-f]{2})*$", max_length=100)] | None = None


WISHES: TypeAdapter[Look | Feed] = TypeAdapter(Annotated[Look | Feed, Field(discriminator="type")])


@router.websocket("/viewer/stream")
async def stream(websocket: WebSocket) -> None:
    """Serve one viewer until it leaves."""
    await websocket.accept()
    if not is_same_host(websocket):
        await websocket.close(FOREIGN, "open the page that this service serves itself")
        return
    service: TrackingService = websocket.app.state.service
    viewer = Viewer(websocket, service, websocket.app.state.previews)
    try:
        # That of asyncio would not wait for a thread with a wish in hand, which then began to watch after the end.
        async with anyio.create_task_group() as tasks:
            tasks.start_soon(viewer.listen)
            tasks.start_soon(viewer.show)
    except* (WebSocketDisconnect, RuntimeError):  # whichever of the two notices first that it left
        pass
    finally:
        await anyio.to_thread.run_sync(viewer.leave)


def is_same_host(websocket: WebSocket) -> bool:
    """Whether the page that asks came from this service; what is no browser names no origin."""
    origin = websocket.headers.get("origin")
    return origin is None or urlsplit(origin).netloc == websocket.headers.get("host")


class Viewer:
    """One open page."""

    def __init__(self, websocket: WebSocket, service: TrackingService, previews: Previews) -> None:
        self._websocket = websocket
        self._service = service
        self._previews = previews
        self._outbox = Outbox()
        self._watch: Watch = NothingWatched()
        self._cloud_due_s = 0.0
        self._overview_due_s = 0.0
        previews.open()

    def leave(self) -> None:
        """Look away."""
        self._watch.end()
        self._previews.close()

    async def listen(self) -> None:
        """Do what the page asks for, until it leaves."""
        while True:
            try:
                wish = WISHES.validate_json(await self._received())
                await anyio.to_thread.run_sync(self._heed, wish)
            except RejectedError as error:
                self._outbox.put_message(orjson.dumps({"type": "refused", "detail": str(error)}))
            except ValidationError as error:
                where, what = error.errors()[0]["loc"], remark(error.errors()[0])
                detail = f"/{'/'.join(map(str, where))}: {what}"
                self._outbox.put_message(orjson.dumps({"type": "refused", "detail": detail}))

    async def _received(self) -> str | bytes:
        """The next message, text or not; raises WebSocketDisconnect."""
        message = await self._websocket.receive()
        if message["type"] == "websocket.disconnect":
            raise WebSocketDisconnect(message.get("code", 1005))
        text: str | None = message.get("text")
        return message["bytes"] if text is None else text

    async def show(self) -> None:
        """Send what there is, until the page leaves."""
        while True:
            now_s = time.monotonic()
            if now_s >= self._overview_due_s:
                self._overview_due_s = now_s + OVERVIEW_INTERVAL_S
                await self._send_text(overview(self._service, self._previews))
            for message in self._outbox.take_messages():
                await self._send_text(message)
            if self._outbox.has_cloud and now_s >= self._cloud_due_s:
                self._cloud_due_s = now_s + CLOUD_INTERVAL_S
                await self._send_cloud()
            due_s = min(self._overview_due_s, self._cloud_due_s) if self._outbox.has_cloud else self._overview_due_s
            await self._outbox.wait(max(0.0, due_s - time.monotonic()))

    def _heed(self, wish: Look | Feed) -> None:
        if isinstance(wish, Feed):
            self._feed(wish)
            return
        self._watch.end()
        self._watch = NothingWatched()
        self._outbox.clear_cloud()
        if wish.session is not None:
            self._watch = SessionWatch(self._service.registry.get(wish.session), self._outbox)
        elif wish.preview is not None:
            settings = self._service.settings
            codecs = build_codecs(settings.max_points, settings.max_payload_bytes)
            self._watch = PreviewWatch(wish.preview, self._previews, codecs, self._outbox)

    def _feed(self, wish: Feed) -> None:
        caller: Caller = self._websocket.state.caller
        if caller.may < Permission.WRITE:
            raise ForbiddenError(f"{caller.name} may watch only: use a key or token that may write")
        self._previews.feed(wish.preview, wish.session, bytes.fromhex(wish.secret or ""))

    async def _send_text(self, message: bytes) -> None:
        await self._websocket.send_text(message.decode())

    async def _send_cloud(self) -> None:
        make = self._outbox.take_cloud()
        if make is None:
            return

        def encoded() -> bytes | None:
            frame = make()
            return None if frame is None or len(frame.points) == 0 else encode(frame)

        message = await anyio.to_thread.run_sync(encoded)
        if message is not None:
            await self._websocket.send_bytes(message)

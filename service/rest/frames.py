"""Clouds by HTTP, for clients without Zenoh: the answer is the result."""

import time
from contextlib import ExitStack
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from captra.recovery import MOST_LOOKS
from service.codecs import CDR, CLOUD_F32, CLOUD_I16, DEPTH_F32, DEPTH_PNG, DEPTH_U16
from service.envelopes import Envelope, pack_attachment
from service.rejections import (
    CoordinatesOutOfRangeError,
    EmptyCloudError,
    InvalidRequestError,
    MalformedImageError,
    MalformedMaskError,
    MalformedMessageError,
    NoPointsNearObjectError,
    NotFiniteError,
    PayloadTooLargeError,
    RepeatedSeqError,
    SlowBodyError,
    StaleSeqError,
    TooManyFramesError,
    TooManyPointsError,
    UnknownEncodingError,
    UnknownSessionError,
    UnsupportedFieldsError,
    WrongByteCountError,
    WrongImageSizeError,
)
from service.rest.bodies import discard_body, read_body
from service.rest.dependencies import Held, OnThread, OpenSession, Workers
from service.rest.forms import MULTIPART, WITH_MASK, frame_of
from service.rest.outputs import Result
from service.rest.problems import CLIENT_LEFT, documented
from service.session import Session

router = APIRouter(prefix="/v1/sessions", tags=["frames"])

FRAME_PROBLEMS = (
    UnknownSessionError,
    TooManyFramesError,
    SlowBodyError,
    InvalidRequestError,
    UnknownEncodingError,
    EmptyCloudError,
    WrongByteCountError,
    NotFiniteError,
    CoordinatesOutOfRangeError,
    TooManyPointsError,
    PayloadTooLargeError,
    StaleSeqError,
    RepeatedSeqError,
    NoPointsNearObjectError,
    MalformedMessageError,
    UnsupportedFieldsError,
    MalformedImageError,
    WrongImageSizeError,
    MalformedMaskError,
)
ENCODINGS = (CLOUD_F32, CLOUD_I16, CDR, DEPTH_PNG, DEPTH_U16, DEPTH_F32)
BODY = {
    "description": "A cloud or a depth image in one of the encodings that the session reads.",
    "required": True,
    "content": {encoding: {"schema": {"type": "string", "format": "binary"}} for encoding in ENCODINGS}
    | {MULTIPART: {"schema": WITH_MASK}},
}

Seq = Annotated[int, Query(ge=0, lt=2**64, description="Number of the frame; each higher than the last.")]
Stamp = Annotated[
    int, Query(ge=-(2**63), lt=2**63, description="When the sensor saw it, nanoseconds; comes back as it is.")
]
BoxText = Annotated[
    str | None,
    Query(
        pattern=r"^\d{1,5}(,\d{1,5}){3}$",
        description="left,top,right,bottom: a bounding box, in sessions with `masks`.",
    ),
]

Looks = Annotated[
    int | None,
    Query(
        ge=1,
        le=MOST_LOOKS,
        description="To repeat a frame: `looks` of the result, or of the event, that it had. Leave it out otherwise.",
    ),
]


@router.post(
    "/{session_id}/frames",
    response_model=Result,
    responses=documented(*FRAME_PROBLEMS),
    openapi_extra={"requestBody": BODY},
)
async def post_frame(
    session: OpenSession,
    seq: Seq,
    stamp_ns: Stamp,
    request: Request,
    threads: OnThread,
    box: BoxText = None,
    looks: Looks = None,
) -> Response:
    """Track the object in one cloud; `Content-Type` names its encoding."""
    with ExitStack() as until_answered:
        try:
            held = until_answered.enter_context(threads.place(session))
        except TooManyFramesError:
            await discard_body(request)
            raise
        return await answer_of(session, request, threads, held, pack_attachment(seq, stamp_ns), box, looks)


async def answer_of(
    session: Session,
    request: Request,
    threads: Workers,
    held: Held,
    attachment: bytes,
    box: str | None,
    looks: int | None,
) -> Response:
    """The result of the frame in a request, when its turn has come; nothing for a client that left meanwhile."""

    def take(size_bytes: int) -> None:
        session.codecs.check_size(size_bytes)
        held.grow_to(size_bytes)

    try:
        payload = await read_body(request, take)
    except PayloadTooLargeError as rejection:
        await threads.run_in_turn(session, partial(session.refuse, rejection))
        raise
    arrived_s = time.perf_counter()
    sent = await frame_of(payload, request.headers.get("content-type", ""), box)
    envelope = Envelope(sent.encoding, sent.payload, attachment + sent.mask, arrived_s, looks)
    async with threads.turn(session):
        if await request.is_disconnected():
            return Response(status_code=CLIENT_LEFT)
        result = await threads.run(lambda: session.process(envelope))
    return Response(result.to_json(), media_type="application/json")

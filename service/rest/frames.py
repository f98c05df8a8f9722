"""Clouds by HTTP, for clients without Zenoh: the answer is the result."""

import time
from functools import partial
from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from service.codecs import CLOUD_F32, CLOUD_I16
from service.envelopes import Envelope, pack_attachment
from service.rejections import (
    CoordinatesOutOfRangeError,
    EmptyCloudError,
    InvalidRequestError,
    NoPointsNearObjectError,
    NotFiniteError,
    PayloadTooLargeError,
    RepeatedSeqError,
    StaleSeqError,
    TooManyPointsError,
    UnknownEncodingError,
    UnknownSessionError,
    WrongByteCountError,
)
from service.rest.bodies import read_body
from service.rest.dependencies import OnThread, OpenSession
from service.rest.outputs import Result
from service.rest.problems import documented

router = APIRouter(prefix="/v1/sessions", tags=["frames"])

FRAME_PROBLEMS = (
    UnknownSessionError,
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
)
BODY = {
    "description": "N×3 little-endian numbers: float32 metres, or int16 tenths of a millimetre.",
    "required": True,
    "content": {encoding: {"schema": {"type": "string", "format": "binary"}} for encoding in (CLOUD_F32, CLOUD_I16)},
}

Seq = Annotated[int, Query(ge=0, lt=2**64, description="Number of the frame; each higher than the last.")]
Stamp = Annotated[
    int, Query(ge=-(2**63), lt=2**63, description="When the sensor saw it, nanoseconds; comes back as it is.")
]


@router.post(
    "/{session_id}/frames",
    response_model=Result,
    responses=documented(*FRAME_PROBLEMS),
    openapi_extra={"requestBody": BODY},
)
async def post_frame(session: OpenSession, seq: Seq, stamp_ns: Stamp, request: Request, threads: OnThread) -> Response:
    """Track the object in one cloud; `Content-Type` names its encoding."""
    arrived_s = time.perf_counter()
    try:
        payload = await read_body(request, session.codecs.check_size)
    except PayloadTooLargeError as rejection:
        await threads.run(partial(session.refuse, rejection))
        raise
    encoding = request.headers.get("content-type", "")
    envelope = Envelope(encoding, payload, pack_attachment(seq, stamp_ns), arrived_s)
    result = await threads.run(lambda: session.process(envelope))
    return Response(result.to_json(), media_type="application/json")

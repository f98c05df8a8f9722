"""Paths of sessions: open, look, start again, close."""

from dataclasses import replace
from functools import partial
from hashlib import sha256

from fastapi import APIRouter, Request, Response

from captra import categories
from service.liveness import CloseReason
from service.registry import NewSession as Order
from service.rejections import (
    BodyTooLargeError,
    CategoryWithoutModelError,
    ImplausiblePoseError,
    InvalidRequestError,
    Mistake,
    ModelNotLoadableError,
    NotARotationError,
    NotReadyError,
    NotStoredError,
    RecordingsFullError,
    RejectedError,
    SizeNotPositiveError,
    TooManySessionsError,
    UnknownCategoryError,
    UnknownSessionError,
    UnsupportedMediaTypeError,
    UnsupportedOptionError,
    WrongNumberOfPartsError,
)
from service.rest.bodies import JsonRoute
from service.rest.cameras import camera_of
from service.rest.dependencies import OnThread, OpenSession, Service, SessionId
from service.rest.inputs import NewPose, NewSession
from service.rest.options import track_options_of
from service.rest.outputs import OpenedSession, Result, Sessions, SessionState
from service.rest.poses import pose_of
from service.rest.problems import documented
from service.rest.ros2 import check_name_free, ros2_names
from service.rest.views import opened, state_of
from service.security.secrets import new_secret
from service.security.wiring import clouds_need_secrets
from service.settings import Settings

router = APIRouter(prefix="/v1/sessions", tags=["sessions"], route_class=JsonRoute)

BODY_PROBLEMS = (InvalidRequestError, BodyTooLargeError, UnsupportedMediaTypeError)
POSE_PROBLEMS = (WrongNumberOfPartsError, NotARotationError, SizeNotPositiveError, ImplausiblePoseError)
OPENING_PROBLEMS = (
    UnknownCategoryError,
    CategoryWithoutModelError,
    ModelNotLoadableError,
    UnsupportedOptionError,
    TooManySessionsError,
    NotReadyError,
    NotStoredError,
    RecordingsFullError,
)


@router.post(
    "",
    status_code=201,
    responses={
        201: {"headers": {"Location": {"description": "Path of the session.", "schema": {"type": "string"}}}},
        **documented(*BODY_PROBLEMS, *POSE_PROBLEMS, *OPENING_PROBLEMS),
    },
)
async def open_session(
    body: NewSession, request: Request, response: Response, service: Service, threads: OnThread
) -> OpenedSession:
    """Open a session: say what is tracked and where every part is in the first cloud."""
    service.readiness.check_takes_sessions()
    order, secret = order_of(body, service.settings), None
    if clouds_need_secrets(service.settings):
        secret = new_secret()
        order = replace(order, secret_sha256=sha256(secret).hexdigest())
    async with threads.naming(named=body.ros2 is not None and body.ros2.name is not None):
        check_name_free(body, service.registry.sessions())
        session = await threads.run(lambda: service.registry.open(order))
    response.headers["Location"] = f"{router.prefix}/{session.session_id}"
    answer = opened(session, service, request.url.hostname or "")
    answer.zenoh.secret = None if secret is None else secret.hex()
    return answer


@router.get("", responses=documented())
async def list_sessions(request: Request, service: Service) -> Sessions:
    """Every open session, oldest first."""
    host = request.url.hostname or ""
    return Sessions(sessions=[state_of(session, service, host) for session in service.registry.sessions()])


@router.get("/{session_id}", responses=documented(UnknownSessionError, InvalidRequestError))
async def get_session(session: OpenSession, request: Request, service: Service) -> SessionState:
    """State, counters and last result of one session."""
    return state_of(session, service, request.url.hostname or "")


@router.delete("/{session_id}", status_code=204, responses=documented(UnknownSessionError, InvalidRequestError))
async def close_session(session_id: SessionId, service: Service, threads: OnThread) -> None:
    """Close a session: the frame in hand is finished, subscribers get a last event."""
    await threads.run(lambda: service.registry.close(session_id, CloseReason.DELETED))


@router.get("/{session_id}/pose", response_model=Result, responses=documented(UnknownSessionError, InvalidRequestError))
async def get_pose(session: OpenSession) -> Response:
    """The last result; before the first frame, the pose that was given or gone on with, with `seq` null."""
    return Response(session.last_result.to_json(), media_type="application/json")


@router.put(
    "/{session_id}/pose",
    response_model=Result,
    responses=documented(UnknownSessionError, *BODY_PROBLEMS, *POSE_PROBLEMS),
)
async def put_pose(body: NewPose, session: OpenSession, threads: OnThread) -> Response:
    """Start again from a given pose; frames may be numbered anew."""
    try:
        pose = pose_of(body.parts, session.category)
    except RejectedError as rejection:
        await threads.run_in_turn(session, partial(session.refuse_pose, rejection))
        raise
    result = await threads.run_in_turn(session, lambda: session.reset(pose))
    return Response(result.to_json(), media_type="application/json")


def order_of(body: NewSession, settings: Settings) -> Order:
    """What a client asks for, with the service's own choices where it leaves them open.

    Raises:
        RequestRejectedError: an option or the pose is refused.
    """
    idle_timeout_s = settings.idle_timeout_s if body.idle_timeout_s is None else body.idle_timeout_s
    if idle_timeout_s > max(settings.idle_timeout_s, settings.max_idle_timeout_s):
        raise InvalidRequestError(
            Mistake(
                "/body/idle_timeout_s",
                f"{idle_timeout_s:g} s is over the limit of {settings.max_idle_timeout_s:g} s",
            )
        )
    try:
        category = categories.get_category(body.category)
    except categories.UnknownCategoryError as error:
        raise UnknownCategoryError(str(error)) from error
    return Order(
        category=category.name,
        profile=body.profile or settings.profile,
        frame_id=body.frame_id,
        idle_timeout_s=idle_timeout_s,
        pose=pose_of(body.parts, category),
        camera=None if body.camera is None else camera_of(body.camera, settings.max_points),
        masks=body.masks,
        ros2=ros2_names(body, settings),
        options=track_options_of(body, category, settings.prediction),
        record=body.record,
    )

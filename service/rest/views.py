"""Sessions as the REST API shows them."""

from dataclasses import asdict

from captra.recording.writer import parts_of
from service.opening import options_of
from service.rest.outputs import Counters, GivenPart, OpenedSession, Result, Ros2Topics, SessionState, StreamKeys
from service.session import Session
from service.tracking_service import TrackingService

WILDCARDS = ("0.0.0.0", "[::]")


def opened(session: Session, service: TrackingService, host: str) -> OpenedSession:
    """What a client needs to go on; `host` is the name by which it reached the service."""
    return OpenedSession(
        session_id=session.session_id,
        category=session.category.name,
        state=session.last_result.state,
        expires_after_s=session.liveness.expires_after_s,
        encodings=list(session.codecs.encodings),
        zenoh=stream_keys(session, service, host),
        ros2=ros2_topics(session),
    )


def state_of(session: Session, service: TrackingService, host: str) -> SessionState:
    """A session as it is now."""
    record, ledger = session.record, session.ledger
    return SessionState(
        **opened(session, service, host).model_dump(),
        **options_of(record),
        profile=record.profile,
        frame_id=record.frame_id,
        idle_timeout_s=record.idle_timeout_s,
        record=record.record,
        created_ns=record.created_ns,
        client=record.has_client,
        started_from=[GivenPart.model_validate(part) for part in parts_of(session.started_from)],
        counters=Counters(**asdict(ledger.counts), rejected_by_reason=ledger.rejected_by_reason),
        last_result=Result.model_validate_json(session.last_result.to_json()),
    )


def ros2_topics(session: Session) -> Ros2Topics | None:
    """Where a session is reached in ROS 2, if it is."""
    names, category = session.record.ros2, session.category
    if names is None:
        return None
    return Ros2Topics(
        points_topic=names.points_topic,
        detections_topic=names.detections_topic,
        joint_states_topic=names.joints_topic if category.joints else None,
        frames=[names.frame_of(part) for part in category.parts],
    )


def stream_keys(session: Session, service: TrackingService, host: str) -> StreamKeys:
    """Where a session is reached by Zenoh."""
    keys = service.transport.keys(session.session_id)
    return StreamKeys(cloud=keys.cloud, pose=keys.pose, event=keys.event, endpoints=endpoints_for(service, host))


def endpoints_for(service: TrackingService, host: str) -> list[str]:
    """Where a client connects to that reached the service by the name `host`."""
    return [reachable(endpoint, host) for endpoint in service.transport.endpoints]


def reachable(endpoint: str, host: str) -> str:
    """An endpoint as a client reaches it: a router that listens everywhere is where the REST API is."""
    bracketed = f"[{host}]" if ":" in host and not host.startswith("[") else host
    for wildcard in WILDCARDS:
        endpoint = endpoint.replace(f"/{wildcard}:", f"/{bracketed}:")
    return endpoint

"""What the list of sessions shows."""

import time
from typing import Any

import orjson

from service.session import Session
from service.tracking_service import TrackingService
from service.viewer.previews import Previews


def overview(service: TrackingService, previews: Previews) -> bytes:
    """What there is to look at, as the message that viewers get twice a second.

    Of recordings it has no more than how often their list changed, so that a page asks for them when they are others
    than it shows: a session may open and end between two of these messages.
    """
    return orjson.dumps(
        {
            "type": "overview",
            "time_s": time.monotonic(),
            "sessions": [summary(session) for session in service.registry.sessions()],
            "previews": previews.names(),
            "recordings_changes": service.recordings.changes,
        }
    )


def summary(session: Session) -> dict[str, Any]:
    """One session."""
    last, counts = session.last_result, session.ledger.counts
    return {
        "session_id": session.session_id,
        "category": session.category.name,
        "frame_id": last.frame_id,
        "state": last.state,
        "confidence": last.confidence,
        "seq": last.seq,
        "latency_ms": last.timing_ms.total,
        "processed": counts.processed,
        "dropped": counts.dropped,
        "rejected": counts.rejected,
        "expires_after_s": session.liveness.expires_after_s,
    }

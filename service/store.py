"""What must outlive a process: the settings of each session and its last trusted pose, behind one small interface."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

from captra.geometry import Pose
from service.camera import Camera
from service.ros2.options import Ros2Options
from service.track_options import TrackOptions


@dataclass(frozen=True)
class TrustedPose:
    """Where to go on from."""

    pose: Pose
    """All parts, in the frame of the clouds."""
    seq: int | None
    """Frame it came from; none for a pose that a client gave."""


@dataclass(frozen=True)
class SessionRecord:
    """All that is needed to go on with a session anywhere."""

    session_id: str
    """Part of its keys."""
    category: str
    """What is tracked."""
    profile: str
    """With which sampling budget."""
    frame_id: str
    """Frame of clouds that name none."""
    idle_timeout_s: float
    """Closed after so long without a frame."""
    created_ns: int
    """When it was opened, nanoseconds since 1970."""
    trusted: TrustedPose
    """The last pose worth going on from."""
    has_client: bool = False
    """Whether a client's liveliness token was seen: when it does not come back, neither does the client."""
    secret_sha256: str | None = None
    """Hexadecimal digest of the secret that has to accompany clouds by Zenoh; none when anybody may put them."""
    camera: Camera | None = None
    """Of depth images; none where only clouds come."""
    masks: str | None = None
    """What masks that travel with frames tell: `object` or `parts`; none where none come."""
    ros2: Ros2Options | None = None
    """Its names in ROS 2; none where the service was no node when it was opened."""
    options: TrackOptions = field(default_factory=TrackOptions)
    """What its track does beyond the paper's method."""
    record: bool = False
    """Whether the service records it."""


class StoreError(RuntimeError):
    """Sessions cannot be kept; says what to do."""


class SessionStore(Protocol):
    """Keeps records of open sessions; every method may be called from any thread and returns quickly."""

    def watch(self, on_failure: Callable[[], None]) -> None:
        """Call this from now on, whenever something could not be kept."""

    def save(self, record: SessionRecord) -> None:
        """Add or replace a session; raises StoreError when it cannot be kept."""

    def trust(self, session_id: str, trusted: TrustedPose) -> None:
        """Remember a session's last trusted pose; nothing happens for a session that is not kept."""

    def remove(self, session_id: str) -> None:
        """Forget a session, if it is kept."""

    def load(self) -> Sequence[SessionRecord]:
        """Every session, oldest first."""

    def close(self) -> None:
        """Let go of whatever the store holds."""


class InMemorySessionStore:
    """Keeps sessions as long as the process lives."""

    def __init__(self) -> None:
        self._records: dict[str, SessionRecord] = {}
        self._lock = threading.Lock()

    def watch(self, on_failure: Callable[[], None]) -> None:
        """Memory does not fail."""

    def save(self, record: SessionRecord) -> None:
        """Add or replace a session."""
        with self._lock:
            self._records[record.session_id] = record

    def trust(self, session_id: str, trusted: TrustedPose) -> None:
        """Remember a session's last trusted pose."""
        with self._lock:
            record = self._records.get(session_id)
            if record is not None:
                self._records[session_id] = replace(record, trusted=trusted)

    def remove(self, session_id: str) -> None:
        """Forget a session."""
        with self._lock:
            self._records.pop(session_id, None)

    def load(self) -> Sequence[SessionRecord]:
        """Every session, oldest first."""
        with self._lock:
            return sorted(self._records.values(), key=lambda record: record.created_ns)

    def close(self) -> None:
        """Nothing is held."""

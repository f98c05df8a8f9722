"""Prometheus metrics of one service, in a registry of its own."""

from collections.abc import Callable, Mapping
from functools import partial

from prometheus_client import CollectorRegistry, Counter, Gauge, Histogram, ProcessCollector, generate_latest

from captra.health import State
from service.liveness import CloseReason
from service.rejections import FRAME_REASONS, REQUEST_REASONS

STAGE_BUCKETS_S = (
    0.00002,
    0.00005,
    0.0001,
    0.0002,
    0.0005,
    0.001,
    0.002,
    0.005,
    0.01,
    0.02,
    0.033,
    0.05,
    0.067,
    0.1,
    0.2,
    0.5,
    1.0,
    2.0,
)
CONFIDENCE_BUCKETS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0)


class Telemetry:
    """The metrics; every method may be called from any thread."""

    def __init__(self) -> None:
        registry = CollectorRegistry()
        self._registry = registry
        self._received = Counter("captra_frames_received_total", "Frames that reached the service.", registry=registry)
        self._processed = Counter("captra_frames_processed_total", "Frames with a result.", registry=registry)
        self._dropped = Counter(
            "captra_frames_dropped_total",
            "Frames that newer ones replaced before they were processed, or that the network lost; from gaps in seq.",
            registry=registry,
        )
        self._rejected = Counter(
            "captra_frames_rejected_total", "Frames refused, by reason.", ["reason"], registry=registry
        )
        self._requests_rejected = Counter(
            "captra_requests_rejected_total",
            "Requests other than frames refused, by reason.",
            ["reason"],
            registry=registry,
        )
        self._events_dropped = Counter(
            "captra_events_dropped_total", "Events untold because subscribers are too slow.", registry=registry
        )
        self._opened = Counter("captra_sessions_opened_total", "Sessions opened by clients.", registry=registry)
        self._restored = Counter(
            "captra_sessions_restored_total", "Sessions gone on with from the store.", registry=registry
        )
        self._closed = Counter(
            "captra_sessions_closed_total", "Sessions ended, by reason.", ["reason"], registry=registry
        )
        self._store_failures = Counter(
            "captra_store_failures_total", "Writes of sessions that failed.", registry=registry
        )
        ProcessCollector(registry=registry)  # memory, file handles, CPU time
        self._stages = Histogram(
            "captra_stage_seconds",
            "Time of one frame, by stage.",
            ["stage"],
            buckets=STAGE_BUCKETS_S,
            registry=registry,
        )
        self._confidence = Histogram(
            "captra_confidence", "Confidence of results.", buckets=CONFIDENCE_BUCKETS, registry=registry
        )
        self._sessions = Gauge("captra_sessions", "Open sessions, by state.", ["state"], registry=registry)
        self._ready = Gauge("captra_ready", "1 when the service can track.", registry=registry)
        for reason in FRAME_REASONS:  # counters that exist from the start can be alerted on
            self._rejected.labels(reason)
        for reason in REQUEST_REASONS:
            self._requests_rejected.labels(reason)
        for close_reason in CloseReason:
            self._closed.labels(close_reason.value)

    def watch(self, count_sessions: Callable[[State], int], is_ready: Callable[[], bool]) -> None:
        """Ask for these whenever the metrics are read."""
        for state in State:
            self._sessions.labels(state.value).set_function(partial(count_sessions, state))
        self._ready.set_function(is_ready)

    def session_opened(self) -> None:
        """A client opened a session."""
        self._opened.inc()

    def session_restored(self) -> None:
        """A session went on from the store."""
        self._restored.inc()

    def session_closed(self, reason: CloseReason) -> None:
        """A session ended."""
        self._closed.labels(reason.value).inc()

    def store_failed(self) -> None:
        """The store could not be written."""
        self._store_failures.inc()

    def event_dropped(self) -> None:
        """An event went untold."""
        self._events_dropped.inc()

    def frame_received(self) -> None:
        """A frame came."""
        self._received.inc()

    def frame_processed(self, confidence: float, dropped: int) -> None:
        """A frame has a result; `dropped` others before it have none."""
        self._processed.inc()
        self._dropped.inc(dropped)
        self._confidence.observe(confidence)

    def spent(self, stages_ms: Mapping[str, float]) -> None:
        """Time that stages of a frame took, milliseconds."""
        for stage, duration_ms in stages_ms.items():
            self._stages.labels(stage).observe(duration_ms / 1e3)

    def frame_rejected(self, reason: str) -> None:
        """A frame was refused."""
        self._rejected.labels(reason).inc()

    def request_rejected(self, reason: str) -> None:
        """Another request was refused."""
        self._requests_rejected.labels(reason).inc()

    def render(self) -> bytes:
        """The metrics in the text format of Prometheus."""
        return generate_latest(self._registry)

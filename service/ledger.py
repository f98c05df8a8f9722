"""What became of one session's frames; the service's metrics hear of it too."""

import threading
from collections import Counter
from dataclasses import dataclass, replace

from service.telemetry import Telemetry


@dataclass(frozen=True)
class Counts:
    """Frames of one session."""

    received: int = 0
    """Reached the service."""
    processed: int = 0
    """Have a result."""
    dropped: int = 0
    """Replaced by newer ones or lost on the way: gaps in `seq`."""
    rejected: int = 0
    """Refused."""


class Ledger:
    """Counts; its methods may be called from any thread."""

    def __init__(self, telemetry: Telemetry) -> None:
        self._telemetry = telemetry
        self._lock = threading.Lock()
        self._counts = Counts()
        self._reasons: Counter[str] = Counter()

    @property
    def counts(self) -> Counts:
        """So far."""
        return self._counts

    @property
    def rejected_by_reason(self) -> dict[str, int]:
        """How many frames were refused for which reason."""
        with self._lock:
            return dict(self._reasons)

    def received(self) -> None:
        """A frame came."""
        with self._lock:
            self._counts = replace(self._counts, received=self._counts.received + 1)
        self._telemetry.frame_received()

    def processed(self, confidence: float, dropped: int) -> None:
        """A frame has a result; `dropped` others before it have none."""
        with self._lock:
            counts = self._counts
            self._counts = replace(counts, processed=counts.processed + 1, dropped=counts.dropped + dropped)
        self._telemetry.frame_processed(confidence, dropped)

    def rejected(self, reason: str) -> None:
        """A frame was refused."""
        with self._lock:
            self._counts = replace(self._counts, rejected=self._counts.rejected + 1)
            self._reasons[reason] += 1
        self._telemetry.frame_rejected(reason)

    def event_dropped(self) -> None:
        """An event went untold, because those who listen are too slow."""
        self._telemetry.event_dropped()

    def spent(self, **stages_ms: float) -> None:
        """Time that stages of a frame took, milliseconds."""
        self._telemetry.spent(stages_ms)

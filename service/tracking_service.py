"""The service without its HTTP face: everything wired together, started and stopped in order."""

import logging
import threading
from types import TracebackType
from typing import Self

from captra.categories import get_category
from captra.tracker import TrackerOptions
from service.codecs import Codecs, build_codecs
from service.networks import NetworksProvider, NoModelError
from service.readiness import Readiness
from service.recording.folder import Recordings
from service.registry import Registry
from service.settings import Settings
from service.store import SessionRecord, SessionStore
from service.sweeper import Sweeper
from service.telemetry import Telemetry
from service.transport import Transport

logger = logging.getLogger(__name__)


class TrackingService:
    """Use it as a context manager: sessions are served inside, and all is closed in order at the end."""

    def __init__(
        self, settings: Settings, provider: NetworksProvider, store: SessionStore, transport: Transport
    ) -> None:
        self.settings = settings
        """What the operator chose."""
        self.provider = provider
        """Where networks come from."""
        self.transport = transport
        """How sessions are reached by Zenoh."""
        self.telemetry = Telemetry()
        """Metrics."""
        self.recordings = Recordings(
            settings.record_dir or settings.state_dir / "recordings",
            settings.record_max_bytes,
            settings.record_max_total_bytes,
        )
        """Sessions that the service recorded."""
        self.registry = Registry(
            provider,
            store,
            transport,
            self.telemetry,
            self._codecs_of,
            self._options_of,
            self.recordings,
            max_sessions=settings.max_sessions,
            frames_at_once=settings.frames_at_once,
            client_grace_s=settings.client_grace_s,
        )
        """Open sessions."""
        self._store = store
        store.watch(self.telemetry.store_failed)
        self._sweeper = Sweeper(self.registry.sweep)
        self._preparing = threading.Thread(target=self._prepare, name="captra-prepare", daemon=True)
        self.readiness = Readiness()
        """Whether tracking can start at once."""
        self.telemetry.watch(self.registry.count, lambda: self.readiness.is_ready)

    def start(self) -> None:
        """Listen, and load models in the background.

        Raises:
            TransportError: when an endpoint cannot be listened on.
        """
        self.transport.open()
        self._sweeper.start()
        self._preparing.start()

    def drain(self) -> None:
        """Finish the frames in hand, for as long as they may take; nothing new is begun."""
        self.readiness.stopping()
        self.registry.drain(self.settings.shutdown_timeout_s)

    def store_state(self) -> None:
        """Write down what the store still holds; nothing is kept afterwards."""
        self._store.close()

    def stop(self) -> None:
        """Finish frames in hand, tell clients, withdraw every key, close."""
        self.drain()
        self._sweeper.stop()
        self.registry.shut_down()
        self.store_state()
        self.transport.close()
        logger.info("stopped")

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.stop()

    def _codecs_of(self, record: SessionRecord) -> Codecs:
        limits = (self.settings.max_points, self.settings.max_payload_bytes)
        return build_codecs(*limits, get_category(record.category), record.camera, record.masks)

    def _options_of(self, record: SessionRecord) -> TrackerOptions:
        return record.options.tracker_options(self.settings.search_budget_ms)

    def _prepare(self) -> None:
        left = self.recordings.left_behind()
        self._get_ready()
        self.recordings.salvage(left)  # gigabytes of it must not keep sessions waiting

    def _get_ready(self) -> None:
        try:
            self.provider.prepare()
            self.registry.restore()
        except NoModelError as error:
            logger.error("not ready: %s", error)
            self.readiness.prepared(str(error))
        except Exception as error:
            logger.exception("not ready: preparation failed")
            self.readiness.prepared(f"preparation failed ({error}): see the log, then restart the service")
        else:
            logger.info("ready")
            self.readiness.prepared()

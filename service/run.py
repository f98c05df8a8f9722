"""One service process: from settings to a clean end."""

import logging
from collections.abc import Callable

import zenoh

from service.bundles import BundleNetworks
from service.http_server import HttpServer, bind
from service.logs import configure_logging
from service.rest.app import create_app
from service.router import ZenohTransport
from service.security.wiring import check_exposure, check_files, zenoh_entries
from service.settings import Settings
from service.shutdown import Shutdown
from service.sqlite_store import SqliteSessionStore
from service.tracking_service import TrackingService

logger = logging.getLogger(__name__)


def build_service(settings: Settings) -> TrackingService:
    """A service of the bundles in the models folder, reached by Zenoh, with sessions in the state folder.

    Raises:
        StoreError: sessions cannot be kept there.
    """
    return TrackingService(
        settings,
        BundleNetworks(settings.models_dir, settings.profile, settings.provider, settings.threads),
        SqliteSessionStore(settings.state_dir / f"{settings.service}.sqlite"),
        ZenohTransport(
            settings.service,
            settings.zenoh_listen,
            settings.zenoh_advertise,
            settings.max_payload_bytes,
            zenoh_entries(settings),
        ),
    )


def run(settings: Settings, build: Callable[[Settings], TrackingService] = build_service) -> None:
    """Serve what `build` makes until SIGTERM or SIGINT, then finish what is in hand.

    Call it on the main thread of a process that ends when it returns: one that does not is ended by force.

    Raises:
        ExposedError: others would reach a service that nothing guards.
        FileNotFoundError: a certificate or key is missing.
        PortInUseError: the REST API cannot listen.
        StoreError: sessions cannot be kept.
        TransportError: Zenoh cannot listen.
    """
    check_exposure(settings)
    check_files(settings)
    configure_logging(settings.log_level)
    zenoh.init_log_from_env_or("error")
    with bind(settings.http_host, settings.http_port) as listener, build(settings) as service:
        server = HttpServer(
            create_app(service), settings.shutdown_timeout_s, settings.http_tls_cert, settings.http_tls_key
        )
        Shutdown(service, server).on_signals()
        host, port = listener.getsockname()[:2]
        scheme = "http" if settings.http_tls_cert is None else "https"
        logger.info("serving", extra={"http": f"{scheme}://{host}:{port}", "zenoh": service.transport.endpoints})
        server.run(sockets=[listener])

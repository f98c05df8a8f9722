"""One service process: from settings to a clean end."""

import logging
from collections.abc import Callable
from typing import Any

import zenoh

from service.bundles import BundleNetworks
from service.http_server import HttpServer, bind
from service.logs import configure_logging
from service.rest.app import create_app
from service.ros2.names import Domain
from service.ros2.node import NO_ROS2, Ros2, Ros2Node
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
        BundleNetworks(settings.models_dir, settings.profile, settings.provider, settings.threads, settings.preload),
        SqliteSessionStore(settings.state_dir / f"{settings.service}.sqlite"),
        build_transport(settings),
    )


def build_transport(settings: Settings) -> ZenohTransport:
    """The router, guarded and connected as the settings say, as a node of ROS 2 where they want one."""
    ros2: Ros2 = NO_ROS2
    if settings.ros2:
        domain = Domain(settings.ros2_domain, hashes=settings.ros2_distribution != "humble")
        ros2 = Ros2Node(domain, settings.ros2_points_topic)
    return ZenohTransport(
        settings.service,
        settings.zenoh_listen,
        settings.zenoh_advertise,
        settings.max_payload_bytes,
        connections(settings.zenoh_connect) | zenoh_entries(settings),
        ros2,
    )


def connections(endpoints: tuple[str, ...]) -> dict[str, Any]:
    """Entries of Zenoh's configuration that connect to other routers, however late they come."""
    if not endpoints:
        return {}
    return {"connect/endpoints": endpoints, "connect/timeout_ms": -1, "connect/exit_on_failure": False}


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

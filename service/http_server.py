"""The HTTP server: uvicorn on a socket of our own, stopped by us and not by signals it catches."""

import contextlib
import socket
from collections.abc import Iterator
from pathlib import Path

import uvicorn
from fastapi import FastAPI


class PortInUseError(OSError):
    """The REST server cannot listen; says what to do."""


def bind(host: str, port: int) -> socket.socket:
    """A listening socket, before anything else is started.

    Raises:
        PortInUseError: the port is taken, or the address is not one of this machine.
    """
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        listener = socket.create_server((host, port), family=family, backlog=2048)
    except OSError as error:
        raise PortInUseError(
            f"cannot listen for HTTP on {host}:{port}: {error.strerror}. "
            "Stop what uses the port, or choose another with CAPTRA_HTTP_PORT or CAPTRA_HTTP_HOST"
        ) from error
    # Connections inherit it. Without it the body of an answer waits for the client to acknowledge the header, which
    # takes 40 ms; asyncio sets it only on sockets that name their protocol, as those of create_server do not.
    listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return listener


class HttpServer(uvicorn.Server):
    """Serves an application until `stop` is called, from any thread or a signal handler."""

    def __init__(
        self, app: FastAPI, shutdown_timeout_s: float, certificate: Path | None = None, key: Path | None = None
    ) -> None:
        """With a certificate and its key (PEM) it speaks HTTPS alone."""
        super().__init__(
            uvicorn.Config(
                app,
                lifespan="off",
                log_config=None,
                access_log=False,
                server_header=False,
                ssl_certfile=certificate,
                ssl_keyfile=key,
                ws_per_message_deflate=False,  # clouds hardly shrink, and trying would take time from tracking
                ws_max_size=2**16,  # viewers send a few words
                timeout_graceful_shutdown=max(1, round(shutdown_timeout_s)),
            )
        )

    def stop(self, within_s: float | None = None) -> None:
        """Finish the requests in hand, then return from `run`; what takes longer than `within_s` is broken off."""
        if within_s is not None:
            self.config.timeout_graceful_shutdown = within_s  # type: ignore[assignment]  # it takes any number
        self.should_exit = True

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Leave signals to the command."""
        yield

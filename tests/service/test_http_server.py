"""The REST server's socket: answers leave at once."""

import os
import socket
import stat
from collections.abc import Iterator
from pathlib import Path

from service.http_server import bind
from tests.service.support import Running

NO_DELAY = socket.IPPROTO_TCP, socket.TCP_NODELAY
LISTENING = socket.SOL_SOCKET, socket.SO_ACCEPTCONN


def test_connections_do_not_wait_for_acknowledgements() -> None:
    with bind("127.0.0.1", 0) as listener, socket.create_connection(listener.getsockname()):
        accepted, _ = listener.accept()
        with accepted:
            assert accepted.getsockopt(*NO_DELAY)


def test_nor_do_those_that_the_service_answers_on(service: Running) -> None:
    service.http.get("/v1/health/live").raise_for_status()
    answering = [
        one.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY) for one in accepted_at(service.http.base_url.port)
    ]
    assert answering
    assert all(answering)


def accepted_at(port: int | None) -> Iterator[socket.socket]:
    """Connections to a port of this process that it has accepted."""
    for entry in Path("/proc/self/fd").iterdir():
        try:
            mode = os.fstat(int(entry.name)).st_mode
        except OSError:  # that of the listing itself
            continue
        if stat.S_ISSOCK(mode):
            with socket.socket(fileno=os.dup(int(entry.name))) as one:
                internet = one.family == socket.AF_INET and one.type == socket.SOCK_STREAM
                if (
                    internet
                    and one.getsockname()[1] == port
                    and not one.getsockopt(socket.SOL_SOCKET, socket.SO_ACCEPTCONN)
                ):
                    yield one

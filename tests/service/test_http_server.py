"""The REST server's socket: answers leave at once."""

import socket
import time

import numpy as np

from service.http_server import bind
from tests.service.support import Running

DELAYED_ACKNOWLEDGEMENT_S = 0.04
ANSWERS = 50


def test_connections_do_not_wait_for_acknowledgements() -> None:
    with bind("127.0.0.1", 0) as listener, socket.create_connection(listener.getsockname()):
        accepted, _ = listener.accept()
        with accepted:
            assert accepted.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)


def test_answers_on_a_kept_connection_come_at_once(service: Running) -> None:
    durations_s = []
    for _ in range(ANSWERS):
        started_s = time.perf_counter()
        service.http.get("/v1/health/live")
        durations_s.append(time.perf_counter() - started_s)
    fastest_s = np.quantile(durations_s, 0.1)  # the others may have waited for a core
    assert fastest_s < DELAYED_ACKNOWLEDGEMENT_S / 2

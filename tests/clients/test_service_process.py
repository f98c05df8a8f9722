import signal
import socket
from pathlib import Path

import httpx
import numpy as np
import pytest

from clients import ServiceUnreachableError, open_session
from clients.service_process import ServiceProcess, free_ports
from tests.clients.sequences import drifting_mug


def test_free_ports_are_different_and_can_be_listened_on() -> None:
    ports = free_ports(3)
    assert len(set(ports)) == 3
    for port in ports:
        socket.create_server(("127.0.0.1", port)).close()


def test_it_serves_while_the_block_runs_and_ends_cleanly(untrained_models: Path) -> None:
    recording = drifting_mug(3)
    with ServiceProcess({"CAPTRA_MODELS_DIR": str(untrained_models)}) as service:
        with open_session("mug", recording.init, url=service.url) as session:
            results = list(session.track(recording.clouds))
        assert [result.seq for result in results] == [0, 1, 2]
        assert all(np.isfinite(result.parts[0].translation).all() for result in results)
        assert service.stop() == 0
    with pytest.raises(httpx.ConnectError):
        httpx.get(service.url)


@pytest.mark.skipif(not Path("/proc/self/maps").exists(), reason="memory maps are Linux's")
def test_clients_that_go_leave_no_memory_mapped(untrained_models: Path) -> None:
    recording = drifting_mug(1)
    with ServiceProcess({"CAPTRA_MODELS_DIR": str(untrained_models)}) as service:
        for _ in range(2):
            with open_session("mug", recording.init, url=service.url) as session:
                list(session.track(recording.clouds))
        assert "/dev/shm" not in Path(f"/proc/{service.pid}/maps").read_text()


def test_a_service_that_ends_at_once_is_told_with_its_last_words() -> None:
    with pytest.raises(ServiceUnreachableError, match=r"(?s)ended with status 2.*profile"):
        ServiceProcess({"CAPTRA_PROFILE": "huge"}).__enter__()


def test_a_service_without_models_is_told_and_stopped(tmp_path: Path) -> None:
    service = ServiceProcess({"CAPTRA_MODELS_DIR": str(tmp_path)})
    with pytest.raises(ServiceUnreachableError, match="captra export"):
        service.__enter__()
    assert service.stop() in (0, -signal.SIGTERM)

"""One folder of keys, one file of settings: HTTPS, mutual TLS and rules for Zenoh, with real processes."""

import json
import os
import shutil
import stat
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import httpx
import numpy as np
import pytest
import zenoh

from captra.geometry import Pose
from clients import ServiceUnreachableError, Session, open_session
from clients.results import Event
from clients.service_process import free_ports
from clients.stream import connect
from service.security.wiring import ExposedError, check_exposure, host_of
from service.settings import Settings, ZenohAccess
from tests.service.support import blob, inbox, late_inbox
from tests.service.test_process import ROOT, entry, process, stream

POSE = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))


def certify(folder: Path, *clients: str) -> None:
    command = ["-m", "captra", "certify", str(folder), "--host", "localhost", "--host", "127.0.0.1"]
    options = [word for name in clients for word in ("--client", name)]
    subprocess.run([sys.executable, *command, *options], cwd=ROOT, check=True, capture_output=True)


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("deployment") / "keys"
    certify(folder, "arm")
    certify(folder, "arm", "screen", "visitor")  # adds clients and keeps what is there
    return folder


@pytest.fixture(scope="module")
def foreign_keys(keys: Path) -> Path:
    """Another authority's, for the same name, whose holder knows the service's authority."""
    folder = keys.parent / "foreign"
    certify(folder, "arm")
    shutil.copy(keys / "ca.pem", folder / "ca.pem")
    return folder


@contextmanager
def identity(monkeypatch: pytest.MonkeyPatch, keys: Path, name: str) -> Iterator[None]:
    place = keys / "clients" / name
    with monkeypatch.context() as environment:
        environment.setenv("CAPTRA_API_KEY", (place / "api-key").read_text())
        environment.setenv("CAPTRA_CA_FILE", str(keys / "ca.pem"))
        environment.setenv("CAPTRA_CLIENT_CERT", str(place / "client.pem"))
        environment.setenv("CAPTRA_CLIENT_KEY", str(place / "client.key"))
        yield


def test_private_files_are_private(keys: Path) -> None:
    private = [*keys.rglob("*.key"), *keys.rglob("api-key")]
    assert len(private) == 8
    for path in private:
        assert stat.S_IMODE(path.stat().st_mode) == 0o600, path


def test_guarded_service_serves_its_clients_and_nobody_else(
    keys: Path, foreign_keys: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    http_port, zenoh_port = free_ports(2)
    settings = (keys / "captra.toml").read_text()
    only_watches = settings.replace('common_name = "screen"\nmay = "stream"', 'common_name = "screen"\nmay = "watch"')
    assert only_watches != settings
    known, visitor, nobody = only_watches.rpartition('[[zenoh_access]]\ncommon_name = "visitor"')
    assert visitor
    assert nobody == '\nmay = "stream"\n'
    (keys / "test.toml").write_text(known)
    endpoint = f"tls/127.0.0.1:{zenoh_port}"
    variables = {
        "CAPTRA_CONFIG": str(keys / "test.toml"),
        "CAPTRA_HTTP_HOST": "127.0.0.1",
        "CAPTRA_HTTP_PORT": str(http_port),
        "CAPTRA_ZENOH_LISTEN": json.dumps([endpoint]),
    }
    url = f"https://127.0.0.1:{http_port}"
    with process("-m", "tests.service.quick_service", **variables) as service:
        assert entry(stream(service.stderr), "serving")["http"] == url
        entry(stream(service.stderr), "ready")
        with pytest.raises(httpx.ConnectError, match="certificate"):
            httpx.get(f"{url}/v1/health/live")
        with pytest.raises(ServiceUnreachableError):
            connect((endpoint,), 1.0)  # without a certificate
        with identity(monkeypatch, foreign_keys, "arm"), pytest.raises(ServiceUnreachableError):
            connect((endpoint,), 1.0)  # with one that another authority gave
        with identity(monkeypatch, keys, "arm"), open_session("mug", POSE, url=url) as session:
            (result,) = session.track([blob((0.01, 0, 0.5))])
            assert result.parts[0].translation[0] == pytest.approx(0.01, abs=2e-3)
            with identity(monkeypatch, keys, "screen"), connect((endpoint,), 5.0) as screen:
                hear_the_last_result_late(session, screen)
                watch_but_not_stream(session, screen)
            with identity(monkeypatch, keys, "visitor"), connect((endpoint,), 5.0) as visiting:
                neither_watch_nor_stream(session, visiting)


def hear_the_last_result_late(session: Session, screen: zenoh.Session) -> None:
    """A certificate that may watch gets the result that was there before it came, and then those that follow."""
    with late_inbox(screen, f"captra/default/sessions/{session.session_id}/pose") as late:
        before = late.message(0)["seq"]
        (result,) = session.track([blob((0.01, 0, 0.5))])
        assert late.message(1)["seq"] == result.seq == before + 1


def watch_but_not_stream(session: Session, screen: zenoh.Session) -> None:
    """A certificate that may watch sees poses; what it puts does not arrive."""
    stem = f"captra/default/sessions/{session.session_id}"
    poses = inbox(screen, f"{stem}/pose")
    screen.put(f"{stem}/cloud", b"\0" * 12, encoding="application/vnd.captra.cloud.f32")
    events: list[Event] = []
    for seq, result in enumerate(session.track([blob((0.02, 0, 0.5))] * 5, on_event=events.append), start=2):
        assert result.seq == seq
    assert poses.message(0)["session_id"] == session.session_id
    assert events == []  # a put that had arrived would have been rejected


def neither_watch_nor_stream(session: Session, visiting: zenoh.Session) -> None:
    """A certificate that no rule names connects, and that is all."""
    stem = f"captra/default/sessions/{session.session_id}"
    poses = inbox(visiting, f"{stem}/pose")
    visiting.put(f"{stem}/cloud", b"\0" * 12, encoding="application/vnd.captra.cloud.f32")
    events: list[Event] = []
    assert len(list(session.track([blob((0.02, 0, 0.5))] * 5, on_event=events.append))) == 5
    assert events == []
    assert len(poses) == 0


def refusal(**variables: str) -> str:
    endpoint = {"CAPTRA_HTTP_PORT": "0", "CAPTRA_ZENOH_LISTEN": '["tcp/127.0.0.1:0"]'}
    with process("-m", "service", **(endpoint | variables)) as service:
        _, complaint = service.communicate(timeout=60)
        assert service.returncode == 2
        assert "Traceback" not in complaint
        return complaint


def test_service_refuses_to_start_open() -> None:
    assert "CAPTRA_ALLOW_OPEN" in refusal(CAPTRA_HTTP_HOST="0.0.0.0")


def test_missing_certificate_is_named(tmp_path: Path) -> None:
    missing = str(tmp_path / "none.pem")
    assert missing in refusal(CAPTRA_HTTP_TLS_CERT=missing, CAPTRA_HTTP_TLS_KEY=missing)


GUARDS = {"api_keys": ({"name": "x", "sha256": "0" * 64},)}
PEM = {name: Path(os.devnull) for name in ("zenoh_tls_cert", "zenoh_tls_key", "zenoh_tls_ca")}


@pytest.mark.parametrize(
    ("chosen", "starts"),
    [
        ({}, True),
        ({"http_host": "::1"}, True),
        ({"http_host": "localhost"}, True),
        ({"http_host": "10.0.0.5"}, False),
        ({"http_host": "0.0.0.0", "allow_open": True}, True),
        ({"http_host": "0.0.0.0", **GUARDS}, True),
        ({"http_host": "0.0.0.0", "token_key_file": Path(os.devnull)}, True),
        ({"http_host": "0.0.0.0", "cloud_secrets": True}, False),
        ({"zenoh_listen": ("tcp/0.0.0.0:7447",)}, False),
        ({"zenoh_listen": ("tcp/[::]:7447",)}, False),
        ({"zenoh_listen": ("tcp/127.0.0.1:1", "udp/10.0.0.5:1")}, False),
        ({"zenoh_listen": ("tls/0.0.0.0:7447",)}, False),
        ({"zenoh_listen": ("tls/0.0.0.0:7447",), **PEM}, True),
        ({"zenoh_listen": ("tcp/0.0.0.0:7447",), **PEM}, False),
        ({"zenoh_listen": ("tcp/0.0.0.0:7447",), "cloud_secrets": True}, True),
        ({"zenoh_listen": ("tcp/0.0.0.0:7447",), "cloud_secrets": False, **GUARDS}, False),
    ],
)
def test_exposure(chosen: dict[str, object], starts: bool) -> None:
    settings = Settings(**chosen)  # type: ignore[arg-type]
    if starts:
        check_exposure(settings)
    else:
        with pytest.raises(ExposedError, match="CAPTRA_ALLOW_OPEN"):
            check_exposure(settings)


def test_hosts_of_endpoints() -> None:
    assert host_of("tls/[::1]:7447#so_sndbuf=65535") == "[::1]"
    assert host_of("tcp/robot.local:7447?prio=1-3") == "robot.local"
    assert host_of("unixsock-stream/run/captra.sock") == "localhost"


@pytest.mark.parametrize(
    "chosen",
    [
        {"http_tls_cert": Path("a.pem")},
        {"zenoh_tls_key": Path("a.key")},
        {"zenoh_tls_ca": Path("ca.pem")},
        {"zenoh_access": (ZenohAccess(common_name="arm"),)},
    ],
)
def test_half_a_guard_is_refused(chosen: dict[str, object]) -> None:
    with pytest.raises(ValueError, match="tls"):
        Settings(**chosen)  # type: ignore[arg-type]

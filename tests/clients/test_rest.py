"""What else may stand at an address, or in the environment: one line, and what to do."""

import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

from captra.cli import main
from tests.clients.sequences import drifting_mug, saved

PAGE = ("text/html", b"<html>a router's settings</html>")
BROKEN = ("application/json", b"{")
LIST = ("application/json", b"[]")
OTHER_JSON = ("application/json", b'{"name": "something else"}')


class Stranger(ThreadingHTTPServer):
    """A server that answers the same to everything."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.status = 200
        self.answer = PAGE

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"


class Handler(BaseHTTPRequestHandler):
    server: Stranger

    def do_GET(self) -> None:
        self.rfile.read(int(self.headers.get("Content-Length", 0)))
        media_type, content = self.server.answer
        self.send_response(self.server.status)
        self.send_header("Content-Type", media_type)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    do_POST = do_GET  # noqa: N815 - http.server names it

    def log_message(self, *message: object) -> None:
        """Keep quiet."""


@pytest.fixture
def stranger() -> Iterator[Stranger]:
    with Stranger() as server:
        thread = threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True)
        thread.start()
        yield server
        server.shutdown()
        thread.join(5)


def complaint(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """The line of a command that fails; every exception but SystemExit would be a traceback."""
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    assert ended.value.code == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    return said


@pytest.mark.parametrize("command", ["status", "track", "record"])
@pytest.mark.parametrize("answer", [PAGE, BROKEN, LIST, OTHER_JSON])
def test_another_server(
    command: str, answer: tuple[str, bytes], stranger: Stranger, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stranger.answer = answer
    options = {"status": (), "track": (saved(drifting_mug(3), tmp_path),), "record": ("--out", tmp_path)}
    said = complaint(capsys, command, *options[command], "--url", stranger.url)
    assert f"what answers at {stranger.url} is no captra service" in said
    assert "--url or CAPTRA_URL" in said


@pytest.mark.parametrize("answer", [PAGE, BROKEN, LIST, OTHER_JSON])
def test_another_servers_refusal(
    answer: tuple[str, bytes], stranger: Stranger, capsys: pytest.CaptureFixture[str]
) -> None:
    stranger.status, stranger.answer = 404, answer
    assert "Not Found (HTTP 404, unknown)" in complaint(capsys, "status", "--url", stranger.url)


@pytest.mark.parametrize("url", ["http://robot:80a80", "http://[::1", "http://ü..x", "http://robot\x01"])
def test_addresses_that_are_none(url: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert f"{url} is no address of a service: write it like" in complaint(capsys, "status", "--url", url)


def test_a_name_that_no_network_has(capsys: pytest.CaptureFixture[str]) -> None:
    assert "no captra service answers at" in complaint(capsys, "status", "--url", f"http://{64 * 'a'}")


@pytest.mark.parametrize(
    ("name", "why"),
    [("nosuch.pem", "No such file"), (".", "Is a directory"), ("no.pem", "NO_CERTIFICATE")],
)
def test_an_authority_that_cannot_be_read(
    name: str, why: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "no.pem").write_text("no certificate")
    monkeypatch.setenv("CAPTRA_CA_FILE", str(tmp_path / name))
    said = complaint(capsys, "status", "--url", "https://127.0.0.1:9")
    assert f"CAPTRA_CA_FILE names {tmp_path / name}" in said
    assert why in said


@pytest.mark.parametrize("key", ["schlüssel", "a\nb"])
def test_a_key_that_no_header_holds(
    key: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("CAPTRA_API_KEY", key)
    assert "CAPTRA_API_KEY holds characters" in complaint(capsys, "status", "--url", "http://127.0.0.1:9")

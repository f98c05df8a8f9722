"""The service as a process: starts without PyTorch, says what is wrong, ends gently."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import IO

import httpx
import pytest

from tests.service.support import Camera, blob, f32, free_endpoint, inbox, session_body, token_inbox, zenoh_client

ROOT = Path(__file__).parents[2]
HANGS_FOR_S = 60
"""After so long a process whose end hangs is ended by force, a second more or less."""
ENDS_WITHIN_S = 30
"""Far more than a gentle end takes on a busy machine, and less than one by force."""


@contextmanager
def process(*arguments: str, **variables: str) -> Iterator[subprocess.Popen[str]]:
    """A Python process in the root of the project, with state of its own, killed at the end if it still runs."""
    state = TemporaryDirectory(prefix="captra-state-")
    variables = {"CAPTRA_STATE_DIR": state.name, "CAPTRA_SHUTDOWN_TIMEOUT_S": str(HANGS_FOR_S)} | variables
    started = subprocess.Popen(
        [sys.executable, *arguments],
        cwd=ROOT,
        env={name: value for name, value in os.environ.items() if not name.startswith("CAPTRA_")} | variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield started
    finally:
        started.kill()
        started.communicate()
        state.cleanup()


def stream(pipe: IO[str] | None) -> IO[str]:
    assert pipe is not None
    return pipe


def entry(log: IO[str], message: str) -> dict[str, str]:
    """The first entry of a log with this message, waiting until it is there."""
    for line in log:
        found: dict[str, str] = json.loads(line)
        if found["message"] == message:
            return found
    raise AssertionError(f"the process ended without saying {message!r}")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_signal_ends_the_process_after_the_frame_in_hand(number: signal.Signals) -> None:
    endpoint = free_endpoint()
    variables = {"CAPTRA_HTTP_PORT": "0", "CAPTRA_ZENOH_LISTEN": json.dumps([endpoint])}
    with process("-m", "tests.service.slow_service", **variables) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        entry(stream(service.stderr), "ready")
        opened = httpx.post(f"{url}/v1/sessions", json=session_body()).json()
        with zenoh_client(endpoint) as network:
            poses, events = (inbox(network, opened["zenoh"][key]) for key in ("pose", "event"))
            Camera(network, opened["zenoh"]["cloud"]).put(f32(blob()), 1)
            assert stream(service.stdout).readline() == "asked\n"
            signalled_s = time.monotonic()
            service.send_signal(number)
            assert poses.message(0)["seq"] == 1
            event = events.message(0)
            assert (event["kind"], event["reason"]) == ("closing", "shutdown")
        assert service.wait(ENDS_WITHIN_S) == 0
        assert time.monotonic() - signalled_s < ENDS_WITHIN_S
        *looks, loaded = stream(service.stdout).read().splitlines()
        assert set(looks) <= {"asked"}
        assert loaded == "loaded service.bundles fastapi"  # and no torch
        with pytest.raises(httpx.ConnectError):
            httpx.get(f"{url}/v1/health/live")


def test_request_in_hand_is_answered_before_the_end() -> None:
    variables = {"CAPTRA_HTTP_PORT": "0", "CAPTRA_ZENOH_LISTEN": json.dumps([free_endpoint()])}
    with process("-m", "tests.service.slow_service", **variables) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        entry(stream(service.stderr), "ready")
        session_id = httpx.post(f"{url}/v1/sessions", json=session_body()).json()["session_id"]
        with httpx.stream(
            "POST",
            f"{url}/v1/sessions/{session_id}/frames?seq=1&stamp_ns=2",
            content=signal_when_sent(service, f32(blob())),
            headers={"Content-Type": "application/vnd.captra.cloud.f32"},
        ) as answer:
            assert json.loads(answer.read())["seq"] == 1
        assert service.wait(ENDS_WITHIN_S) == 0


def signal_when_sent(service: subprocess.Popen[str], body: bytes) -> Iterator[bytes]:
    """A body after which the process is told to end: the request is in hand by then."""
    yield body
    service.send_signal(signal.SIGTERM)


def test_service_of_the_command_line_serves_without_torch(tmp_path: Path) -> None:
    endpoint = free_endpoint()
    arguments = ("--port", "0", "--zenoh-listen", endpoint, "--models-dir", str(tmp_path), "--ros2")
    script = f"""
import os, sys, typer
end = os._exit
def tell(status):
    print("torch" in sys.modules, "onnxruntime" in sys.modules, flush=True)
    end(status)
os._exit = tell
import onnxruntime
from service.cli import serve
sys.argv = ["serve", *{arguments!r}]
typer.run(serve)
"""
    with process("-c", script) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        assert httpx.get(f"{url}/v1/health/live").status_code == 200
        with zenoh_client(endpoint) as network:
            assert str(token_inbox(network, "@ros2_lv/0/*/0/0/NN/**").sample(0).key_expr).endswith("/captra")
        service.send_signal(signal.SIGTERM)
        assert service.wait(ENDS_WITHIN_S) == 0
        assert stream(service.stdout).read() == "False True\n"


def test_service_without_models_lives_but_is_not_ready_and_says_what_to_do(tmp_path: Path) -> None:
    variables = {
        "CAPTRA_HTTP_PORT": "0",
        "CAPTRA_ZENOH_LISTEN": json.dumps([free_endpoint()]),
        "CAPTRA_MODELS_DIR": str(tmp_path),
    }
    with process("-m", "service", **variables) as service:
        url = entry(stream(service.stderr), "serving")["http"]
        for line in stream(service.stderr):
            if json.loads(line)["message"].startswith("not ready"):
                break
        answer = httpx.get(f"{url}/v1/health/ready")
        assert (answer.status_code, answer.json()["reason"]) == (503, "hindered")
        assert str(tmp_path) in answer.json()["detail"]
        assert "CAPTRA_MODELS_DIR" in answer.json()["detail"]
        refused = httpx.post(f"{url}/v1/sessions", json=session_body()).json()
        assert refused["reason"] == "category-without-model"


def test_taken_ports_are_named_with_the_setting_that_changes_them() -> None:
    endpoint = free_endpoint()
    port = endpoint.rpartition(":")[2]
    variables = {"CAPTRA_HTTP_PORT": "0", "CAPTRA_ZENOH_LISTEN": json.dumps([endpoint])}
    with process("-m", "service", **variables) as first:
        http_port = entry(stream(first.stderr), "serving")["http"].rpartition(":")[2]
        for changed, name in (({"CAPTRA_HTTP_PORT": http_port}, "CAPTRA_HTTP_PORT"), ({}, "CAPTRA_ZENOH_LISTEN")):
            with process("-m", "service", **variables | changed) as second:
                _, complaint = second.communicate(timeout=120)
                assert second.returncode == 1
                assert name in complaint
                assert (http_port if changed else port) in complaint
                assert "Traceback" not in complaint


@pytest.mark.parametrize(
    ("variables", "name"),
    [
        ({"CAPTRA_HTTP_PORT": "many"}, "http_port"),
        ({"CAPTRA_ZENOH_LISTEN": "tcp/127.0.0.1:1"}, "CAPTRA_ZENOH_LISTEN"),
        ({"CAPTRA_CONFIG": "/nowhere/captra.toml"}, "/nowhere/captra.toml"),
    ],
)
def test_wrong_settings_are_named(variables: dict[str, str], name: str) -> None:
    with process("-m", "service", **variables) as service:
        _, complaint = service.communicate(timeout=120)
        assert service.returncode == 2
        assert name in complaint
        assert "Traceback" not in complaint


def test_help_has_an_example() -> None:
    with process("-m", "service", "--help") as command:
        text, _ = command.communicate(timeout=120)
    assert command.returncode == 0
    assert "captra serve --port" in " ".join(text.split())

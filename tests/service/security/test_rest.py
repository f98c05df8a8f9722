"""Who may call the REST API."""

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jwt
import pytest
from cryptography.hazmat.primitives import serialization
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey

from service.security.access import sha256_of
from service.settings import ApiKey
from tests.service.support import Running, running, session_body

SIGNER = Ed25519PrivateKey.generate()
KEYS = (
    ApiKey(name="arm", sha256=sha256_of("arm-key")),
    ApiKey(name="screen", sha256=sha256_of("screen-key"), may="read"),
)


@pytest.fixture(scope="module")
def guarded(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    key_file: Path = tmp_path_factory.mktemp("keys") / "tokens.pem"
    key_file.write_bytes(
        SIGNER.public_key().public_bytes(serialization.Encoding.PEM, serialization.PublicFormat.SubjectPublicKeyInfo)
    )
    with running("mug", api_keys=KEYS, token_key_file=key_file) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


def token(**claims: Any) -> str:
    full = {"sub": "arm-2", "aud": "captra", "exp": time.time() + 3600, "scope": "captra:write"} | claims
    return jwt.encode({name: value for name, value in full.items() if value is not None}, SIGNER, "EdDSA")


def status(service: Running, method: str, path: str, bearer: str | None) -> tuple[int, str]:
    headers = {} if bearer is None else {b"Authorization": f"Bearer {bearer}".encode("latin-1")}
    body = session_body() if method == "POST" else None
    answer = service.http.request(method, path, headers=headers, json=body)
    if answer.status_code == 401:
        assert answer.headers["WWW-Authenticate"] == "Bearer"
    problem = answer.headers["Content-Type"] == "application/problem+json"
    return answer.status_code, answer.json()["reason"] if problem else ""


@pytest.mark.parametrize("bearer", ["arm-key", token(), token(scope="other captra:write")])
def test_writers_read_and_write(guarded: Running, bearer: str) -> None:
    assert status(guarded, "GET", "/v1/sessions", bearer) == (200, "")
    assert status(guarded, "POST", "/v1/sessions", bearer) == (201, "")


@pytest.mark.parametrize("bearer", ["screen-key", token(scope="captra:read")])
def test_readers_only_read(guarded: Running, bearer: str) -> None:
    assert status(guarded, "GET", "/metrics", bearer)[0] == 200
    assert status(guarded, "POST", "/v1/sessions", bearer) == (403, "forbidden")


STRANGERS = {
    "nobody": None,
    "wrong key": "arm-kez",
    "digest": sha256_of("arm-key"),
    "expired": token(exp=time.time() - 1),
    "endless": token(exp=None),
    "for another": token(aud="other"),
    "for nobody": token(aud=None),
    "nameless": token(sub=None),
    "unsigned": jwt.encode({"sub": "x", "aud": "captra", "exp": time.time() + 3600}, "", "none"),
    "signed by another": jwt.encode(
        {"sub": "x", "aud": "captra", "exp": time.time() + 3600, "scope": "captra:write"},
        Ed25519PrivateKey.generate(),
        "EdDSA",
    ),
    "odd": "ÿ.ÿ.ÿ",
}


@pytest.mark.parametrize("bearer", STRANGERS.values(), ids=STRANGERS.keys())
def test_strangers_are_asked_who_they_are(guarded: Running, bearer: str | None) -> None:
    count = guarded.service.telemetry.render().decode()
    for method, path in (("GET", "/v1/sessions"), ("POST", "/v1/sessions"), ("GET", "/metrics"), ("PUT", "/v2")):
        assert status(guarded, method, path, bearer) == (401, "unauthorized")
    assert guarded.service.telemetry.render().decode() != count


def test_scope_is_needed(guarded: Running) -> None:
    assert status(guarded, "GET", "/v1/sessions", token(scope=None)) == (403, "forbidden")


@pytest.mark.parametrize("path", ["/v1/health/live", "/v1/health/ready", "/docs", "/openapi.json"])
def test_probes_and_documents_are_open(guarded: Running, path: str) -> None:
    assert guarded.http.get(path).status_code == 200


def test_browsers_may_name_the_key_in_the_query(guarded: Running) -> None:
    assert guarded.http.get("/v1/sessions?access_token=screen-key").status_code == 200

"""The live page of a service that asks who calls."""

import json
from collections.abc import Callable, Iterator
from itertools import count

import httpx
import pytest
from playwright.sync_api import Page
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

from benchmarks.browser import until
from service.security.access import sha256_of
from service.settings import ApiKey
from tests.service.support import Camera, Running, f32, running, session_body, zenoh_client
from tests.service.viewer.looking import scene

KEYS = (
    ApiKey(name="arm", sha256=sha256_of("arm-key")),
    ApiKey(name="screen", sha256=sha256_of("screen-key"), may="read"),
)
REFUSED = "401"
"""What the browser's console says of requests without the right key."""


@pytest.fixture
def guarded() -> Iterator[Running]:
    with running("mug", api_keys=KEYS) as started:
        assert started.service.readiness.wait_prepared(60)
        yield started


def stream_of(service: Running, query: str = "") -> str:
    return str(service.http.base_url).replace("http", "ws") + "/viewer/stream" + query


def test_the_page_asks_for_a_key_until_it_is_right(guarded: Running, visit: Callable[..., Page]) -> None:
    page = visit(str(guarded.http.base_url), expected=REFUSED)
    page.wait_for_selector("#key[open] input")
    assert "send Authorization" in page.inner_text("#key")
    page.fill("#key input", "arm-kez")
    page.keyboard.press("Enter")
    until(page, "document.getElementById('key').innerText.includes('unknown')")
    assert page.inner_text("#link") != "live"
    page.fill("#key input", "arm-key")
    page.keyboard.press("Enter")
    page.wait_for_selector("#link.live")
    page.reload()
    page.wait_for_selector("#link.live")


def test_the_key_in_the_address_lets_the_page_place_a_box_that_is_fed(
    guarded: Running, visit: Callable[..., Page]
) -> None:
    page = visit(f"{guarded.http.base_url}/#key=arm-key")
    page.wait_for_selector("#link.live")
    assert "key" not in page.url
    with zenoh_client(guarded.endpoint) as network:
        camera = Camera(network, "captra/default/previews/wrist")
        camera.put(f32(scene()), seq=0)
        page.click("[data-preview=wrist]")
        until(page, "captra.points() > 4000")
        page.keyboard.press("n")
        for axis, value in zip("xyz", ("0", "0", "50"), strict=True):
            page.fill(f"[name=translation-{axis}]", value)
        page.click("#confirm")
        seqs = count(1)
        until(
            page,
            "document.getElementById('title').dataset.state === 'tracking' && captra.trail() > 0",
            meanwhile=lambda: camera.put(f32(scene()), seq=next(seqs)),
        )


def test_a_key_that_may_read_watches_and_no_more(guarded: Running, visit: Callable[..., Page]) -> None:
    answer = guarded.http.post("/v1/sessions", json=session_body(), headers={"Authorization": "Bearer arm-key"})
    page = visit(f"{guarded.http.base_url}/#key=screen-key", expected="403")
    until(page, "document.querySelector('[data-session].on') !== null")
    page.click("#close")
    until(page, "document.getElementById('toast').innerText.includes('screen may read only')")

    with connect(stream_of(guarded, "?access_token=screen-key")) as socket:
        socket.send(json.dumps({"type": "feed", "preview": "wrist", "session": answer.json()["session_id"]}))
        while (message := json.loads(socket.recv(10)))["type"] != "refused":
            pass
    assert "screen may watch only" in message["detail"]


@pytest.mark.parametrize("query", ["", "?access_token=arm-kez", "?access_token="])
def test_strangers_get_no_stream(guarded: Running, query: str) -> None:
    with pytest.raises(InvalidStatus) as refusal, connect(stream_of(guarded, query)):
        pass
    assert refusal.value.response.status_code == httpx.codes.FORBIDDEN


@pytest.mark.parametrize("path", ["/viewer/static/%2e%2e/recordings", "/viewer/static/%2e%2e/socket.py"])
def test_the_open_folder_leads_nowhere_else(guarded: Running, path: str) -> None:
    assert guarded.http.get(path).status_code == httpx.codes.NOT_FOUND


@pytest.mark.parametrize("path", ["/viewer/recordings", "/viewer/recordings/x.npz", "/viewer/stream"])
def test_strangers_get_no_recordings(guarded: Running, path: str) -> None:
    assert guarded.http.get(path).status_code == httpx.codes.UNAUTHORIZED


@pytest.mark.parametrize("path", ["/", "/viewer/static/app.js", "/viewer/static/LICENSES.txt"])
def test_the_page_itself_is_open(guarded: Running, path: str) -> None:
    assert guarded.http.get(path).status_code == httpx.codes.OK

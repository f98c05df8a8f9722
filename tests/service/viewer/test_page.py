"""What the live page draws, in a real browser against a running service."""

from collections.abc import Callable

import numpy as np
import pytest
from playwright.sync_api import Page, WebSocketRoute

from benchmarks.browser import until
from tests.service.support import Running, blob, f32
from tests.service.viewer.looking import (
    AMBER,
    BLUE,
    GREEN,
    RED,
    assert_boxes_drawn,
    canvas,
    corners_of,
    differing,
    pixels,
    project,
    scene,
)


def post(page: Page, service: Running, session_id: str, seqs: range) -> None:
    """Post the scene several times, at a rate at which the page shows every cloud."""
    for seq in seqs:
        assert service.post_frame(session_id, f32(scene()), seq=seq).status_code == 200
        page.wait_for_timeout(150)


def drawn_in(page: Page, selector: str, colour: tuple[int, int, int]) -> int:
    """How many pixels of an element have very nearly a colour."""
    off = np.abs(pixels(page.locator(selector).screenshot()) - colour)
    return int((off.max(axis=2) < 40).sum())


def settle(page: Page, seen: str) -> None:
    """Wait for something, look at the object from near, and let the page draw it."""
    until(page, seen)
    page.keyboard.press("f")
    page.wait_for_timeout(400)


def test_without_sessions_it_says_what_to_do(page: Page) -> None:
    assert "Play a recording" in page.inner_text("#empty")
    assert "None yet" in page.inner_text("#sessions")


def test_the_cloud_and_the_box_are_drawn_where_they_are(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    until(page, "document.querySelector('[data-session].on') !== null")
    blank = canvas(page)
    post(page, service, session_id, range(3))
    settle(page, "captra.points() > 4000 && captra.shown().length === 1")
    assert differing(canvas(page), blank) > 0.02, "the canvas is blank"

    (part,) = service.session(session_id)["last_result"]["parts"]
    expected = project(page, corners_of(part))
    np.testing.assert_allclose(page.evaluate("captra.corners()[0]"), expected, atol=1.0)
    assert_boxes_drawn(page, [part], GREEN)
    elsewhere = part | {"translation": [part["translation"][0] + 0.03, *part["translation"][1:]]}
    with pytest.raises(AssertionError, match="no edge"):
        assert_boxes_drawn(page, [elsewhere], GREEN)


def test_every_part_has_its_box_name_and_joint(page: Page, service: Running) -> None:
    session_id = service.open_session("laptop_articulated")["session_id"]
    until(page, "document.querySelector('[data-session].on') !== null")
    for seq in range(3):
        assert service.post_frame(session_id, f32(blob()), seq=seq).status_code == 200
        page.wait_for_timeout(150)
    settle(page, "captra.shown().length === 2")
    parts = service.session(session_id)["last_result"]["parts"]
    for drawn, part in zip(page.evaluate("captra.corners()"), parts, strict=True):
        np.testing.assert_allclose(drawn, project(page, corners_of(part)), atol=1.0)
    assert page.locator(".tag").all_inner_texts() == [part["name"] for part in parts]
    assert "°" in page.inner_text("#parts")
    page.add_style_tag(content="#parts { visibility: hidden }")  # numbers lie over the view, and so over an edge
    assert_boxes_drawn(page, parts, GREEN)


def test_a_track_that_is_lost_turns_amber_and_red_and_is_re_initialised(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    networks = service.provider.networks["mug"]
    post(page, service, session_id, range(2))
    networks.doubtful = True
    seen = {}
    for seq in range(2, 60):
        state = service.post_frame(session_id, f32(scene()), seq=seq).json()["state"]
        if state not in seen:
            until(page, f"document.getElementById('title').dataset.state === '{state}'")
            page.wait_for_timeout(300)
            page.keyboard.press("f")
            page.wait_for_timeout(300)
            seen[state] = service.session(session_id)["last_result"]["parts"]
            if state != "tracking":
                assert_boxes_drawn(page, seen[state], {"uncertain": AMBER, "lost": RED}[state])
        if state == "lost":
            break
    assert {"uncertain", "lost"} <= seen.keys()
    assert "re-initialise" in page.inner_text("#title")

    networks.doubtful = False
    page.keyboard.press("r")
    for axis, value in zip("xyz", ("0", "0", "50"), strict=True):
        page.fill(f"[name=translation-{axis}]", value)
    page.click("#confirm")
    page.wait_for_selector("#placing", state="hidden")
    post(page, service, session_id, range(3))
    settle(page, "document.getElementById('title').dataset.state === 'tracking'")
    assert_boxes_drawn(page, service.session(session_id)["last_result"]["parts"], GREEN)


def test_cards_are_not_replaced_under_a_finger(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    until(page, "document.querySelector('[data-session].on') !== null")
    page.evaluate("document.querySelector('[data-session]').dataset.touched = 'yes'")
    post(page, service, session_id, range(3))
    until(page, "!document.querySelector('[data-session]').innerText.includes(' 0 ms')")
    assert page.get_attribute("[data-session]", "data-touched") == "yes"


def test_the_trail_and_the_charts_grow(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    until(page, "document.querySelector('[data-session].on') !== null")
    page.wait_for_timeout(300)
    lines = {"confidence": GREEN, "latency": BLUE}
    assert [drawn_in(page, f"#{name} canvas", colour) for name, colour in lines.items()] == [0, 0]
    for seq in range(6):
        cloud = f32(blob((0.01 * seq, 0, 0.5)))
        assert service.post_frame(session_id, cloud, seq=seq).status_code == 200
        page.wait_for_timeout(100)
    until(page, "captra.trail() === 6")
    for name, colour in lines.items():
        assert drawn_in(page, f"#{name} canvas", colour) > 20, f"the chart of {name} is empty"
    last = service.session(session_id)["last_result"]
    assert page.inner_text("#confidence-now") == f"{last['confidence']:.2f}"
    assert page.inner_text("#latency-now") == f"{last['timing_ms']['total']:.0f} ms"


def test_a_session_that_is_closed_leaves_the_page(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    until(page, "document.querySelector('[data-session].on') !== null")
    page.click("#close")
    until(page, "document.querySelector('[data-session]') === null")
    assert "is closed" in page.inner_text("#toast")
    assert service.http.get(f"/v1/sessions/{session_id}").status_code == 404


def test_it_comes_back_when_the_connection_breaks(service: Running, visit: Callable[..., Page]) -> None:
    routes: list[WebSocketRoute] = []

    def passed_on(route: WebSocketRoute) -> None:
        routes.append(route)
        route.connect_to_server()

    page = visit(str(service.http.base_url), prepare=lambda page: page.route_web_socket("**/viewer/stream", passed_on))
    page.wait_for_selector("#link.live")
    routes[0].close()
    until(page, "document.getElementById('link').innerText === 'no connection'")
    page.wait_for_selector("#link.live")
    assert len(routes) == 2
    service.open_session()
    until(page, "document.querySelector('[data-session]') !== null")

"""Opening and re-initialising a session by placing a box on a cloud, as a hand with a mouse does it."""

from collections.abc import Iterator
from itertools import count

import numpy as np
import pytest
from playwright.sync_api import Page

from benchmarks.browser import until
from tests.service.support import Camera, Running, f32, zenoh_client
from tests.service.viewer.looking import eye, project, scene

HANDLE = 0.0899
"""Distance of a gizmo's handle from its middle, by that of the middle from the eye."""


@pytest.fixture
def camera(service: Running) -> Iterator[Camera]:
    with zenoh_client(service.endpoint) as network:
        yield Camera(network, "captra/default/previews/wrist")


@pytest.fixture
def placing(page: Page, camera: Camera) -> Page:
    """The page with a preview, on which a box was put by a click on the object."""
    preview = page.locator("[data-preview=wrist]")
    for _ in range(600):  # the first may go to the subscription of the page of the test before, which ends with it
        if preview.count():
            break
        camera.put(f32(scene()), seq=0)
        page.wait_for_timeout(100)
    preview.click()
    until(page, "captra.points() > 4000")
    page.keyboard.press("n")
    page.wait_for_selector("#confirm")
    x, y = page.evaluate("captra.project(0, 0, 0.45)")
    page.locator("#canvas").click(position={"x": x, "y": y})
    return page


def placed(page: Page) -> dict[str, np.ndarray]:
    (part,) = page.evaluate("captra.placed()")
    return {name: np.array(part[name]) for name in ("translation", "quat_xyzw", "size")}


def type_centre(page: Page, *centimetres: str) -> None:
    for axis, value in zip("xyz", centimetres, strict=True):
        page.fill(f"[name=translation-{axis}]", value)
    page.locator("[name=translation-z]").blur()


def drag(page: Page, start: np.ndarray, end: np.ndarray) -> None:
    """From a place to another (metres), with the mouse."""
    box = page.locator("#canvas").bounding_box()
    assert box is not None
    (x, y), (u, v) = project(page, np.stack([start, end])) + (box["x"], box["y"])
    page.mouse.move(x, y)
    page.wait_for_timeout(100)
    page.mouse.down()
    page.mouse.move((x + u) / 2, (y + v) / 2)
    page.mouse.move(u, v)
    page.mouse.up()


def handle(page: Page, middle: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Where the handle of an axis is, metres."""
    found: np.ndarray = middle + axis * HANDLE * np.linalg.norm(middle - eye(page))
    return found


def test_a_click_puts_the_box_on_the_object(placing: Page) -> None:
    assert np.linalg.norm(placed(placing)["translation"] - (0, 0, 0.5)) < 0.09
    assert placing.input_value("#category") == "mug"
    unknown = placing.locator("#category option[disabled]").all_inner_texts()
    assert "bottle (no model here)" in unknown


def test_it_opens_a_session_that_is_fed_and_can_be_re_initialised(
    placing: Page, service: Running, camera: Camera
) -> None:
    type_centre(placing, "0", "0", "52")
    placing.click("#confirm")
    session = until(placing, "document.querySelector('[data-session].on')?.dataset.session")
    opened = service.session(session)
    assert opened["category"] == "mug"
    np.testing.assert_allclose(opened["last_result"]["parts"][0]["translation"], (0, 0, 0.52), atol=1e-6)
    np.testing.assert_allclose(opened["last_result"]["parts"][0]["quat_xyzw"], (1, 0, 0, 0), atol=1e-6)

    seqs = count(1)
    until(
        placing,
        "captra.shown()[0]?.translation[2] < 0.51",
        meanwhile=lambda: camera.put(f32(scene()), seq=next(seqs)),
    )
    assert "tracking" in placing.inner_text("#title")
    (shown,) = placing.evaluate("captra.shown()")
    np.testing.assert_allclose(shown["translation"], (0, 0, 0.5), atol=0.005)

    placing.keyboard.press("r")
    placing.fill("[name=translation-x]", "3")
    placing.click("#confirm")
    placing.wait_for_selector("#placing", state="hidden")
    again = service.session(session)["last_result"]
    assert again["seq"] is None
    assert again["parts"][0]["translation"][0] == pytest.approx(0.03)


def test_what_is_typed_counts_when_the_button_is_pressed_at_once(placing: Page, service: Running) -> None:
    placing.fill("[name=translation-z]", "61.3")
    placing.fill("[name=size-x]", "12.3")
    placing.click("#confirm")
    session = until(placing, "document.querySelector('[data-session].on')?.dataset.session")
    (part,) = service.session(session)["last_result"]["parts"]
    assert part["translation"][2] == pytest.approx(0.613)
    assert part["size"][0] == pytest.approx(0.123)


def test_the_mouse_moves_it(placing: Page) -> None:
    type_centre(placing, "0", "0", "50")
    before = placed(placing)
    start = handle(placing, before["translation"], np.array([1.0, 0, 0]))
    drag(placing, start, start + (0.05, 0, 0))
    after = placed(placing)
    np.testing.assert_allclose(after["translation"], before["translation"] + (0.05, 0, 0), atol=0.004)
    np.testing.assert_allclose(after["size"], before["size"])


def test_the_mouse_turns_it(placing: Page) -> None:
    type_centre(placing, "0", "0", "50")
    before = placed(placing)
    placing.keyboard.press("2")
    middle, towards = before["translation"], eye(placing) - before["translation"]
    towards[0] = 0  # the nearest point of the ring about x
    start = handle(placing, middle, towards / np.linalg.norm(towards))
    drag(placing, start, start + np.cross((1, 0, 0), towards) * 0.05)
    after = placed(placing)
    turned = 2 * np.degrees(np.arccos(abs(before["quat_xyzw"] @ after["quat_xyzw"])))
    assert 5 < turned < 120
    np.testing.assert_allclose(after["quat_xyzw"][1:3], 0, atol=1e-6)  # about x alone, as it was before
    np.testing.assert_allclose(after["translation"], before["translation"], atol=1e-9)


def test_the_mouse_stretches_it(placing: Page) -> None:
    type_centre(placing, "0", "0", "50")
    before = placed(placing)
    placing.keyboard.press("3")
    start = handle(placing, before["translation"], np.array([1.0, 0, 0]))
    drag(placing, start, start + 0.5 * (start - before["translation"]))
    after = placed(placing)
    assert after["size"][0] / before["size"][0] == pytest.approx(1.5, abs=0.1)
    np.testing.assert_allclose(after["size"][1:], before["size"][1:])
    np.testing.assert_allclose(after["translation"], before["translation"], atol=1e-9)


def test_parts_are_placed_together_or_one_by_one(placing: Page) -> None:
    placing.select_option("#category", "laptop_articulated")
    before = placing.evaluate("captra.placed()")
    assert len(before) == 2
    x, y = placing.evaluate("captra.project(0.02, 0, 0.45)")
    placing.locator("#canvas").click(position={"x": x, "y": y})
    together = placing.evaluate("captra.placed()")
    shifts = [np.subtract(new["translation"], old["translation"]) for new, old in zip(together, before, strict=True)]
    np.testing.assert_allclose(shifts[0], shifts[1], atol=1e-9)
    placing.select_option("#part", "1")
    type_centre(placing, "1", "2", "60")
    one, other = placing.evaluate("captra.placed()")
    assert one == together[0]
    np.testing.assert_allclose(other["translation"], (0.01, 0.02, 0.6))


def test_it_can_be_left(placing: Page, service: Running) -> None:
    placing.keyboard.press("Escape")
    placing.wait_for_selector("#placing", state="hidden")
    assert service.http.get("/v1/sessions").json()["sessions"] == []

"""The live page in a real browser, against a running service."""

import io
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page

from captra.data.recordings import save_recording
from captra.geometry import box_corners
from tests.clients.sequences import drifting_mug
from tests.service.support import Camera, Running, blob, f32, zenoh_client
from tests.service.viewer.conftest import until

GREEN = (62, 207, 142)


def canvas(page: Page) -> np.ndarray[Any, Any]:
    """The pixels of the 3D view."""
    return np.asarray(Image.open(io.BytesIO(page.locator("#canvas").screenshot())).convert("RGB")).astype(int)


def wider(points: int = 4000) -> np.ndarray[Any, Any]:
    """A blob with something of a scene around it."""
    scene = np.random.default_rng(2).uniform((-0.3, -0.2, 0.7), (0.3, 0.2, 0.8), (points, 3))
    return np.concatenate([blob(), scene]).astype(np.float32)


def matrix(elements: list[float]) -> np.ndarray[Any, Any]:
    return np.array(elements).reshape(4, 4).T


def test_without_sessions_it_says_what_to_do(page: Page) -> None:
    assert "Play a recording" in page.inner_text("#empty")
    assert "None yet" in page.inner_text("#sessions")


def test_the_cloud_and_the_box_are_drawn_where_they_are(page: Page, service: Running) -> None:
    session_id = service.open_session()["session_id"]
    blank = canvas(page)
    until(page, "document.querySelector('[data-session].on') !== null")
    for seq in range(3):
        assert service.post_frame(session_id, f32(wider()), seq=seq).status_code == 200
        page.wait_for_timeout(150)
    until(page, "captra.points() > 4000")
    until(page, "captra.boxShown()")
    page.keyboard.press("f")
    page.wait_for_timeout(300)
    assert "mug" in page.inner_text("#sessions")
    assert "tracking" in page.inner_text("#sessions")

    drawn = canvas(page)
    assert np.abs(drawn - blank).max(axis=2).astype(bool).mean() > 0.02, "the canvas is blank"

    (part,) = service.session(session_id)["last_result"]["parts"]
    corners = box_corners(np.array(part["size"])) + part["translation"]  # the networks see it unturned
    camera = page.evaluate("captra.camera()")
    height, width = drawn.shape[:2]
    clip = np.c_[corners, np.ones(8)] @ (matrix(camera["projection"]) @ matrix(camera["world"])).T
    expected = (clip[:, :2] / clip[:, 3:] * (0.5, -0.5) + 0.5) * (width, height)
    np.testing.assert_allclose(page.evaluate("captra.corners()[0]"), expected, atol=1.0)
    edges = [(a, b) for a in range(8) for b in range(a) if (a ^ b).bit_count() == 1]
    for a, b in edges:
        u, v = np.rint((expected[a] + 2 * expected[b]) / 3).astype(int)
        around = drawn[v - 2 : v + 3, u - 2 : u + 3].reshape(-1, 3)
        greenest = (around[:, 1] - around[:, 0]).max()
        assert greenest > 40, f"no green at ({u}, {v}), where an edge of the box should be"


def test_a_box_placed_on_a_preview_opens_a_session_that_is_fed_and_can_be_re_initialised(
    page: Page, service: Running
) -> None:
    with zenoh_client(service.endpoint) as network:
        camera = Camera(network, "captra/default/previews/wrist")
        camera.put(f32(wider()), seq=0)
        page.click("#previews .card")
        until(page, "captra.points() > 4000")
        page.keyboard.press("n")
        page.wait_for_selector("#placing #confirm")
        x, y = page.evaluate("captra.project(0, 0, 0.45)")
        page.locator("#canvas").click(position={"x": x, "y": y})
        placed = page.evaluate("captra.parts()[0]")
        assert np.linalg.norm(np.array(placed["translation"]) - (0, 0, 0.5)) < 0.09, "the box is not where was clicked"
        for axis, value in enumerate(("0", "0", "52")):
            page.locator("#placing input").nth(axis).fill(value)
            page.locator("#placing input").nth(axis).blur()
        page.click("#confirm")
        session = until(page, "document.querySelector('[data-session].on')?.dataset.session")
        shown = service.session(session)
        assert shown["category"] == "mug"
        np.testing.assert_allclose(shown["last_result"]["parts"][0]["translation"], (0, 0, 0.52), atol=1e-6)
        np.testing.assert_allclose(shown["last_result"]["parts"][0]["quat_xyzw"], (1, 0, 0, 0), atol=1e-6)

        seqs = count(1)
        until(
            page,
            "captra.boxShown() && captra.shown()[0].translation[2] < 0.51",
            meanwhile=lambda: camera.put(f32(wider()), seq=next(seqs)),
        )
        assert "tracking" in page.inner_text("#title")
        (shown,) = page.evaluate("captra.shown()")
        np.testing.assert_allclose(shown["translation"], (0, 0, 0.5), atol=0.005)

        page.keyboard.press("r")
        page.locator("#placing input").nth(0).fill("3")
        page.locator("#placing input").nth(0).blur()
        page.click("#confirm")
        page.wait_for_selector("#placing", state="hidden")
        again = service.session(session)["last_result"]
        assert again["seq"] is None
        assert again["parts"][0]["translation"][0] == pytest.approx(0.03)


def test_a_dropped_recording_plays_to_its_end(page: Page, service: Running, tmp_path: Path) -> None:
    recording = drifting_mug()
    save_recording(tmp_path / "mug__drift.npz", recording)
    page.set_input_files("#file", tmp_path / "mug__drift.npz")
    page.wait_for_selector("#placing #confirm")
    (part,) = page.evaluate("captra.parts()")
    np.testing.assert_allclose(part["translation"], recording.init.translation[0], atol=1e-5)
    page.keyboard.press(" ")
    until(page, "document.getElementById('play').innerText.startsWith('Play again')")
    (session,) = service.http.get("/v1/sessions").json()["sessions"]
    assert session["counters"]["processed"] == len(recording)
    last = session["last_result"]
    assert last["stamp_ns"] == recording.stamps_ns[-1]
    until(page, "captra.trail() >= 3")


def test_what_is_served_was_built_from_what_is_here() -> None:
    import hashlib

    root = Path(__file__).parents[3]
    web, static = root / "web", root / "service/viewer/static"
    names = ["build.mjs", "icon.svg", "index.html", "package-lock.json", "package.json", "style.css", "tsconfig.json"]
    names += [f"src/{path.name}" for path in (web / "src").iterdir()]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(f"{name}\0".encode() + (web / name).read_bytes())
    stated = (static / "sources.sha256").read_text().strip()
    assert digest.hexdigest() == stated, "run npm ci && npm run build in web/, and commit what it writes"
    assert "three 0." in (static / "LICENSES.txt").read_text()

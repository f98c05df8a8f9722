"""Playing recordings on the page."""

from pathlib import Path

import numpy as np
from playwright.sync_api import Page

from benchmarks.browser import until
from captra.data.recordings import save_recording
from tests.clients.sequences import drifting_mug
from tests.service.support import Running


def test_a_recording_plays_to_its_end_and_again(page: Page, service: Running, tmp_path: Path) -> None:
    recording = drifting_mug()
    save_recording(tmp_path / "mug__drift.npz", recording)
    page.set_input_files("#file", tmp_path / "mug__drift.npz")
    page.wait_for_selector("#confirm")
    (part,) = page.evaluate("captra.placed()")
    np.testing.assert_allclose(part["translation"], recording.init.translation[0], atol=1e-5)
    page.keyboard.press(" ")
    until(page, "document.getElementById('play').innerText.startsWith('Play again')")
    (session,) = service.http.get("/v1/sessions").json()["sessions"]
    assert session["counters"]["processed"] == len(recording)
    assert session["last_result"]["stamp_ns"] == recording.stamps_ns[-1]
    until(page, "captra.trail() >= 3")
    page.keyboard.press(" ")
    until(page, "document.getElementById('play').innerText.startsWith('Pause')")
    until(page, "document.getElementById('play').innerText.startsWith('Play again')")
    assert service.session(session["session_id"])["counters"]["processed"] == 2 * len(recording)


def test_what_is_no_recording_is_told(page: Page, tmp_path: Path) -> None:
    (tmp_path / "notes.npz").write_text("not a recording")
    page.set_input_files("#file", tmp_path / "notes.npz")
    until(page, "document.getElementById('toast').className === 'on'")
    assert "is no recording" in page.inner_text("#toast")

"""Recordings of sessions play on the page whatever their frames are, and whoever recorded them."""

import threading
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.writer import Writer
from playwright.sync_api import Page

from benchmarks.browser import until
from captra.geometry import Pose
from clients import Box, Camera, DepthImage, Frame, Mask, PointCloud2, open_session
from clients.listening import listen_to
from clients.rest import RestApi
from service.viewer.previews import Previews
from service.viewer.summaries import overview
from tests.service.ros2.clouds import cdr
from tests.service.support import Running, blob, running

FRAME_NS = 20_000_000
FIRST_NS = 1_700_000_000_000_000_123
"""More digits than a number of JavaScript has."""
WIDTH, HEIGHT = 64, 48
CAMERA = Camera(fx=60, fy=60, cx=31.5, cy=23.5, width=WIDTH, height=HEIGHT)
START = Pose.from_size(np.eye(3)[None], np.array([[0.0, 0.0, 0.5]]), np.full((1, 3), 0.1))

Options = dict[str, Any]


def stamp(index: int) -> int:
    return FIRST_NS + FRAME_NS * index


def clouds() -> tuple[list[Frame], Options]:
    return [Frame(blob((0.004 * i, 0, 0.5)), stamp(i)) for i in range(5)], {"frame_id": "wrist", "encoding": "f32"}


def ros2_messages() -> tuple[list[Frame], Options]:
    organized = blob().reshape(10, 30, 3).copy()
    organized[3, 4:9] = np.nan
    odd = cdr(organized, (("z", "f8"), ("intensity", "f4"), ("y", "f4"), ("x", "f4")), pad=3, big_endian_data=True)
    return [Frame(PointCloud2(odd), stamp(i)) for i in range(4)], {}


def masked_images() -> tuple[list[Frame], Options]:
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    near = np.hypot(u - CAMERA.cx, v - CAMERA.cy) < 4.8
    image = DepthImage(np.where(near, 500, 3000).astype(np.uint16))
    regions = (Mask(near), Box(20, 12, 44, 36), None)
    return [Frame(image, stamp(i), region) for i, region in enumerate(regions)], {"camera": CAMERA, "masks": "object"}


@pytest.fixture
def recording(tmp_path: Path) -> Iterator[Running]:
    with running("mug", record_dir=tmp_path / "recorded", recordings_dir=tmp_path) as service:
        assert service.service.readiness.wait_prepared(120)
        yield service


@pytest.fixture
def page(recording: Running, visit: Callable[..., Page]) -> Page:
    opened = visit(str(recording.http.base_url))
    opened.wait_for_selector("#link.live")
    return opened


def play_to_the_end(page: Page, service: Running) -> dict[str, Any]:
    """The session that the page plays a recording into, once it is through."""
    page.wait_for_selector("#confirm")
    page.keyboard.press(" ")
    until(page, "document.getElementById('play').innerText.startsWith('Play again')")
    (session,) = service.http.get("/v1/sessions").json()["sessions"]
    found: dict[str, Any] = session
    return found


@pytest.mark.parametrize("made", [clouds, ros2_messages, masked_images])
def test_what_a_client_recorded_plays_as_it_was(
    page: Page, recording: Running, made: Callable[[], tuple[list[Frame], Options]], tmp_path: Path
) -> None:
    frames, options = made()
    path = tmp_path / "session.mcap"
    with open_session("mug", START, url=str(recording.http.base_url), record=path, **options) as session:
        *_, last = session.track(frames)
    page.set_input_files("#file", path)
    page.wait_for_selector("#confirm")
    shown = page.evaluate("captra.points()")
    assert shown == {clouds: 300, ros2_messages: 295, masked_images: WIDTH * HEIGHT}[made]
    played = play_to_the_end(page, recording)
    assert (played["counters"]["processed"], played["counters"]["rejected"]) == (len(frames), 0)
    result = played["last_result"]
    assert (result["stamp_ns"], result["frame_id"]) == (last.stamp_ns, last.frame_id)
    np.testing.assert_allclose(result["parts"][0]["translation"], last.parts[0].translation, atol=1e-6)


@pytest.fixture
def heard(recording: Running, tmp_path: Path) -> Path:
    """The file of `captra record`, of a session whose frames came by Zenoh."""
    url, folder, begun = str(recording.http.base_url), tmp_path / "heard", threading.Event()
    folder.mkdir()
    with closing(RestApi(url)) as api, open_session("mug", START, url=url) as session:
        listener = threading.Thread(target=listen_to, args=(api, [session.session_id], folder, lambda _: begun.set()))
        listener.start()
        assert begun.wait(20)
        list(session.track(clouds()[0]))
        session.close()
        listener.join()
    (path,) = folder.iterdir()
    return path


def test_what_captra_record_wrote_plays(page: Page, recording: Running, heard: Path) -> None:
    page.set_input_files("#file", heard)
    assert play_to_the_end(page, recording)["counters"]["processed"] == len(clouds()[0])


def test_what_the_service_recorded_is_listed_when_it_is_over_and_starts_again_where_it_did(
    page: Page, recording: Running
) -> None:
    elsewhere = Pose.from_size(START.rotation, START.translation + (0.3, 0, 0), START.size)
    with open_session("mug", START, url=str(recording.http.base_url), record_in_service=True) as session:
        for i in range(2):
            session.post(blob(), stamp(i))
        session.reset(elsewhere)
        for i in range(2, 5):
            session.post(blob((0.3, 0, 0.5)), stamp(i))
        page.wait_for_selector(f'[data-session="{session.session_id}"]')
    page.click(f'[data-recording="mug_{session.session_id}"]')
    played = play_to_the_end(page, recording)
    assert (played["counters"]["processed"], played["counters"]["rejected"]) == (5, 0)
    np.testing.assert_allclose(played["last_result"]["parts"][0]["translation"], (0.3, 0, 0.5), atol=2e-3)


def test_a_session_that_opened_and_ended_between_two_surveys_has_its_recording_listed(
    page: Page, recording: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    url, told = str(recording.http.base_url), "[data-recording^=mug_]"
    with monkeypatch.context() as held:
        before = overview(recording.service, Previews(recording.service))
        held.setattr("service.viewer.socket.overview", lambda service, previews: before)
        with open_session("mug", START, url=url, record_in_service=True) as session:
            session.post(blob(), stamp(0))
        assert page.locator(told).count() == 0
    page.wait_for_selector(told)
    assert session.session_id in str(page.get_attribute(told, "data-recording"))
    assert recording.http.delete(f"/v1/recordings/mug_{session.session_id}").status_code == 204
    until(page, f"document.querySelector('{told}') === null")


def test_a_file_without_a_session_is_told(page: Page, tmp_path: Path) -> None:
    path = tmp_path / "other.mcap"
    with path.open("wb") as file:
        writer = Writer(file)
        writer.start()
        writer.finish()  # type: ignore[no-untyped-call]
    page.set_input_files("#file", path)
    until(page, "document.getElementById('toast').className === 'on'")
    assert "other is no recording of a session" in page.inner_text("#toast")

"""A real browser for the live page."""

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page

from benchmarks.browser import PATIENCE_S, NoBrowserError, chromium
from tests.service.support import Running


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    try:
        with chromium() as launched:
            yield launched
    except NoBrowserError as error:
        pytest.skip(str(error))


@pytest.fixture
def visit(browser: Browser) -> Iterator[Callable[..., Page]]:
    """Opens a page; whatever goes wrong in its scripts fails the test, but for answers that are expected.

    To be asked for after the service, so that pages are closed before it ends.
    """
    opened: list[Page] = []
    complaints: list[str] = []

    def open_page(url: str, expected: str = "", prepare: Callable[[Page], object] = lambda page: None) -> Page:
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.on(
            "console",
            lambda message: (
                complaints.append(message.text)
                if message.type == "error" and not (expected and expected in message.text)
                else None
            ),
        )
        page.set_default_timeout(1e3 * PATIENCE_S)
        prepare(page)
        page.goto(url)
        opened.append(page)
        return page

    yield open_page
    for page in opened:
        page.close()
    assert complaints == []


@pytest.fixture
def page(service: Running, visit: Callable[..., Page]) -> Page:
    opened = visit(str(service.http.base_url))
    opened.wait_for_selector("#link.live")
    return opened

"""A real browser for the live page: Debian's Chromium, or whatever CAPTRA_CHROMIUM names, drawing in software."""

import os
import shutil
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from tests.service.support import Running

ARGUMENTS = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
WITHIN_S = 20.0


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    names = (os.environ.get("CAPTRA_CHROMIUM", ""), "chromium", "chromium-browser", "google-chrome")
    found = next((path for name in names if name and (path := shutil.which(name))), None)
    assert found, "the live page is tested in a browser: apt-get install chromium, or set CAPTRA_CHROMIUM to one"
    with sync_playwright() as playwright:
        launched = playwright.chromium.launch(executable_path=found, args=ARGUMENTS)
        yield launched
        launched.close()


@pytest.fixture
def page(browser: Browser, service: Running) -> Iterator[Page]:
    opened = browser.new_page(viewport={"width": 1280, "height": 800})
    complaints: list[str] = []
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("console", lambda message: complaints.append(message.text) if message.type == "error" else None)
    opened.goto(str(service.http.base_url))
    opened.wait_for_selector("#link.live", timeout=1e3 * WITHIN_S)
    yield opened
    opened.close()
    assert complaints == []


def until(page: Page, expression: str, meanwhile: Callable[[], object] = lambda: None) -> Any:
    """The value of an expression on the page, once it is true there."""
    deadline = time.monotonic() + WITHIN_S
    while not (value := page.evaluate(expression)):
        assert time.monotonic() < deadline, f"never became true: {expression}"
        meanwhile()
        page.wait_for_timeout(50)
    return value

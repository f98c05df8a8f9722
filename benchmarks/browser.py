"""A headless browser for the live page: Chromium as it is installed, or the one that Playwright brings.

python -m benchmarks.browser     # fetches one where none is
"""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from typing import Any

from playwright.sync_api import Browser, Error, Page, Playwright, sync_playwright

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox")
"""WebGL without a graphics card, and as root."""
PATIENCE_S = 60.0
"""How long a busy machine may take to draw something."""

APT = "DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends chromium"
FETCH = (
    f'[ "$(id -u)" = 0 ] && apt-get update -qq && {APT}',
    f"{sys.executable} -m playwright install --only-shell chromium",
)
"""Shell commands that may bring one: as root from the distribution, otherwise from Playwright."""


class NoBrowserError(RuntimeError):
    """No Chromium is here; says how to get one."""


@contextmanager
def chromium() -> Iterator[Browser]:
    """A running browser.

    Raises:
        NoBrowserError: none is installed, or it does not start.
    """
    with sync_playwright() as playwright, closing(launch(playwright)) as browser:
        yield browser


def launch(playwright: Playwright) -> Browser:
    """The first of CAPTRA_CHROMIUM, Chromium on the path, and Playwright's own that starts.

    Raises:
        NoBrowserError: none is installed, or none starts.
    """
    names = (os.environ.get("CAPTRA_CHROMIUM", ""), *NAMES, playwright.chromium.executable_path)
    complaints = []
    for path in (found for name in names if name and (found := shutil.which(name))):
        try:
            return playwright.chromium.launch(executable_path=path, args=SOFTWARE)
        except Error as error:
            complaints.append(f"{path} does not start: {error.message.splitlines()[0]}")
    advice = "`make browser` fetches one, or set CAPTRA_CHROMIUM"
    raise NoBrowserError("; ".join([*complaints, f"no browser is here that could show the live page: {advice}"]))


def main() -> None:
    """Fetch a browser where none is: the distribution's for root, otherwise Playwright's."""
    for fetch in (None, *FETCH):
        if fetch is not None and subprocess.run(fetch, shell=True, check=False).returncode != 0:
            continue
        try:
            with chromium() as browser:
                print(f"the live page is tested in Chromium {browser.version}")
                return
        except NoBrowserError as error:
            print(error, flush=True)
    print("the tests of the live page will be skipped")


def until(page: Page, expression: str, meanwhile: Callable[[], object] = lambda: None) -> Any:
    """The value of an expression on the page, once it is true there; `meanwhile` is called again and again.

    Raises:
        TimeoutError: it does not become true.
    """
    deadline_s = time.monotonic() + PATIENCE_S
    while not (value := page.evaluate(expression)):  # the page's policy forbids it to poll for itself
        if time.monotonic() > deadline_s:
            raise TimeoutError(f"never became true: {expression}")
        meanwhile()
        page.wait_for_timeout(50)
    return value


if __name__ == "__main__":
    main()

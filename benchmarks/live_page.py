"""Takes the pictures of the live page, in a browser, of a service that tracks the bundled recordings.

python -m benchmarks.live_page docs/images
"""

from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

import typer
from playwright.sync_api import Page

from benchmarks.browser import PATIENCE_S, chromium, until
from captra.data.recordings import load_recording
from clients import open_session
from clients.service_process import ServiceProcess

ROOT = Path(__file__).resolve().parents[1]
PLAYED = "mug__sweethome3d-KatorLegaz__coffee-mug__hand"
BESIDE = ("can__osrf_gazebo__coke_can__table", "scissors__sweethome3d-BlendSwap-CC-0__cissors_swap__hand")
PLACED = "can__osrf_gazebo__coke_can__table"
FRAMES = 20
SETTLED_MS = 1500


def main(out: Annotated[Path, typer.Argument(help="Folder of the pictures.")]) -> None:
    """live_page.png: a recording plays, two sessions beside it. placing.png: a box before its session is opened."""
    with ExitStack() as stack:
        service = stack.enter_context(ServiceProcess({"CAPTRA_MODELS_DIR": str(ROOT / "models")}))
        for name in BESIDE:
            recording = load_recording(ROOT / "recordings" / f"{name}.npz")
            session = stack.enter_context(open_session(recording.category.name, recording.init, url=service.url))
            for _ in session.track(recording.clouds[:FRAMES]):
                pass
        page = stack.enter_context(chromium()).new_page(viewport={"width": 1440, "height": 860})
        page.set_default_timeout(1e3 * PATIENCE_S)
        page.goto(service.url)
        take_playing(page, out / "live_page.png")
        take_placing(page, out / "placing.png")
    print(f"live_page.png and placing.png are in {out}")


def take_playing(page: Page, out: Path) -> None:
    """The page while the mug's recording plays, seen from near."""
    page.click(f'[data-recording="{PLAYED}"]')
    page.wait_for_selector("#confirm")
    page.keyboard.press("Space")
    until(page, "captra.trail() > 20")
    page.keyboard.press("f")
    until(page, "captra.frame() >= 45")
    page.screenshot(path=out)


def take_placing(page: Page, out: Path) -> None:
    """The first pose of another recording, with the handles that move it."""
    page.click(f'[data-recording="{PLACED}"]')
    page.wait_for_selector("#confirm")
    page.keyboard.press("f")
    page.mouse.move(0, 0)
    page.wait_for_timeout(SETTLED_MS)
    page.screenshot(path=out)


if __name__ == "__main__":
    typer.run(main)

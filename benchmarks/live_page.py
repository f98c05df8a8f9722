"""Takes the picture of the live page: the bundled mug, played on the page itself, with two more sessions beside it.

python benchmarks/live_page.py docs/images/live_page.png
"""

from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

import typer

from benchmarks.browser import chromium, until
from captra.data.recordings import load_recording
from clients import open_session
from clients.service_process import ServiceProcess

ROOT = Path(__file__).resolve().parents[1]
PLAYED = "mug__sweethome3d-KatorLegaz__coffee-mug__hand"
BESIDE = ("can__osrf_gazebo__coke_can__table", "scissors__sweethome3d-BlendSwap-CC-0__cissors_swap__hand")
FRAMES = 20
PATIENCE_S = 120.0


def main(
    out: Annotated[Path, typer.Argument(help="PNG file.")],
    frames: Annotated[int, typer.Option(help="How far the recording is played.")] = 45,
) -> None:
    """Play, look, take the picture."""
    with ExitStack() as stack:
        service = stack.enter_context(ServiceProcess({"CAPTRA_MODELS_DIR": str(ROOT / "models")}))
        for name in BESIDE:
            recording = load_recording(ROOT / "recordings" / f"{name}.npz")
            session = stack.enter_context(open_session(recording.category.name, recording.init, url=service.url))
            for _ in session.track(recording.clouds[:FRAMES]):
                pass
        browser = stack.enter_context(chromium())
        page = browser.new_page(viewport={"width": 1440, "height": 860})
        page.goto(service.url)
        page.click(f'[data-recording="{PLAYED}"]', timeout=1e3 * PATIENCE_S)
        page.wait_for_selector("#confirm")
        page.keyboard.press("Space")
        until(page, "captra.trail() > 20", PATIENCE_S)
        page.keyboard.press("f")
        until(page, f"captra.frame() >= {frames}", PATIENCE_S)
        page.screenshot(path=out)
    print(f"{out} is there")


if __name__ == "__main__":
    typer.run(main)

"""The page itself and the recordings that it offers to play."""

from pathlib import Path
from urllib.parse import quote

from fastapi import FastAPI
from fastapi.responses import FileResponse
from starlette.staticfiles import StaticFiles

from service.recording.folder import Recordings

STATIC = Path(__file__).parent / "static"
HEADERS = {
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data:; style-src 'self' 'unsafe-inline'",
    "Cache-Control": "no-cache",
}
"""Nothing comes from elsewhere; the styles that three.js and uPlot set on elements are inline."""


def install(app: FastAPI, recordings_dir: Path, recorded: Recordings) -> None:
    """Serve the page at `/` and what it needs below `/viewer`; only recordings tell anything of this service.

    Args:
        app: of the service.
        recordings_dir: files that the operator offers to play, *.npz and *.mcap.
        recorded: sessions that the service itself has recorded.
    """

    @app.get("/", include_in_schema=False)
    async def page() -> FileResponse:
        return FileResponse(STATIC / "index.html", headers=HEADERS)

    @app.get("/viewer/recordings", include_in_schema=False)
    def recordings() -> list[dict[str, str]]:
        offered = sorted(path.name for path in recordings_dir.glob("*.*") if path.suffix in {".npz", ".mcap"})
        finished = [each.name for each in recorded.all() if each.finished]
        return [
            *({"name": name.removesuffix(".npz"), "path": f"/viewer/recordings/{quote(name)}"} for name in offered),
            *({"name": name, "path": f"/v1/recordings/{name}"} for name in finished),
        ]

    app.mount("/viewer/recordings", StaticFiles(directory=recordings_dir, check_dir=False))
    app.mount("/viewer/static", StaticFiles(directory=STATIC))

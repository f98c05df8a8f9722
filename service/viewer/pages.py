"""The page itself and the recordings that it offers to play."""

from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import FileResponse
from starlette.staticfiles import StaticFiles

STATIC = Path(__file__).parent / "static"
HEADERS = {
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data:; style-src 'self' 'unsafe-inline'",
    "Cache-Control": "no-cache",
}
"""Nothing comes from elsewhere; the styles that three.js and uPlot set on elements are inline."""


def install(app: FastAPI, recordings_dir: Path) -> None:
    """Serve the page at `/` and what it needs below `/viewer`; only recordings tell anything of this service."""

    @app.get("/", include_in_schema=False)
    async def page() -> FileResponse:
        return FileResponse(STATIC / "index.html", headers=HEADERS)

    @app.get("/viewer/recordings", include_in_schema=False)
    async def recordings() -> list[dict[str, str | int]]:
        files = sorted(recordings_dir.glob("*.npz")) if recordings_dir.is_dir() else []
        return [{"name": path.stem, "bytes": path.stat().st_size} for path in files]

    app.mount("/viewer/recordings", StaticFiles(directory=recordings_dir, check_dir=False))
    app.mount("/viewer/static", StaticFiles(directory=STATIC))

"""The bundle that is served was built from the sources that are here."""

import hashlib
from pathlib import Path

ROOT = Path(__file__).parents[3]
WEB, STATIC = ROOT / "web", ROOT / "service/viewer/static"
SOURCES = ("build.mjs", "icon.svg", "index.html", "package-lock.json", "package.json", "style.css", "tsconfig.json")


def test_the_bundle_was_built_from_these_sources() -> None:
    digest = hashlib.sha256()
    for name in sorted([*SOURCES, *(f"src/{path.name}" for path in (WEB / "src").iterdir())]):
        digest.update(f"{name}\0".encode() + (WEB / name).read_bytes())
    stated = (STATIC / "sources.sha256").read_text().strip()
    assert digest.hexdigest() == stated, "run npm ci && npm run build in web/, and commit what it writes"


def test_it_comes_with_the_licences_of_what_it_holds_and_asks_nobody_else() -> None:
    licences = (STATIC / "LICENSES.txt").read_text()
    for name in ("three 0.", "uplot 1.", "@fontsource-variable/inter 5."):
        assert name in licences
    for file in ("index.html", "app.css"):
        text = (STATIC / file).read_text()
        assert "http://" not in text.replace("http://www.w3.org", "")
        assert "https://" not in text

"""What a checkpoint says about where it comes from."""

import json
import re
import subprocess
from pathlib import Path
from typing import Any


def provenance(*views: Path) -> dict[str, Any]:
    """The commit that trains, and the library meshes that were mixed into the views of the folders."""
    return {"commit": _commit(), "meshes": [credit for folder in views for credit in _credits(folder / "sources.json")]}


def _commit() -> str:
    command = ["git", "-C", str(Path(__file__).parent), "rev-parse", "HEAD"]
    try:
        return subprocess.run(command, capture_output=True, check=True, text=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def _credits(sources: Path) -> list[dict[str, str]]:
    if not sources.exists():
        return []
    credits_of = json.loads(sources.read_text())
    return [
        {"name": name, "license": re.sub(r" *\(.*\)", "", licence), "attribution": _author(name, licence)}
        for name, licence in credits_of.items()
    ]


def _author(name: str, licence: str) -> str:
    """Named in brackets behind the licence, or else the collection the mesh is from."""
    named = re.search(r"\((.*)\)", licence)
    return named.group(1) if named else Path(name).name.partition("__")[0]

"""What a checkpoint says about where it comes from."""

import json
import subprocess
from pathlib import Path
from typing import Any

from captra.data.credits import Credit


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
    read = {name: Credit.read(text) for name, text in json.loads(sources.read_text()).items()}
    return [
        {"name": name, "license": credit.licence, "attribution": credit.author or _collection(name)}
        for name, credit in read.items()
    ]


def _collection(name: str) -> str:
    """That the mesh is from, which is all that is known of it without an author."""
    return Path(name).name.partition("__")[0]

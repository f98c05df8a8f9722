"""Entries of a manifest that no checkpoint knows: what was trained on, scores, calibration."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from captra.runtime.bundle import BundleError, Manifest
from export.bundles import unchanged

SETTABLE = (
    "training",
    "scores",
    "health",
    "found_error",
    "input_sampling",
    "rotation_input",
    "rotation_fusion",
    "joint_projection",
    "mirror",
)


def with_notes(path: Path | None) -> Callable[[Manifest], Manifest]:
    """A function that sets a JSON file's entries in a manifest; objects are merged one level deep.

    Raises:
        BundleError: the file is no JSON object, or names an entry that is not for people to set.
    """
    if path is None:
        return unchanged
    try:
        notes = json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise BundleError(f"{path} is no JSON: {error}") from error
    unknown = sorted(set(notes) - set(SETTABLE)) if isinstance(notes, dict) else [str(notes)]
    if unknown:
        raise BundleError(f"{path} sets {', '.join(unknown)}: only {', '.join(SETTABLE)} can be set")

    def describe(manifest: Manifest) -> Manifest:
        content: dict[str, Any] = json.loads(manifest.to_json())
        for name, value in notes.items():
            content[name] = {**content[name], **value} if isinstance(value, dict) else value
        return Manifest.from_json(json.dumps(content))

    return describe

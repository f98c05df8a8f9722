"""Where what comes with the code is: links beside this file in a working tree, folders in an installed package."""

from pathlib import Path

HERE = Path(__file__).resolve().parent
MODELS = (HERE / "models").resolve()
"""Bundles, one folder a category."""
RECORDINGS = (HERE / "recordings").resolve()
"""Recordings: of an installed package the one that the demo plays, of a working tree some more."""

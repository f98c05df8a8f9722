"""Fuzzing led by coverage starts, and what it found so far are no defects."""

import subprocess
import sys
from pathlib import Path

import pytest

SECONDS = 5


def test_nothing_but_refusals_for_some_seconds(tmp_path: Path) -> None:
    pytest.importorskip("atheris", reason="pip install '.[fuzz]'")
    found = tmp_path / "found"
    command = ["-m", "benchmarks.fuzz", "--seconds", str(SECONDS), "--found", str(found)]
    done = subprocess.run([sys.executable, *command], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    assert "DONE" in done.stderr or "Done" in done.stderr, done.stderr
    assert list(found.iterdir()) == []

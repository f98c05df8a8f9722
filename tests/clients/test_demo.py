"""The demo as a person runs it: its own process, a service of its own, the networks that ship."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from captra.data.recordings import load_recording
from clients.demo import COFFEE_MUG
from tests.clients.sequences import first_frames, saved

ROOT = Path(__file__).parents[2]


def run_demo(*options: str, **settings: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "captra", "demo", *options],
        cwd=ROOT,
        env=os.environ | settings,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )


def test_the_demo_holds_its_track() -> None:
    ended = run_demo("--as-fast-as-possible")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "60 / 60" in ended.stdout
    for measure in ("frames sent / answered", "rotation error", "translation error", "5°5cm", "IoU", "p50 / p95 / p99"):
        assert measure in ended.stdout
    assert ended.stdout.rstrip().endswith("The track held.")


@pytest.mark.parametrize("pace", ["--as-fast-as-possible", "--realtime"])
def test_the_demo_admits_that_it_lost_the_track(untrained_models: Path, tmp_path: Path, pace: str) -> None:
    recording = saved(first_frames(load_recording(COFFEE_MUG), 12), tmp_path)
    ended = run_demo(pace, "--recording", str(recording), CAPTRA_MODELS_DIR=str(untrained_models))
    assert ended.returncode == 1, ended.stdout + ended.stderr
    assert "frames sent / answered" in ended.stdout
    assert "The track did not hold: " in ended.stdout


def test_the_demo_says_why_its_service_does_not_start() -> None:
    ended = run_demo(CAPTRA_PROFILE="huge")
    assert ended.returncode == 1
    assert "the service ended with status 2" in ended.stderr
    assert "Traceback" not in ended.stderr

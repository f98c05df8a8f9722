"""compose.yaml and the systemd unit agree with the image, the routers and the settings."""

import re
import shutil
import subprocess
from configparser import RawConfigParser
from pathlib import Path
from typing import Any

import pytest
import yaml

from docker.dockerfile import read
from service.settings import Settings

ROOT = Path(__file__).parents[2]
UNIT = ROOT / "deploy" / "systemd" / "captra.service"
SERVICES: dict[str, dict[str, Any]] = yaml.safe_load((ROOT / "compose.yaml").read_text())["services"]
SETTINGS = {f"CAPTRA_{name.upper()}" for name in Settings.model_fields}


def filled_in(text: str) -> str:
    """Compose's ${NAME:-default}, with nothing set."""
    return re.sub(r"\$\{\w+:-([^}]*)\}", r"\1", text)


def test_compose_runs_the_image_without_rights(monkeypatch: pytest.MonkeyPatch) -> None:
    captra = SERVICES["captra"]
    assert captra["read_only"] is True
    assert captra["cap_drop"] == ["ALL"]
    image = read((ROOT / "Dockerfile").read_text(), captra["build"]["args"])[-1]
    assert captra["volumes"] == [f"state:{image.volumes[0]}"]
    for name, value in captra["environment"].items():
        assert name in SETTINGS
        monkeypatch.setenv(name, filled_in(value))
    assert Settings().zenoh_advertise == ("tcp/127.0.0.1:7447",)


def test_the_router_of_compose_finds_captra_by_its_name() -> None:
    router = SERVICES["zenoh"]
    (volume,) = router["volumes"]
    file, inside, _ = volume.split(":")
    assert router["command"] == f"--config {inside}"
    assert f'"tcp/{next(iter(SERVICES))}:7447"' in (ROOT / file).read_text()


def test_compose_takes_the_release_of_zenoh_that_is_tested_here() -> None:
    from importlib.metadata import version

    ours, theirs = version("eclipse-zenoh"), SERVICES["zenoh"]["image"].partition(":")[2]
    assert theirs.split(".")[0] == ours.split(".")[0]


def check_with_systemd(text: str, folder: Path) -> None:
    """Ask systemd, where it is installed; the rest of the test holds anywhere."""
    if shutil.which("systemd-analyze") is not None:
        unit = folder / UNIT.name
        unit.write_text(re.sub(r"^ExecStart=.*$", "ExecStart=/bin/true", text, flags=re.MULTILINE))
        done = subprocess.run(["systemd-analyze", "verify", str(unit)], capture_output=True, text=True, check=False)
        assert unit.name not in done.stderr, done.stderr


def test_the_unit_sets_what_the_service_knows_and_writes_to_its_own_folders(tmp_path: Path) -> None:
    text = UNIT.read_text()
    check_with_systemd(text, tmp_path)
    assert set(re.findall(r"CAPTRA_\w+", text)) <= SETTINGS
    unit = RawConfigParser(strict=False)
    unit.read_string(text)
    assert unit["Service"]["ExecStart"].endswith("captra serve")
    assert f"CAPTRA_STATE_DIR=/var/lib/{unit['Service']['StateDirectory']}\n" in text
    assert f"NUMBA_CACHE_DIR=/var/cache/{unit['Service']['CacheDirectory']}\n" in text
    assert unit["Service"]["DynamicUser"] == "true"

"""compose.yaml and the systemd unit agree with the image, the routers and the settings."""

import json
import re
import shutil
import subprocess
import tomllib
from configparser import RawConfigParser
from pathlib import Path
from typing import Any

import pytest
import yaml

from docker.dockerfile import read
from service.security.wiring import ExposedError, check_exposure
from service.settings import ApiKey, Settings

ROOT = Path(__file__).parents[2]
UNIT = ROOT / "deploy" / "systemd" / "captra.service"
SERVICES: dict[str, dict[str, Any]] = yaml.safe_load((ROOT / "compose.yaml").read_text())["services"]
SETTINGS = {f"CAPTRA_{name.upper()}" for name in Settings.model_fields}


EXTRAS = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]


def filled_in(text: str, **chosen: str) -> str:
    """Compose's ${NAME:-default}, with nothing set but what is chosen."""
    return re.sub(r"\$\{(\w+):-([^}]*)\}", lambda match: chosen.get(match[1]) or match[2], text)


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


def settings_in_compose(monkeypatch: pytest.MonkeyPatch, **chosen: str) -> Settings:
    """Of the service that compose starts, where the shell has set what is chosen."""
    captra = SERVICES["captra"]
    image = read((ROOT / "Dockerfile").read_text(), captra["build"]["args"])[-1]
    ours = {name: filled_in(value, **chosen) for name, value in captra["environment"].items()}
    with monkeypatch.context() as environment:
        for name, value in {**image.environment, **ours}.items():
            environment.setenv(name, value)
        return Settings()


def test_compose_is_guarded_by_the_keys_that_it_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    key = {"name": "arm", "sha256": "0" * 64}
    guarded = settings_in_compose(monkeypatch, CAPTRA_ALLOW_OPEN="false", CAPTRA_API_KEYS=json.dumps([key]))
    assert guarded.api_keys == (ApiKey(name="arm", sha256="0" * 64),)
    check_exposure(guarded)
    for keys in ("", "[]"):
        with pytest.raises(ExposedError, match="api_keys"):
            check_exposure(settings_in_compose(monkeypatch, CAPTRA_ALLOW_OPEN="false", CAPTRA_API_KEYS=keys))
    check_exposure(settings_in_compose(monkeypatch))


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
    (installed,) = re.findall(r"pip install --editable '\.\[(.*)\]'", text)
    assert {"cpu", "secure"} == set(installed.split(",")) <= set(EXTRAS)

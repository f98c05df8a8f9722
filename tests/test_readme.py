"""What the README shows is what happens."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import tests.test_house as house
from tests.service.support import running

ROOT = house.ROOT
README = (ROOT / "README.md").read_text()
SNIPPETS = re.findall(r"^```python\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


@pytest.fixture
def service_url() -> Iterator[str]:
    with running("mug") as started:
        assert started.service.readiness.wait_prepared(30)
        yield str(started.http.base_url)


def test_there_are_snippets() -> None:
    assert len(SNIPPETS) >= 2


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_snippets_run(
    snippet: str, service_url: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("CAPTRA_URL", service_url)
    exec(compile(snippet, "README.md", "exec"), {})
    if "print(" in snippet:
        assert len(capsys.readouterr().out.splitlines()) > 5


def test_every_command_it_names_exists() -> None:
    named = set(re.findall(r"`captra (\w+)", README))
    assert named <= set(house.COMMANDS)
    assert set(house.COMMANDS) - named <= {"demo", "serve"}, "these are shown as make targets"


def test_every_make_target_it_names_exists() -> None:
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    assert set(re.findall(r"\bmake (\w+)", README.replace("make and", ""))) <= targets


def test_every_file_it_links_to_is_there() -> None:
    linked = [target for target in re.findall(r"\]\(([^)]+)\)", README) if "://" not in target]
    assert [target for target in linked if not Path(ROOT, target).is_file()] == []


def test_every_setting_it_names_is_one() -> None:
    from service.settings import Settings

    known = {f"CAPTRA_{name.upper()}" for name in Settings.model_fields} | {"CAPTRA_URL"}
    assert set(re.findall(r"CAPTRA_[A-Z_]*[A-Z]", README)) <= known

"""The Dockerfile does what its scripts do, with files that are there, as a user without rights."""

import fnmatch
import os
import shlex
from pathlib import Path

import pytest

from docker.dockerfile import Copy, DockerfileError, Run, Stage, read
from service.settings import Settings

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "Dockerfile").read_text()
STAGES = read(TEXT, {"RUNTIME": "openvino"})
IMAGE = STAGES[-1]


def copies() -> list[Copy]:
    return [step for stage in STAGES for step in stage.steps if isinstance(step, Copy) and step.stage is None]


def test_every_run_is_a_script_of_the_project() -> None:
    commands = [shlex.split(step.command)[0] for stage in STAGES for step in stage.steps if isinstance(step, Run)]
    assert len(commands) == 5
    for command in commands:
        script = ROOT / command.removeprefix("/source").lstrip("/")
        assert script.is_file()
        assert os.access(script, os.X_OK)


def test_what_is_copied_is_there_and_reaches_the_engine() -> None:
    let_through = [line[1:] for line in (ROOT / ".dockerignore").read_text().splitlines() if line.startswith("!")]
    for source in (source for step in copies() for source in step.sources):
        assert (ROOT / source).exists()
        assert any(fnmatch.fnmatch(source.partition("/")[0], name) for name in let_through), source


def test_the_image_holds_no_installer_and_runs_without_rights() -> None:
    assert {step.stage for step in IMAGE.steps if isinstance(step, Copy)} == {"build", None}
    assert [stage.name for stage in STAGES if any("installer" in str(step) for step in stage.steps)] == ["build"]
    assert IMAGE.base == "python"
    assert 0 not in map(int, IMAGE.user.split(":"))


def test_its_variables_are_settings_that_the_service_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    ours = {name: value for name, value in IMAGE.environment.items() if name.startswith("CAPTRA_")}
    assert {name.removeprefix("CAPTRA_").lower() for name in ours} <= set(Settings.model_fields)
    for name, value in ours.items():
        monkeypatch.setenv(name, value)
    settings = Settings()
    assert str(settings.state_dir) == IMAGE.volumes[0]
    assert settings.zenoh_listen == ("tcp/0.0.0.0:7447",)


def test_build_arguments_reach_their_stage_alone() -> None:
    assert [stage.environment.get("RUNTIME") for stage in STAGES] == [None, "openvino", None]


@pytest.mark.parametrize("line", ["ADD x /x", "COPY --chmod=755 x /x", "FROM a b c"])
def test_what_is_not_understood_is_refused(line: str) -> None:
    with pytest.raises(DockerfileError):
        read(f"FROM debian\n{line}\n", {})


def test_continued_lines_are_one_instruction() -> None:
    (stage,) = read("FROM debian\n# two\nENV A=1 \\\n    B='2 3'\nHEALTHCHECK --interval=9s CMD [\"x\"]\n", {})
    assert stage == Stage("debian", "", environment={"A": "1", "B": "2 3"}, health_check=["x"])

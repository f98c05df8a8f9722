"""What README.md and docs/ show is what happens."""

import importlib.util
import re
import shlex
from collections.abc import Iterator
from importlib.metadata import entry_points
from pathlib import Path

import pytest
import typer

import tests.test_house as house
from captra.cli import build_app
from service.settings import CONFIG_VARIABLE, Settings
from tests.service.support import running

ROOT = house.ROOT
PAGES = {page.name: page.read_text(encoding="utf-8") for page in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]}
README = PAGES["README.md"]
CREDENTIALS = (ROOT / "clients" / "credentials.py").read_text(encoding="utf-8")
SETTINGS = {f"CAPTRA_{name.upper()}" for name in Settings.model_fields} | {CONFIG_VARIABLE}
OF_CLIENTS = {"CAPTRA_URL", "CAPTRA_HOST", "CAPTRA_BIND", *re.findall(r"CAPTRA_[A-Z_]+", CREDENTIALS)}
"""Variables that the service does not read: the clients' and that of compose.yaml."""
TESTED_ELSEWHERE = {"wire-contract.md"}
"""Its example runs in tests/service/test_wire_contract.py."""


def blocks(language: str, text: str) -> list[str]:
    """What stands in the fenced blocks of a language."""
    found: list[str] = re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    return found


SNIPPETS = [
    pytest.param(snippet, id=f"{name}-{number}")
    for name, text in PAGES.items()
    if name not in TESTED_ELSEWHERE
    for number, snippet in enumerate(blocks("python", text))
]
LINES = sorted(
    {
        line.partition("#")[0].strip()
        for text in PAGES.values()
        for block in blocks("sh", text)
        for line in block.replace("\\\n", " ").splitlines()
    }
    - {""}
)


@pytest.fixture(scope="module")
def service_url(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with running("mug", "scissors", record_dir=tmp_path_factory.mktemp("recorded")) as started:
        assert started.service.readiness.wait_prepared(60)
        yield str(started.http.base_url)


def test_there_are_snippets() -> None:
    assert len(SNIPPETS) >= 2
    assert len(LINES) >= 5


@pytest.mark.parametrize("snippet", SNIPPETS)
def test_snippets_run(
    snippet: str, service_url: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("CAPTRA_URL", service_url)
    exec(compile(snippet, "README.md", "exec"), {})
    if "print(" in snippet:
        assert len(capsys.readouterr().out.splitlines()) > 5


@pytest.mark.parametrize("line", LINES)
def test_commands_that_it_shows_can_be_given(line: str) -> None:
    words = [word for word in shlex.split(line) if not re.fullmatch(r"[A-Z_]+=.*", word)]
    program, arguments = words[0].removeprefix(".venv/bin/"), words[1:]
    options = {word.partition("=")[0] for word in arguments if word.startswith("--")}
    match program:
        case "captra":
            assert options <= options_of(arguments[0])
        case "python" if arguments[0] == "-m":
            spec = importlib.util.find_spec(arguments[1])
            assert spec is not None
            assert spec.origin is not None
            source = Path(spec.origin).read_text(encoding="utf-8")
            assert all(f'"{option}"' in source for option in options)
        case "python":
            assert (ROOT / arguments[0]).is_file()
        case "make":
            assert set(arguments) <= make_targets()
        case "docker":
            assert arguments[0] in {"build", "run", "compose"}
        case _:
            raise AssertionError(f"nothing is known of {program}")


def options_of(command: str) -> set[str]:
    """The options of a subcommand of `captra`."""
    (entry,) = entry_points(group="captra.commands", name=command)
    group = typer.main.get_command(build_app({command: entry.load()}))
    parameters = group.commands[command].params  # type: ignore[attr-defined]
    return {option for each in parameters for option in (*each.opts, *each.secondary_opts)}


def make_targets() -> set[str]:
    return set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(), re.MULTILINE))


@pytest.mark.parametrize("text", [pytest.param(text, id=name) for name, text in PAGES.items()])
def test_what_it_names_exists(text: str) -> None:
    assert set(re.findall(r"`captra ([\w-]+)", text)) <= set(house.COMMANDS)
    assert set(re.findall(r"`make ([a-z]+)", text)) <= make_targets()
    assert set(re.findall(r"CAPTRA_[A-Z0-9_]*[A-Z0-9]", text)) <= SETTINGS | OF_CLIENTS


def test_the_readme_names_every_command() -> None:
    named = set(re.findall(r"`captra ([\w-]+)", README))
    assert set(house.COMMANDS) - named <= {"demo", "serve"}, "these are shown as make targets"


@pytest.mark.parametrize("name", PAGES)
def test_links_lead_somewhere(name: str) -> None:
    folder = ROOT if name == "README.md" else ROOT / "docs"
    for target in re.findall(r"\]\(([^)]+)\)", PAGES[name]):
        if "://" in target:
            continue
        path, _, heading = target.partition("#")
        file = (folder / path).resolve() if path else folder / name
        assert file.exists(), target
        if heading:
            headings = re.findall(r"^#+ (.*)$", file.read_text(encoding="utf-8"), re.MULTILINE)
            assert heading in {each.lower().replace(" ", "-") for each in headings}, target


def test_every_page_can_be_reached_from_the_readme() -> None:
    for name in PAGES.keys() - {"README.md"}:
        assert f"](docs/{name}" in README, name

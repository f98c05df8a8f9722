import subprocess
import sys
from importlib.metadata import EntryPoint

import pytest

from captra import cli


def captra(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "captra", *arguments], capture_output=True, text=True, timeout=60, check=False
    )


def entry(name: str, module: str) -> EntryPoint:
    return EntryPoint(name, f"{module}:run", cli.GROUP)


def registered(monkeypatch: pytest.MonkeyPatch, *entries: EntryPoint) -> None:
    monkeypatch.setattr(cli, "entry_points", lambda group: entries)


def module(monkeypatch: pytest.MonkeyPatch, name: str, source: str) -> None:
    """Make a module that can be imported under a name."""
    made = type(sys)(name)
    exec(source, made.__dict__)
    monkeypatch.setitem(sys.modules, name, made)


def test_help_lists_every_command_with_its_first_line() -> None:
    ended = captra("--help")
    assert ended.returncode == 0
    for name in ("demo", "track", "serve", "step", "export", "replace-network", "train", "evaluate", "response"):
        assert f" {name} " in ended.stdout
    assert "Not available" not in ended.stdout


def test_help_of_a_command_names_its_options() -> None:
    ended = captra("track", "--help")
    assert ended.returncode == 0
    assert "--as-fast-as-possible" in ended.stdout
    assert "captra track recordings/" in ended.stdout


def test_an_unknown_command_is_an_error_with_a_suggestion() -> None:
    ended = captra("trakc")
    assert ended.returncode == 2
    assert "track" in ended.stderr


def test_only_the_module_that_is_asked_for_is_imported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    module(monkeypatch, "wanted", "def run() -> None:\n    '''Say hello.'''\n    print('hello')")
    registered(monkeypatch, entry("wanted", "wanted"), entry("other", "does_not_exist"))
    with pytest.raises(SystemExit) as ended:
        cli.main(["wanted"])
    assert ended.value.code == 0
    assert capsys.readouterr().out == "hello\n"


def test_a_missing_extra_is_named_wherever_the_import_stands(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    module(monkeypatch, "export.lazy", "def run() -> None:\n    raise ModuleNotFoundError('no', name='torch.nn')")
    registered(monkeypatch, entry("lazy", "export.lazy"))
    with pytest.raises(SystemExit) as ended:
        cli.main(["lazy"])
    assert ended.value.code == 2
    assert "captra lazy: needs torch, which is not installed" in (told := capsys.readouterr().err)
    assert "pip install '.[export]'" in told


def test_a_missing_extra_leaves_the_command_in_the_help(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Missing(EntryPoint):
        def load(self) -> object:
            raise ModuleNotFoundError("no", name="onnxruntime")

    registered(monkeypatch, Missing("serve", "service.cli:serve", cli.GROUP))
    with pytest.raises(SystemExit):
        cli.main(["--help"])
    printed = " ".join(capsys.readouterr().out.split())
    assert "serve" in printed
    assert "needs onnxruntime" in printed


def test_a_module_that_no_extra_brings_is_a_defect(monkeypatch: pytest.MonkeyPatch) -> None:
    registered(monkeypatch, entry("broken", "captra.does_not_exist"))
    with pytest.raises(ModuleNotFoundError, match="does_not_exist"):
        cli.main(["broken"])


@pytest.mark.parametrize(
    ("missing", "distribution", "extra"), [("jwt.algorithms", "pyjwt", "secure"), ("small_gicp", "small-gicp", "train")]
)
def test_a_module_that_is_called_otherwise_is_found_by_what_brings_it(
    missing: str, distribution: str, extra: str
) -> None:
    told = cli.explain(ModuleNotFoundError("no", name=missing), prefer="service.cli")
    assert told is not None
    assert f"needs {distribution}, which is not installed" in told
    assert f"pip install '.[{extra}]'" in told


@pytest.mark.parametrize(
    ("distribution", "extras"), [("torch", ["train", "export"]), ("onnxruntime", ["cpu"]), ("numpy", []), ("", [])]
)
def test_extras_are_read_from_the_metadata(distribution: str, extras: list[str]) -> None:
    requirements = [
        "numpy>=2.1",
        'onnxruntime>=1.20; extra == "cpu"',
        'onnxruntime-openvino>=1.20; extra == "openvino"',
        "torch==2.13.0 ; extra == 'train'",
        'torch==2.13.0; extra == "export"',
    ]
    assert cli.extras_with(distribution, requirements) == extras

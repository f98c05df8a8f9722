"""Typical mistakes at the command line, made with the real commands: no traceback, and what to do next."""

import os
import re
import sys
from pathlib import Path

import pytest

from captra.cli import main

ROOT = Path(__file__).parents[1]
MODELS = ROOT / "models"
MUG = ROOT / "recordings" / "mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An empty folder, a wide terminal and no settings."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder.mcap").mkdir()
    monkeypatch.setenv("COLUMNS", "400")
    for name in [name for name in os.environ if name.startswith("CAPTRA_")]:
        monkeypatch.delenv(name)


def complaint(capsys: pytest.CaptureFixture[str], *arguments: object) -> str:
    """What a command says that fails; every exception but SystemExit would be a traceback."""
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    assert ended.value.code in {1, 2}
    return " ".join(capsys.readouterr().err.split())


OF_MUG = ("--category", "mug", "--models", MODELS, "--recordings")
ONE_VIEW = ("--count", 1, "--seed", 1, "--out", "x")
COMMANDS: dict[str, tuple[tuple[object, ...], str]] = {
    "unknown command": (("trakc",), r"captra -h"),
    "unknown option": (("serve", "--prot", "1"), r"--port"),
    "unknown category": (("train", "--category", "mugg"), r"choose one of bottle"),
    "unknown category to show": (
        ("generate", *ONE_VIEW, "--category", "x"),
        r"one of bottle",
    ),
    "seed below zero": (
        ("generate", "--category", "mug", "--count", 1, "--seed", -1, "--out", "x"),
        r"'--seed': .*greater than or equal to 0",
    ),
    "nowhere for views": (
        ("generate", "--category", "mug", "--count", 1, "--seed", 1, "--out", "/dev/null/x"),
        r"make the folder /dev/null/x .*name one",
    ),
    "category without model": (
        ("evaluate", "--category", "drawers", "--models", "."),
        r"no model of drawers in \..*captra export",
    ),
    "no models": (("evaluate", "--models", "."), r"no models in \.: name the folder .* by --models"),
    "no sequences": (("evaluate", *OF_MUG, "."), r"--recordings, or .*--procedural 20"),
    "nowhere to keep sequences": (("evaluate", *OF_MUG, ".", "--cache", MUG), r"folder that can be written by --cache"),
    "no job": (("evaluate", "--jobs", 0), r"'--jobs': .*greater than or equal to 1"),
    "no job to fuse": (("fuse", "--jobs", 0), r"'--jobs': .*greater than or equal to 1"),
    "sequences of one frame": (("evaluate", "--frames", 1), r"'--frames': .*greater than or equal to 2"),
    "sequences of one frame to fuse": (("fuse", "--frames", 1), r"'--frames': .*greater than or equal to 2"),
    "fewer sequences than none": (("evaluate", "--procedural", -1), r"'--procedural': .*greater than or equal to 0"),
    "no stream": (("bench", "--streams", 1, "--streams", 0), r"'--streams': .*greater than or equal to 1"),
    "no frame": (("bench", "--frames", 0), r"'--frames': .*greater than or equal to 1"),
    "nowhere to write rows": (("evaluate", "--json", "/dev/null/x.json"), r"make the folder /dev/null .*name one"),
    "folder for tables": (("evaluate", "--markdown", "."), r"cannot write \. \(Is a directory\): name a file"),
    "nowhere for pictures": (("evaluate", "--pictures", MUG), r"make the folder .* \(File exists\): name one"),
    "nowhere to write health": (("health", "--json", "/dev/null/x"), r"make the folder /dev/null .*name one"),
    "picture of another kind": (("health", "--picture", "x.xyz"), r"x\.xyz is no PNG: name a file"),
    "nowhere to write speeds": (("bench", "--json", "/dev/null/x"), r"make the folder /dev/null .*name one"),
    "unknown profile": (("evaluate", "--profile", "fast"), r"'realtime', 'paper'"),
    "unknown provider": (("response", *OF_MUG, MUG.parent, "--provider", "tpu"), r"choose one of auto, cpu"),
    "no views": (("train", "--category", "mug"), r"captra generate --category mug"),
    "no library": (
        ("generate", *ONE_VIEW, "--category", "mug", "--meshes", "."),
        r"INDEX\.json, see docs/your-own-category\.md",
    ),
    "no checkpoint": (
        ("export", "--coordinate", MUG, "--rotation", MUG, "--category", "mug", "--out", "x"),
        r"no readable checkpoint: download",
    ),
    "no service": (("status", "--url", "http://127.0.0.1:9"), r"start one with `captra serve`"),
    "no address": (("track", MUG, "--url", "robot:8080"), r"write it like http://robot:8080"),
    "nowhere to record": (("track", MUG, "--record", "/dev/null/x.mcap"), r"name a file in a folder that is there"),
    "recording that nobody knows for one": (("track", MUG, "--record", "mug.npz"), r"name a file that ends in \.mcap"),
    "folder to record into": (("track", MUG, "--record", "folder.mcap"), r"name a file that ends in \.mcap"),
    "no recording": (("track", ROOT / "README.md"), r"is no recording: .*record or download"),
    "recording that is not there": (("track", "nowhere.npz"), r"does not exist"),
    "nowhere for recordings": (("record", "--out", "/dev/null/x"), r"make the folder /dev/null/x .*name one"),
    "recording to measure that is not there": (("bench", "--recording", "nowhere.npz"), r"does not exist"),
    "truth that is not there": (("plot", ROOT / "README.md", "--truth", "nowhere.npz"), r"does not exist"),
    "nowhere to draw": (("plot", MUG, "--out", "/dev/null/x.png"), r"make the folder /dev/null .*name one"),
    "picture nobody knows": (("plot", MUG, "--out", "x.xyz"), r"x\.xyz is no picture: name a file that ends in \.png"),
    "keys nowhere": (("certify", "/dev/null/x", "--host", "a", "--client", "b"), r"name a folder that can be"),
    "settings that are not there": (("serve", "--config", "x.toml"), r"correct --config"),
    "open to everybody": (("serve", "--host", "0.0.0.0"), r"captra certify"),
}


@pytest.mark.parametrize("case", COMMANDS)
def test_commands_say_what_to_do(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    arguments, hint = COMMANDS[case]
    said = complaint(capsys, *arguments)
    assert re.search(hint, said), said


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("http_prot = 1", r"no setting http_prot: did you mean http_port\?"),
        ("http_port = = 1", r"is no TOML .*write lines like"),
        ("http_port = 99999", r"setting http_port: .*65535.*CAPTRA_HTTP_PORT"),
        ("[[api_keys]]\nname = 'a'", r"setting api_keys\.0\.sha256"),
    ],
)
def test_settings_say_what_to_do(line: str, hint: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    config = tmp_path / "captra.toml"
    config.write_text(line)
    said = complaint(capsys, "serve", "--config", config)
    assert re.search(hint, said), said


def test_a_variable_that_is_no_json(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("CAPTRA_ZENOH_LISTEN", "tcp/127.0.0.1:1")
    assert "CAPTRA_ZENOH_LISTEN is no JSON: write a list like [" in complaint(capsys, "serve")


def test_a_mistyped_variable_is_doubted_and_those_of_clients_are_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("CAPTRA_PROVIDR", "CAPTRA_API_KEY", "CAPTRA_URL", "CAPTRA_CLIENT_KEY", "CAPTRA_CA_FILE"):
        monkeypatch.setenv(name, "x")
    said = complaint(capsys, "serve", "--host", "0.0.0.0")
    assert "CAPTRA_PROVIDR is no setting: did you mean provider?" in said
    assert said.count("did you mean") == 1


def test_signed_tokens_without_what_reads_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    key = tmp_path / "key.pem"
    key.touch()
    monkeypatch.setenv("CAPTRA_TOKEN_KEY_FILE", str(key))
    monkeypatch.delitem(sys.modules, "service.security.tokens", raising=False)
    monkeypatch.setitem(sys.modules, "jwt", None)
    said = complaint(capsys, "serve")
    assert "captra serve: needs pyjwt, which is not installed" in said
    assert "pip install '.[secure]'" in said

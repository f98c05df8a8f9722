"""What `pip install .` brings: enough to serve, to track and to look, and nothing else."""

import os
import subprocess
import sys
import time
import venv
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from zipfile import ZipFile

import httpx
import pytest

from captra.runtime.bundle import find_bundles
from clients.rest import RestApi
from clients.service_process import free_ports, obstacle_of
from tests.test_readme import README, blocks

ROOT = Path(__file__).parents[2]
SOURCES = ("captra", "clients", "export", "service", "pyproject.toml", "README.md")
OF_THE_PAGE = {".html", ".js", ".css", ".svg", ".woff2", ".txt", ".sha256"}
ENDINGS = {".py", ".typed", ".onnx", ".json", ".npz", ".md"} | OF_THE_PAGE


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built where nothing is left over from an earlier build."""
    folder = tmp_path_factory.mktemp("wheel")
    for name in SOURCES:
        (folder / name).symlink_to(ROOT / name)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir", "."]
    subprocess.run([*command, "."], cwd=folder, check=True)
    (built,) = folder.glob("*.whl")
    return built


@pytest.fixture(scope="module")
def python(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The interpreter of an environment with the wheel, and this one's packages behind it."""
    folder = tmp_path_factory.mktemp("installed")
    venv.create(folder, with_pip=False)
    python = folder / "bin" / "python"
    install = [sys.executable, "-m", "pip", "--python", str(python), "install", "--quiet", "--no-deps", str(wheel)]
    subprocess.run(install, check=True)
    (packages,) = folder.glob("lib/python3*/site-packages")
    others = [path for path in sys.path if path.endswith("site-packages")]
    (packages / "others.pth").write_text("\n".join(others))
    return python


@contextmanager
def served(python: Path, scratch: Path) -> Iterator[dict[str, str]]:
    """`captra serve` of the wheel, away from the project; gives the environment of its clients."""
    http, zenoh = free_ports(2)
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("CAPTRA_", "PYTHON"))} | {
        "CAPTRA_HTTP_PORT": str(http),
        "CAPTRA_ZENOH_LISTEN": f'["tcp/127.0.0.1:{zenoh}"]',
        "CAPTRA_STATE_DIR": str(scratch / "state"),
        "CAPTRA_URL": f"http://127.0.0.1:{http}",
    }
    process = subprocess.Popen([python.with_name("captra"), "serve"], cwd=scratch, env=environment)
    try:
        with closing(RestApi(environment["CAPTRA_URL"])) as api:
            while obstacle_of(api) is not None:
                assert process.poll() is None, "the service ended before it was ready"
                time.sleep(0.1)
        yield environment
    finally:
        process.terminate()
        process.wait(20)


def test_it_holds_the_code_the_models_the_page_and_nothing_else(wheel: Path) -> None:
    names = [Path(name) for name in ZipFile(wheel).namelist() if ".dist-info" not in name]
    assert {name.parts[0] for name in names} == {"captra", "clients", "export", "service"}
    assert {name.suffix for name in names} <= ENDINGS, "no checkpoints"
    assert not [name for name in names if {"tests", "checkpoints", "benchmarks"} & {*name.parts}]
    bundles = {name.parent.name for name in names if name.parts[:2] == ("captra", "models")}
    assert bundles == set(find_bundles(ROOT / "models"))
    page = {name.name for name in names if "static" in name.parts}
    assert page == {path.name for path in (ROOT / "service" / "viewer" / "static").iterdir()}


def test_the_five_lines_of_the_readme_track_a_mug(python: Path, tmp_path: Path) -> None:
    program = blocks("python", README)[0]
    (tmp_path / "recordings").symlink_to(ROOT / "recordings")
    with served(python, tmp_path) as environment:
        lines = subprocess.run(
            [python, "-c", program], cwd=tmp_path, env=environment, check=True, capture_output=True, text=True
        ).stdout.splitlines()
        page = httpx.get(environment["CAPTRA_URL"] + "/viewer/static/app.js")
        models = httpx.get(environment["CAPTRA_URL"] + "/v1/models").json()["models"]
    assert lines[-1].startswith("tracking ")
    assert page.is_success
    assert {model["category"] for model in models} == set(find_bundles(ROOT / "models"))


def test_the_code_is_that_of_the_wheel(python: Path, tmp_path: Path) -> None:
    program = "import captra.shipped as s; print(s.MODELS); print(*(p.name for p in s.RECORDINGS.iterdir()))"
    shown = subprocess.run([python, "-c", program], cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    models, recordings = shown.splitlines()
    assert Path(models).is_relative_to(python.parents[1])
    assert {Path(name).suffix for name in recordings.split()} == {".md", ".npz"}

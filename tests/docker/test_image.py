"""The steps of the image in a folder of its own: installed, warmed, write-protected, and a mug tracked by it.

`make image` does the same in the image's own file system, as root.
"""

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from captra.data.recordings import load_recording
from clients import open_session
from clients.rest import RestApi
from clients.service_process import free_ports, obstacle_of
from docker.dockerfile import read

ROOT = Path(__file__).parents[2]
RECORDING = ROOT / "recordings" / "mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"
IMAGE = read((ROOT / "Dockerfile").read_text(), {})[-1]
FRAMES = 8
WITHOUT_RIGHTS = ("setpriv", "--bounding-set=-all", "--inh-caps=-all", "--no-new-privs")
"""As root without capabilities: write protection holds, as for any user."""


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """What the image has in /opt/captra, write-protected."""
    folder = tmp_path_factory.mktemp("image") / "captra"
    source = folder.with_name("source")
    for name in ("captra", "clients", "export", "service", "docker"):
        shutil.copytree(ROOT / name, source / name, symlinks=True, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(ROOT / name, source)
    models = source / "models"
    shutil.copytree(ROOT / "models" / "mug", models / "mug")
    environment = os.environ | {"PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    for script, *arguments in (("packages.sh", source, "cpu", folder), ("kernels.sh", folder, models)):
        subprocess.run([source / "docker" / str(script), *arguments], env=environment, check=True)
    shutil.copytree(models, folder / "models")
    protect(folder, writable=False)
    yield folder
    protect(folder, writable=True)


def protect(folder: Path, *, writable: bool) -> None:
    for path in (folder, *folder.rglob("*")):
        if not path.is_symlink():
            mode = path.stat().st_mode
            path.chmod(mode | stat.S_IWUSR if writable else mode & ~0o222)


@contextmanager
def started(prefix: Path, scratch: Path) -> Iterator[tuple[subprocess.Popen[bytes], dict[str, str]]]:
    """The entry point of the image, with one folder to write to."""
    http, zenoh = free_ports(2)
    environment = IMAGE.environment | {
        "PATH": f"{prefix}/bin:{os.environ['PATH']}",
        "TMPDIR": str(scratch),
        "CAPTRA_MODELS_DIR": f"{prefix}/models",
        "CAPTRA_STATE_DIR": f"{scratch}/state",
        "CAPTRA_HTTP_HOST": "127.0.0.1",
        "CAPTRA_HTTP_PORT": str(http),
        "CAPTRA_ZENOH_LISTEN": json.dumps([f"tcp/127.0.0.1:{zenoh}"]),
        "CAPTRA_URL": f"http://127.0.0.1:{http}",
    }
    rights = WITHOUT_RIGHTS if os.geteuid() == 0 else ()
    entrypoint = prefix / "bin" / IMAGE.entrypoint[0]
    command = [*rights, entrypoint, *IMAGE.command]
    process = subprocess.Popen(command, cwd="/", env=environment)
    try:
        wait_until_ready(environment["CAPTRA_URL"], process)
        yield process, environment
    finally:
        process.kill()
        process.wait()


def wait_until_ready(url: str, process: subprocess.Popen[bytes]) -> None:
    with closing(RestApi(url)) as api:
        while obstacle_of(api) is not None:
            assert process.poll() is None, "the service ended before it was ready"
            time.sleep(0.1)


def files(folder: Path) -> set[str]:
    return {path.name for path in folder.rglob("*") if path.is_file()}


def test_the_image_tracks_a_mug_with_what_was_built_into_it(prefix: Path, tmp_path: Path) -> None:
    recording = load_recording(RECORDING)
    with started(prefix, tmp_path) as (process, environment):
        with open_session("mug", recording.init, url=environment["CAPTRA_URL"]) as session:
            results = list(session.track(recording.clouds[:FRAMES], timeout_s=30))
        check = [str(prefix / "bin" / IMAGE.health_check[0]), *IMAGE.health_check[1:]]
        assert subprocess.run(check, env=environment, check=False).returncode == 0
        (kernels,) = tmp_path.glob("*/kernels")
        assert files(kernels) == files(prefix / "kernels") != set(), "kernels were compiled again"
        process.send_signal(signal.SIGTERM)
        assert process.wait(10) == 0
        unhealthy = subprocess.run(check, env=environment, check=False, capture_output=True, text=True)
    assert unhealthy.returncode == 1
    assert "captra serve" in unhealthy.stderr
    assert abs(results[-1].pose.translation - recording.truth(FRAMES - 1).translation).max() < 0.02


def test_the_image_makes_the_keys_of_a_guarded_service(prefix: Path, tmp_path: Path) -> None:
    keys = tmp_path / "keys"
    command = [str(prefix / "bin" / "captra"), "certify", str(keys), "--host", "localhost", "--client", "arm"]
    subprocess.run(command, env={"PATH": os.environ["PATH"]}, check=True, capture_output=True)
    assert (keys / "captra.toml").is_file()


def test_neither_pytorch_nor_a_compiler_nor_pip_is_in_it(prefix: Path) -> None:
    packages = {path.name for path in prefix.glob("lib/python3*/site-packages/*")}
    assert {"onnxruntime", "numba", "zenoh", "jwt"} <= packages
    assert not {"torch", "pip", "onnx", "trimesh", "matplotlib"} & packages
    assert not any((prefix / "bin" / tool).exists() for tool in ("cc", "gcc", "pip"))


def test_a_runtime_that_does_not_exist_is_named(tmp_path: Path) -> None:
    done = subprocess.run(
        [ROOT / "docker" / "packages.sh", ROOT, "tpu", tmp_path / "x"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert "tpu" in done.stderr
    assert not (tmp_path / "x").exists()

"""Plays the Dockerfile through in folders, where no container engine runs, and tracks a recording with what comes out.

    sudo .venv/bin/python -m docker.rehearse --runtime cpu --work /var/tmp/captra-image

Needs root, debootstrap, and the distribution's and Python's package registries. Each stage is a folder that starts as a
copy of its base and in which every RUN runs, by chroot. The service then runs as the image's user, without privileges,
on a read-only root, as `docker run --read-only --tmpfs /tmp` has it, and frames of a recording are tracked through it.
"""

import argparse
import os
import shlex
import shutil
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from captra.data.recordings import load_recording
from clients import open_session
from clients.rest import RestApi
from clients.service_process import free_ports
from docker.dockerfile import Copy, Stage, read

ROOT = Path(__file__).resolve().parents[1]
RECORDING = ROOT / "recordings" / "mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz"
DEBIAN = "debian:bookworm-slim"
READY_WITHIN_S = 300.0
FRAMES = 20

BUILD = """
mount --rbind /dev {root}/dev && mount -t proc proc {root}/proc && mount --bind /etc/resolv.conf {root}/etc/resolv.conf
{certificates}
exec chroot {root} /bin/sh -c {command}
"""
"""A RUN, in mounts of its own; what the host needs to reach its package registries comes along."""

SERVE = """
mount --bind {root} {root} && mount --bind {state} {root}{volume}
mount -t tmpfs tmpfs {root}/tmp && mount --rbind /dev {root}/dev && mount -t proc proc {root}/proc
mount -o remount,bind,ro {root}
exec chroot --userspec={user} {root} /usr/bin/setpriv --no-new-privs {command}
"""
"""The container: read-only but for its volume and /tmp."""


def build(stages: list[Stage], work: Path) -> None:
    """Play all stages through, each in the folder `stage-N`."""
    roots = {DEBIAN: debian(work / "debian")}
    for number, stage in enumerate(stages):
        root = work / f"stage-{number}"
        shutil.rmtree(root, ignore_errors=True)
        subprocess.run(["cp", "-a", "--reflink=auto", roots[stage.base], root], check=True)
        roots[stage.name] = root
        for step in stage.steps:
            if isinstance(step, Copy):
                copy(step, ROOT if step.stage is None else roots[step.stage], root)
            else:
                print(f"{stage.name or 'last'}: {step.command}", flush=True)
                run(step.command, root, stage.environment)


def debian(root: Path) -> Path:
    """A minimal Debian, made once; its packages' documentation is left out, as in the slim image."""
    if not (root / "etc" / "debian_version").exists():
        shutil.rmtree(root, ignore_errors=True)
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", root], check=True, stdout=subprocess.DEVNULL)
        for folder in ("usr/share/doc", "usr/share/man", "usr/share/locale", "var/cache/apt", "var/lib/apt/lists"):
            shutil.rmtree(root / folder)
            (root / folder).mkdir()
    return root


def copy(step: Copy, source: Path, root: Path) -> None:
    """COPY, as Docker has it: the contents of a folder, or a file under its own name."""
    target = root / step.target.lstrip("/")
    for name in step.sources:
        path = source / name.lstrip("/")
        if path.is_dir():
            target.mkdir(parents=True, exist_ok=True)
            subprocess.run(["cp", "-a", "--no-preserve=ownership", f"{path}/.", target], check=True)
        else:
            (target if step.target.endswith("/") else target.parent).mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)


def run(command: str, root: Path, environment: dict[str, str]) -> None:
    """RUN."""
    certificates, variables = "", {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "DEBIAN_FRONTEND": "noninteractive"}
    if "PIP_CERT" in os.environ:
        variables["PIP_CERT"] = "/certificates.pem"
        certificates = f"touch {root}/certificates.pem && mount --bind {os.environ['PIP_CERT']} {root}/certificates.pem"
    script = BUILD.format(root=root, certificates=certificates, command=shlex.quote(command))
    try:
        subprocess.run(["unshare", "--mount", "sh", "-euc", script], env=variables | environment, check=True)
    finally:
        (root / "certificates.pem").unlink(missing_ok=True)


@contextmanager
def container(image: Stage, root: Path, state: Path, settings: dict[str, str]) -> Iterator[subprocess.Popen[bytes]]:
    """The image, running."""
    state.mkdir(exist_ok=True)
    os.chown(state, *(int(number) for number in image.user.split(":")))
    command = shlex.join([*image.entrypoint, *image.command])
    script = SERVE.format(root=root, state=state, volume=image.volumes[0], user=image.user, command=command)
    started = subprocess.Popen(["unshare", "--mount", "sh", "-euc", script], env=image.environment | settings)
    try:
        yield started
    finally:
        started.kill()
        started.wait()


def healthy(image: Stage, root: Path, settings: dict[str, str]) -> bool:
    """What HEALTHCHECK says."""
    command = ["chroot", f"--userspec={image.user}", str(root), *image.health_check]
    return subprocess.run(command, env=image.environment | settings, capture_output=True, check=False).returncode == 0


def track(url: str) -> float:
    """Track the first frames of the recording; returns how far off the last centre is, metres."""
    recording = load_recording(RECORDING)
    with open_session(recording.category.name, recording.init, url=url) as session:
        results = list(session.track(recording.clouds[:FRAMES], timeout_s=30))
    offset = results[-1].pose.translation - recording.truth(FRAMES - 1).translation
    return float((offset**2).sum() ** 0.5)


def megabytes(*paths: Path) -> float:
    """Size of some folders, as `du` counts it."""
    output = subprocess.run(["du", "-sxk", *paths], check=True, capture_output=True, text=True).stdout
    return sum(int(line.split()[0]) for line in output.splitlines()) / 1024


def main() -> None:
    """Build, measure, run, track, stop."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runtime", default="cpu", choices=("cpu", "openvino", "gpu"))
    parser.add_argument("--skip-build", action="store_true", help="run what the last call built")
    parser.add_argument("--work", type=Path, default=Path("/var/tmp/captra-image"), help="folder of the stages")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    stages = read((ROOT / "Dockerfile").read_text(encoding="utf-8"), {"RUNTIME": options.runtime})
    image, root = stages[-1], options.work / f"stage-{len(stages) - 1}"
    if not options.skip_build:
        build(stages, options.work)
    prefix = root / "opt" / "captra"
    print(
        f"{options.runtime}: {megabytes(root):.0f} MB, of which {megabytes(prefix):.0f} MB captra with what it needs,"
    )
    print(f"of which {megabytes(prefix / 'models'):.0f} MB models and {megabytes(prefix / 'kernels'):.1f} MB kernels")
    http, zenoh = free_ports(2)
    settings = {
        "CAPTRA_HTTP_HOST": "127.0.0.1",
        "CAPTRA_HTTP_PORT": str(http),
        "CAPTRA_ZENOH_LISTEN": f'["tcp/127.0.0.1:{zenoh}"]',
        "CAPTRA_URL": f"http://127.0.0.1:{http}",
    }
    started_s = time.monotonic()
    with container(image, root, options.work / "state", settings) as process:
        while not healthy(image, root, settings):
            if process.poll() is not None or time.monotonic() - started_s > READY_WITHIN_S:
                raise SystemExit("the container is not healthy: its log is above")
        print(f"healthy after {time.monotonic() - started_s:.1f} s")
        with closing(RestApi(settings["CAPTRA_URL"])) as api:
            print("models:", ", ".join(f"{model['category']} ({model['provider']})" for model in api.models()))
        print(f"{FRAMES} frames tracked, the last centre is off by {100 * track(settings['CAPTRA_URL']):.1f} cm")
        process.send_signal(signal.SIGTERM)
        print(f"ended with status {process.wait(10)}")


if __name__ == "__main__":
    main()

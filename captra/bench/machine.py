"""What the figures were measured on."""

import os
import platform
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

PACKAGES = ("numpy", "numba", "onnxruntime", "onnxruntime-openvino", "onnxruntime-gpu", "eclipse-zenoh")


@dataclass(frozen=True)
class Machine:
    """The computer and the versions."""

    cpu: str
    """Model name."""
    cores: int
    """That this process may use."""
    python: str
    """Version."""
    packages: dict[str, str]
    """Version of each installed package that matters for speed."""


def this_machine() -> Machine:
    """Look around."""
    return Machine(_cpu_model(), len(os.sched_getaffinity(0)), platform.python_version(), dict(_installed()))


def _cpu_model() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), platform.machine())


def _installed() -> list[tuple[str, str]]:
    found = []
    for package in PACKAGES:
        try:
            found.append((package, metadata.version(package)))
        except metadata.PackageNotFoundError:
            continue
    return found

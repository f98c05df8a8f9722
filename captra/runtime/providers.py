"""What runs the graphs: ONNX Runtime's own CPU kernels, OpenVINO in bfloat16, or CUDA."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from captra.errors import UserError

CPU = "CPUExecutionProvider"
OPENVINO = "OpenVINOExecutionProvider"
CUDA = "CUDAExecutionProvider"
CPUINFO = Path("/proc/cpuinfo")

EXTRAS = {"cpu": "cpu", "openvino": "openvino", "cuda": "gpu"}
"""Which extra of the distribution brings a provider."""

BFLOAT16_FLAGS = frozenset({"avx512_bf16", "amx_bf16", "bf16"})
"""As the kernel spells them, on x86 and ARM."""


class ProviderError(UserError, ValueError):
    """A provider that is unknown or not installed; the message says what to install."""


@dataclass(frozen=True)
class Provider:
    """One way to run a graph."""

    name: str
    """As operators choose it."""
    arithmetic: str
    """Of the matrix products."""
    execution_providers: tuple[tuple[str, Mapping[str, Any]], ...]
    """In ONNX Runtime's order of preference, with options."""


def choose_provider(
    name: str, threads: int, installed: Sequence[str], cpuinfo: Path = CPUINFO, runs: int = 1
) -> Provider:
    """The provider called `name`; `auto` is OpenVINO where it is installed and the CPU multiplies in bfloat16.

    `threads` are shared by so many `runs` of a graph at a time.

    Raises:
        ProviderError: the name is unknown, or the installed build of ONNX Runtime lacks it.
    """
    if name == "auto":
        name = "openvino" if OPENVINO in installed and has_bfloat16(cpuinfo) else "cpu"
    provider = _configured(name, threads, runs, bfloat16=has_bfloat16(cpuinfo))
    needed = provider.execution_providers[0][0]
    if needed not in installed:
        raise ProviderError(
            f"this build of onnxruntime has no {needed}, it has {', '.join(installed)}: choose provider cpu, or "
            f"install captra[{EXTRAS[name]}] in a fresh environment, since builds of onnxruntime overwrite each other"
        )
    return provider


def has_bfloat16(cpuinfo: Path = CPUINFO) -> bool:
    """Whether the CPU has instructions for bfloat16 products; False where that cannot be told."""
    try:
        text = cpuinfo.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return False
    flags = next((line for line in text.splitlines() if line.lower().startswith(("flags", "features"))), "")
    return not BFLOAT16_FLAGS.isdisjoint(flags.split())


def _configured(name: str, threads: int, runs: int, *, bfloat16: bool) -> Provider:
    match name:
        case "cpu":
            return Provider("cpu", "float32", ((CPU, {}),))
        case "cuda":
            return Provider("cuda", "float32", ((CUDA, {}), (CPU, {})))
        case "openvino":
            config = {
                "INFERENCE_PRECISION_HINT": "bf16" if bfloat16 else "f32",
                "INFERENCE_NUM_THREADS": str(threads),
                "PERFORMANCE_HINT": "LATENCY",
                "NUM_STREAMS": str(runs),
                # Pinned threads of several graphs would share one core while others are free.
                "ENABLE_CPU_PINNING": "NO",
            }
            options = {"device_type": "CPU", "load_config": json.dumps({"CPU": config})}
            return Provider("openvino", "bfloat16" if bfloat16 else "float32", ((OPENVINO, options), (CPU, {})))
    raise ProviderError(f"unknown provider {name!r}: choose one of auto, {', '.join(EXTRAS)}")

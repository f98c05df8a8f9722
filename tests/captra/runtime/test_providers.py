import json
from pathlib import Path

import pytest

from captra.runtime.providers import CPU, CUDA, OPENVINO, ProviderError, choose_provider, has_bfloat16


def cpuinfo(folder: Path, line: str) -> Path:
    path = folder / "cpuinfo"
    path.write_text(f"processor : 0\n{line}\n")
    return path


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("flags : fpu avx512f avx512_bf16 fsrm", True),
        ("flags : fpu amx_tile amx_bf16", True),
        ("Features : fp asimd bf16 i8mm", True),
        ("flags : fpu avx512f avx512_vnni", False),
        ("model name : bf16", False),
    ],
)
def test_bfloat16_is_read_from_the_flags(line: str, expected: bool, tmp_path: Path) -> None:
    assert has_bfloat16(cpuinfo(tmp_path, line)) is expected


def test_bfloat16_of_an_unknown_cpu(tmp_path: Path) -> None:
    assert not has_bfloat16(tmp_path / "none")


@pytest.mark.parametrize(
    ("installed", "flags", "expected"),
    [
        ([CPU], "avx512_bf16", "cpu"),
        ([OPENVINO, CPU], "avx512_bf16", "openvino"),
        ([OPENVINO, CPU], "avx2", "cpu"),
        ([CUDA, CPU], "avx2", "cpu"),
    ],
)
def test_auto(installed: list[str], flags: str, expected: str, tmp_path: Path) -> None:
    assert choose_provider("auto", 2, installed, cpuinfo(tmp_path, f"flags : {flags}")).name == expected


@pytest.mark.parametrize(
    ("flags", "hint", "arithmetic"), [("avx512_bf16", "bf16", "bfloat16"), ("avx2", "f32", "float32")]
)
def test_openvino_gets_threads_and_precision(flags: str, hint: str, arithmetic: str, tmp_path: Path) -> None:
    provider = choose_provider("openvino", 3, [OPENVINO, CPU], cpuinfo(tmp_path, f"flags : {flags}"))
    name, options = provider.execution_providers[0]
    config = json.loads(options["load_config"])["CPU"]
    assert name == OPENVINO
    assert provider.arithmetic == arithmetic
    assert config["INFERENCE_PRECISION_HINT"] == hint
    assert config["INFERENCE_NUM_THREADS"] == "3"
    assert config["NUM_STREAMS"] == "1"
    assert config["ENABLE_CPU_PINNING"] == "NO"


@pytest.mark.parametrize(("name", "extra"), [("openvino", "openvino"), ("cuda", "gpu")])
def test_a_provider_that_is_not_installed(name: str, extra: str) -> None:
    with pytest.raises(ProviderError, match=rf"it has {CPU}.*captra\[{extra}\]"):
        choose_provider(name, 1, [CPU])


def test_an_unknown_provider() -> None:
    with pytest.raises(ProviderError, match="unknown provider 'tpu': choose one of auto, cpu, openvino, cuda"):
        choose_provider("tpu", 1, [CPU])

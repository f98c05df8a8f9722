import json
from pathlib import Path

from typer.testing import CliRunner

from captra.cli import build_app
from clients.bench import bench

ROOT = Path(__file__).parents[2]


def test_a_service_is_measured(tmp_path: Path) -> None:
    out = tmp_path / "bench.json"
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "mug").symlink_to(ROOT / "models" / "mug")
    arguments = ["--models", str(tmp_path / "models"), "--profile", "realtime", "--frames", "6", "--streams", "2"]
    answer = CliRunner().invoke(
        build_app({"bench": bench}), ["bench", *arguments, "--json", str(out)], catch_exceptions=False
    )
    assert answer.exit_code == 0, answer.output
    content = json.loads(out.read_text())
    assert content["machine"]["cores"] >= 1
    (run,) = content["runs"]
    assert (run["category"], run["profile"], run["streams"], run["frames"]) == ("mug", "realtime", 2, 12)
    assert run["fps"] > 0
    assert 0 < run["slowest_stream_share"] <= 1
    assert run["total"]["p50"] >= run["networks"]["p50"] > 0
    assert min(run["decode"]["p50"], run["publish"]["p50"], run["cpu_ms_per_frame"], run["ready_s"]) > 0
    assert run["multiply_adds"] > 1e9
    assert run["gemm_peak_gflops"] > 1
    assert run["resident_mib"] > 50

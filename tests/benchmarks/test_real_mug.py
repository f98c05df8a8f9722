import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from benchmarks.real_mug import rough_pose
from captra.geometry import is_rotation

ROOT = Path(__file__).parents[2]


def test_a_rough_pose_stands_along_up_with_the_handle_as_near_to_where_it_should_be() -> None:
    pose = rough_pose((0.1, 0.2, 0.5), (0.0, -2.0, 0.0), (-1.0, 0.3, 0.0), (0.12, 0.1, 0.08))
    assert is_rotation(pose.rotation)
    np.testing.assert_allclose(pose.rotation[0, :, 1], [0, -1, 0], atol=1e-9)
    np.testing.assert_allclose(pose.rotation[0, :, 0], [-1, 0, 0], atol=1e-9)
    np.testing.assert_allclose(pose.translation[0], [0.1, 0.2, 0.5])
    assert pose.scale[0] == pytest.approx(np.linalg.norm([0.12, 0.1, 0.08]))


def test_the_script_prints_every_step_and_draws_the_picture(tmp_path: Path) -> None:
    v, u = np.mgrid[:240, :320]
    K = np.array([[400.0, 0, 160], [0, 400, 120], [0, 0, 1]])
    inside = (np.abs(u - 160) < 35) & (np.abs(v - 120) < 40)
    bulge = np.sqrt(np.maximum(0, 35**2 - (u - 160.0) ** 2)) / 400 * 0.5
    depth_mm = np.where(inside, 1000 * (0.5 - bulge), 900).astype(np.uint16)
    np.savez(tmp_path / "frame.npz", depth_mm=depth_mm, K=K)
    script = [sys.executable, "benchmarks/real_mug.py", str(tmp_path / "frame.npz"), str(tmp_path / "mug.png")]
    arguments = ["--centre", "0", "0", "0.5", "--up", "0", "-1", "0", "--handle", "1", "0", "0", "--steps", "2"]
    done = subprocess.run([*script, *arguments], cwd=ROOT, capture_output=True, text=True, check=True)
    assert [line.split(":")[0] for line in done.stdout.splitlines()] == ["step  1", "step  2"]
    assert (tmp_path / "mug.png").stat().st_size > 5000

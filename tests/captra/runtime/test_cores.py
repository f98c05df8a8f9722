import os
from pathlib import Path

import pytest

from captra.runtime.cores import available_cores


@pytest.fixture
def eight_cores(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(8)), raising=False)


def groups(root: Path, own: str, quotas: dict[str, str]) -> tuple[Path, Path]:
    """A control-group tree (version 2) with the quotas of some groups, and this process's place in it."""
    for group, quota in quotas.items():
        (root / group).mkdir(parents=True, exist_ok=True)
        (root / group / "cpu.max").write_text(quota)
    membership = root / "membership"
    membership.write_text(f"0::/{own}\n")
    return root, membership


@pytest.mark.usefixtures("eight_cores")
@pytest.mark.parametrize(
    ("own", "quotas", "cores"),
    [
        ("", {}, 8),
        ("", {"": "max 100000"}, 8),
        ("", {"": "200000 100000"}, 2),
        ("", {"": "350000 100000"}, 3),
        ("", {"": "50000 100000"}, 1),
        ("", {"": "3200000 100000"}, 8),
        ("system.slice/robot.service", {"system.slice/robot.service": "400000 100000"}, 4),
        (
            "system.slice/robot.service",
            {"system.slice/robot.service": "max 100000", "system.slice": "300000 100000"},
            3,
        ),
        ("", {"": "nonsense"}, 8),
    ],
)
def test_quota_of_control_groups(own: str, quotas: dict[str, str], cores: int, tmp_path: Path) -> None:
    assert available_cores(*groups(tmp_path, own, quotas)) == cores


@pytest.mark.usefixtures("eight_cores")
@pytest.mark.parametrize(("quota", "cores"), [("200000", 2), ("-1", 8)])
def test_quota_of_control_groups_version_1(quota: str, cores: int, tmp_path: Path) -> None:
    (tmp_path / "cpu").mkdir()
    (tmp_path / "cpu" / "cpu.cfs_quota_us").write_text(quota)
    (tmp_path / "cpu" / "cpu.cfs_period_us").write_text("100000")
    assert available_cores(tmp_path, tmp_path / "none") == cores


def test_this_machine() -> None:
    assert 1 <= available_cores() <= (os.cpu_count() or 1)

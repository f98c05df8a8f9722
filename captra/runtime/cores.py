"""How many cores this process may use: affinity and the container's quota, which `os.cpu_count` knows nothing of."""

import os
from collections.abc import Iterator
from pathlib import Path

CGROUP_ROOT = Path("/sys/fs/cgroup")
MEMBERSHIP = Path("/proc/self/cgroup")


def available_cores(cgroup_root: Path = CGROUP_ROOT, membership: Path = MEMBERSHIP) -> int:
    """Cores in the affinity mask, no more than the narrowest quota of this process's control groups; at least one."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, int(min([cores, *_quotas(cgroup_root, membership)])))


def _quotas(root: Path, membership: Path) -> Iterator[float]:
    """CPU time over wall time that each control group above this process grants, where it grants less than all."""
    try:
        lines = membership.read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    own = next((line.removeprefix("0::/") for line in lines if line.startswith("0::/")), "")
    for group in (root / own, *(root / parent for parent in Path(own).parents)):
        yield from _quota(group / "cpu.max")
    yield from _quota(root / "cpu" / "cpu.cfs_quota_us", root / "cpu" / "cpu.cfs_period_us")


def _quota(*files: Path) -> Iterator[float]:
    """Version 2 keeps quota and period in one file, version 1 in two; without a limit the quota is `max` or -1."""
    try:
        quota, period = (int(word) for file in files for word in file.read_text(encoding="ascii").split())
    except (OSError, ValueError):
        return
    if quota > 0:
        yield quota / period

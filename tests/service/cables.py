"""A cable of one's own between this process and a network namespace, for tests that pull it out."""

import os
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from ipaddress import IPv4Address

import pytest


@dataclass(frozen=True)
class Cable:
    """Two interfaces; the far one is in a namespace."""

    namespace: str
    """Whose only way to others it is."""
    near: str
    """Address at this end."""
    far: str
    """Address in the namespace."""

    def inside(self, *command: str) -> list[str]:
        """A command that runs in the namespace."""
        return ["ip", "netns", "exec", self.namespace, *command]

    def cut(self) -> None:
        """Nothing gets through any more, and nobody is told."""
        ip("-n", self.namespace, "link", "set", "far", "down")

    def mend(self) -> None:
        """As before."""
        ip("-n", self.namespace, "link", "set", "far", "up")


def ip(*arguments: str) -> None:
    subprocess.run(["ip", *arguments], check=True, capture_output=True, text=True)


@contextmanager
def cable() -> Iterator[Cable]:
    """A cable to a new namespace; skips the test where that is not allowed."""
    number = os.getpid() % 2**14
    near, far = (str(IPv4Address("10.213.0.0") + 4 * number + host) for host in (1, 2))
    interface = f"captra{number}"
    made = Cable(interface, near, far)
    with ExitStack() as resources:
        try:
            ip("netns", "add", made.namespace)
            resources.callback(ip, "netns", "delete", made.namespace)
            ip("link", "add", interface, "type", "veth", "peer", "name", "far", "netns", made.namespace)
            ip("address", "add", f"{near}/30", "dev", interface)
            ip("link", "set", interface, "up")
        except (OSError, subprocess.CalledProcessError) as error:
            pytest.skip(f"network namespaces are not allowed here: {getattr(error, 'stderr', error)}")
        ip("-n", made.namespace, "address", "add", f"{far}/30", "dev", "far")
        for each in ("lo", "far"):
            ip("-n", made.namespace, "link", "set", each, "up")
        yield made

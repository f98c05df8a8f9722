"""A service process whose networks take their time; run as a process by tests.

A look takes FRAME_S seconds, and beyond that until the file GATE is there, if one is named.

Says `asked` on standard output whenever a frame in hand is looked at, and at its end which of some modules are loaded.
"""

import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from jaxtyping import Float32
from numpy import ndarray

from captra.sampling import Neighborhoods
from service.router import ZenohTransport
from service.run import run
from service.settings import Settings
from service.sqlite_store import SqliteSessionStore
from service.tracking_service import TrackingService
from tests.service.support import CentreNetworks, CentreProvider

FRAME_S = float(os.environ.get("FRAME_S", "0.5"))
GATE = os.environ.get("GATE")
HANGS = "laptop"
"""A category whose frames never end."""


class SlowNetworks(CentreNetworks):
    def rotations(
        self, points_canonical: Float32[ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[ndarray, "parts points width"]:
        print("asked", flush=True)  # noqa: T201
        time.sleep(3600 if self.category.name == HANGS else FRAME_S)
        while GATE is not None and not Path(GATE).exists():
            time.sleep(0.02)
        return super().rotations(points_canonical, neighborhoods)


class SlowProvider(CentreProvider):
    def prepare(self) -> None:
        super().prepare()
        self.networks = {name: SlowNetworks(networks.category) for name, networks in self.networks.items()}


def build(settings: Settings) -> TrackingService:
    transport = ZenohTransport(settings.service, settings.zenoh_listen, (), settings.max_payload_bytes)
    store = SqliteSessionStore(settings.state_dir / f"{settings.service}.sqlite")
    return TrackingService(settings, SlowProvider("mug", HANGS), store, transport)


if __name__ == "__main__":
    run(Settings(), build)
    print("loaded", *(name for name in ("torch", "service.bundles", "fastapi") if name in sys.modules))  # noqa: T201

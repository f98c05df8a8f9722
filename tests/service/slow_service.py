"""A service process whose networks take their time; run by test_process.

Says `asked` on standard output when a frame is in hand, and at its end which of some modules are loaded.
"""

import sys
import time
from collections.abc import Sequence

from jaxtyping import Float32
from numpy import ndarray

from captra.sampling import Neighborhoods
from service.router import ZenohTransport
from service.run import run
from service.settings import Settings
from service.store import InMemorySessionStore
from service.tracking_service import TrackingService
from tests.service.support import CentreNetworks, CentreProvider


class SlowNetworks(CentreNetworks):
    def rotations(
        self, points_canonical: Float32[ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[ndarray, "parts points width"]:
        print("asked", flush=True)  # noqa: T201
        time.sleep(0.5)
        return super().rotations(points_canonical, neighborhoods)


class SlowProvider(CentreProvider):
    def prepare(self) -> None:
        super().prepare()
        self.networks = {name: SlowNetworks(networks.category) for name, networks in self.networks.items()}


def build(settings: Settings) -> TrackingService:
    transport = ZenohTransport(settings.service, settings.zenoh_listen, (), settings.max_payload_bytes)
    return TrackingService(settings, SlowProvider("mug"), InMemorySessionStore(), transport)


if __name__ == "__main__":
    run(Settings(), build)
    print("loaded", *(name for name in ("torch", "service.bundles", "fastapi") if name in sys.modules))  # noqa: T201

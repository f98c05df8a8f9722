"""A frame that hangs holds up its own session and no other: time runs out for those, and their clients are heard of."""

import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from captra.categories import CATEGORIES
from tests.service.support import CentreNetworks, CentreProvider, blob, f32, running, zenoh_client

TIMEOUT_S = 20


class Hanging(CentreNetworks):
    """Answers once the gate is open."""

    def __init__(self) -> None:
        super().__init__(CATEGORIES["mug"])
        self.asked, self.gate = threading.Event(), threading.Event()

    def coordinates(self, points_canonical, neighborhoods):  # type: ignore[no-untyped-def]
        self.asked.set()
        self.gate.wait(TIMEOUT_S)
        return super().coordinates(points_canonical, neighborhoods)


def wait_until(done: Callable[[], bool]) -> None:
    deadline_s = time.monotonic() + TIMEOUT_S / 2
    while not done():
        assert time.monotonic() < deadline_s, "it was held up"
        time.sleep(0.02)


def test_a_frame_that_hangs_holds_up_no_other_session() -> None:
    networks, provider = Hanging(), CentreProvider()
    provider.networks["mug"] = networks
    with running(provider=provider) as service, ThreadPoolExecutor(1) as client:
        assert service.service.readiness.wait_prepared(60)
        hung, idle = (service.open_session(idle_timeout_s=0.5)["session_id"] for _ in range(2))
        awaited = service.open_session()
        frame = client.submit(service.post_frame, hung, f32(blob()))
        try:
            assert networks.asked.wait(TIMEOUT_S)
            wait_until(lambda: service.http.get(f"/v1/sessions/{idle}").status_code == 404)
            with zenoh_client(service.endpoint) as network:
                sessions = [service.service.registry.get(awaited["session_id"])]
                key = f"captra/default/sessions/{awaited['session_id']}/client"
                token = network.liveliness().declare_token(key)
                wait_until(lambda: sessions[0].record.has_client)
                token.undeclare()
        finally:
            networks.gate.set()
        frame.result(TIMEOUT_S)

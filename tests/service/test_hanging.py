"""A frame that hangs holds up its own session and no other: time runs out for those, and their clients are heard of."""

from concurrent.futures import ThreadPoolExecutor

from tests.service.support import TIMEOUT_S, Running, blob, f32, wait_until, zenoh_client


def test_a_frame_that_hangs_holds_up_no_other_session(service: Running) -> None:
    networks = service.provider.networks["mug"]
    hung, idle = (service.open_session(idle_timeout_s=0.5)["session_id"] for _ in range(2))
    awaited = service.open_session()["session_id"]
    networks.gate.clear()
    with ThreadPoolExecutor(1) as client:
        frame = client.submit(service.post_frame, hung, f32(blob()))
        try:
            assert networks.asked.wait(TIMEOUT_S)
            wait_until(lambda: service.http.get(f"/v1/sessions/{idle}").status_code == 404)
            session = service.service.registry.get(awaited)
            with zenoh_client(service.endpoint) as network:
                token = network.liveliness().declare_token(f"captra/default/sessions/{awaited}/client")
                wait_until(lambda: session.record.has_client)
                token.undeclare()
        finally:
            networks.gate.set()
        frame.result(TIMEOUT_S)

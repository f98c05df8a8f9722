"""Sessions belong to the deployment, not to the process: another one goes on with them."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import httpx
import numpy as np
import pytest

from captra.geometry import Pose
from service.liveness import CloseReason
from service.registry import NewSession
from service.rejections import NotReadyError
from service.store import InMemorySessionStore
from tests.service.support import (
    Camera,
    CentreProvider,
    blob,
    f32,
    free_endpoint,
    inbox,
    late_inbox,
    running,
    session_body,
    wait_until_heard,
    zenoh_client,
)


def test_next_process_goes_on_under_the_same_id_and_keys_from_the_last_trusted_pose() -> None:
    store, endpoint = InMemorySessionStore(), free_endpoint()
    with running("mug", store=store, endpoint=endpoint) as first:
        assert first.service.readiness.wait_prepared(60)  # or the first frame waits, past its time-out
        opened = first.open_session(frame_id="wrist", idle_timeout_s=77)
        for seq, x in enumerate((0.02, 0.04, 0.06)):
            assert first.post_frame(opened["session_id"], f32(blob((x, 0, 0.5))), seq).status_code == 200
        closed = first.open_session()["session_id"]
        first.http.delete(f"/v1/sessions/{closed}")
    with running("mug", store=store, endpoint=endpoint) as second, zenoh_client(endpoint) as network:
        assert second.service.readiness.wait_prepared(60)
        shown = second.session(opened["session_id"])
        assert shown["zenoh"] == opened["zenoh"]
        assert (shown["frame_id"], shown["idle_timeout_s"]) == ("wrist", 77)
        assert shown["last_result"]["parts"][0]["translation"] == pytest.approx([0.06, 0, 0.5], abs=2e-3)
        assert second.post_frame(opened["session_id"], f32(blob()), 2).json()["reason"] == "repeated-seq"
        poses = inbox(network, opened["zenoh"]["pose"])
        Camera(network, opened["zenoh"]["cloud"]).put(f32(blob((0.08, 0, 0.5))), 3)
        assert poses.message(0)["parts"][0]["translation"] == pytest.approx([0.08, 0, 0.5], abs=2e-3)
        assert second.http.get(f"/v1/sessions/{closed}").status_code == 404


def test_untrusted_poses_are_not_gone_on_from() -> None:
    store = InMemorySessionStore()
    with running("mug", store=store) as first:
        opened = first.open_session()
        first.provider.networks["mug"].doubtful = True
        result = first.post_frame(opened["session_id"], f32(blob((0.02, 0, 0.5))), 0).json()
        assert result["state"] != "tracking"
    trusted = store.load()[0].trusted
    assert (trusted.seq, trusted.pose.translation[0].tolist()) == (None, [0, 0, 0.5])


def test_frames_that_were_doubted_before_a_restart_do_not_count_as_dropped_after_it() -> None:
    store = InMemorySessionStore()
    with running("mug", store=store) as first:
        assert first.service.readiness.wait_prepared(60)
        session_id = first.open_session()["session_id"]
        for seq in range(6):
            assert first.post_frame(session_id, f32(blob()), seq).status_code == 200
            first.provider.networks["mug"].doubtful = True
    assert store.load()[0].trusted.seq == 0
    with running("mug", store=store) as second:
        assert second.service.readiness.wait_prepared(60)
        assert second.post_frame(session_id, f32(blob()), 0).json()["reason"] == "repeated-seq"
        for seq, dropped in ((6, 0), (9, 2)):
            assert second.post_frame(session_id, f32(blob()), seq).status_code == 200
            assert second.session(session_id)["counters"]["dropped"] == dropped


def test_a_session_that_is_gone_on_with_is_in_doubt_until_a_frame_tells() -> None:
    store, endpoint = InMemorySessionStore(), free_endpoint()
    with running("mug", store=store, endpoint=endpoint) as first:
        session_id = first.open_session()["session_id"]
        first.post_frame(session_id, f32(blob()), 0)
        first.provider.networks["mug"].doubtful = True
        for seq in range(1, 10):
            result = first.post_frame(session_id, f32(blob()), seq).json()
        assert result["state"] == "lost"
    with running("mug", store=store, endpoint=endpoint) as second, zenoh_client(endpoint) as network:
        assert second.service.readiness.wait_prepared(60)
        pose = second.http.get(f"/v1/sessions/{session_id}/pose").json()
        assert (pose["state"], pose["confidence"], pose["seq"]) == ("uncertain", 0, None)
        assert second.session(session_id)["state"] == "uncertain"
        assert second.metric('captra_sessions{state="uncertain"}') == 1
        assert second.metric('captra_sessions{state="tracking"}') == 0
        events = inbox(network, f"captra/default/sessions/{session_id}/event")
        wait_until_heard(network)
        opened = second.open_session()
        assert opened["state"] == "tracking"  # a client has just said where that object is
        assert second.post_frame(session_id, f32(blob()), 10).json()["state"] == "tracking"
        event = events.wait_for("state")
        assert (event["previous_state"], event["state"], event["seq"]) == ("uncertain", "tracking", 10)


def test_a_session_that_is_gone_on_with_and_sees_nothing_is_never_called_tracking() -> None:
    store, endpoint = InMemorySessionStore(), free_endpoint()
    with running("mug", store=store, endpoint=endpoint) as first:
        session_id = first.open_session()["session_id"]
    with running("mug", store=store, endpoint=endpoint) as second, zenoh_client(endpoint) as network:
        assert second.service.readiness.wait_prepared(60)
        poses, events = (inbox(network, f"captra/default/sessions/{session_id}/{key}") for key in ("pose", "event"))
        wait_until_heard(network)
        states = []
        for seq in range(6):
            assert second.post_frame(session_id, f32(blob((5, 5, 5))), seq).status_code == 422
            states.append(second.session(session_id)["state"])
        assert states[0] == "uncertain"
        assert states[-1] == "lost"
        assert "tracking" not in states
        told = events.wait_for("state")
        assert (told["previous_state"], told["state"]) == ("uncertain", "lost")
        assert poses.message(0)["state"] == "lost"


def test_session_whose_model_is_missing_stays_stored() -> None:
    store = InMemorySessionStore()
    with running("mug", store=store) as first:
        session_id = first.open_session()["session_id"]
    with running("bottle", store=store) as second:
        assert second.service.readiness.wait_prepared(60)
        second.service.readiness.check()
        assert second.http.get(f"/v1/sessions/{session_id}").status_code == 404
    assert [record.session_id for record in store.load()] == [session_id]


def test_no_session_is_opened_before_those_of_the_last_process_go_on() -> None:
    store, provider = InMemorySessionStore(), CentreProvider("mug")
    with running("mug", store=store) as first:
        session_id = first.open_session()["session_id"]
    provider.loading.clear()
    with running(provider=provider, store=store) as second:
        answer = second.http.post("/v1/sessions", json=session_body())
        assert (answer.status_code, answer.json()["reason"]) == (503, "not-ready")
        assert [record.session_id for record in store.load()] == [session_id]
        provider.loading.set()
        opened = second.open_session()
        listed = second.http.get("/v1/sessions").json()["sessions"]
        assert [each["session_id"] for each in listed] == [session_id, opened["session_id"]]


def test_session_that_is_open_already_is_not_gone_on_with_once_more() -> None:
    store, provider = InMemorySessionStore(), CentreProvider("mug")
    with running("mug", store=store) as first:
        first.open_session()
    provider.loading.clear()
    with running(provider=provider, store=store) as second, zenoh_client(second.endpoint) as network:
        pose = Pose.from_size(np.eye(3)[None], np.array([[0, 0, 0.5]]), np.full((1, 3), 0.1))
        order = NewSession("mug", "realtime", "camera", idle_timeout_s=300, pose=pose)
        session = second.service.registry.open(order)
        provider.loading.set()
        assert second.service.readiness.wait_prepared(60)
        assert second.service.registry.get(session.session_id) is session
        assert second.metric("captra_sessions_restored_total") == 1
        poses = inbox(network, f"captra/default/sessions/{session.session_id}/pose")
        assert second.post_frame(session.session_id, f32(blob()), 0).status_code == 200
        Camera(network, f"captra/default/sessions/{session.session_id}/cloud").put(f32(blob()), 1)
        assert [poses.message(index)["seq"] for index in range(2)] == [0, 1]
        assert second.http.delete(f"/v1/sessions/{session.session_id}").status_code == 204
        assert not [thread for thread in threading.enumerate() if thread.name.endswith(session.session_id)]


def test_closed_and_expired_sessions_are_forgotten() -> None:
    store = InMemorySessionStore()
    with running("mug", store=store) as service:
        service.http.delete(f"/v1/sessions/{service.open_session()['session_id']}")
        expiring = service.open_session(idle_timeout_s=0.1)["session_id"]
        deadline = time.monotonic() + 10
        while any(record.session_id == expiring for record in store.load()):
            assert time.monotonic() < deadline
        assert store.load() == []


def test_stopping_ends_quickly_while_clients_stream_and_listen() -> None:
    with (
        running("mug", shutdown_timeout_s=60) as service,
        zenoh_client(service.endpoint) as network,
        ExitStack() as late_inboxes,
    ):
        assert service.service.readiness.wait_prepared(60)
        opened = [service.open_session() for _ in range(3)]
        events = [inbox(network, each["zenoh"]["event"]) for each in opened]
        late = late_inboxes.enter_context(late_inbox(network, opened[0]["zenoh"]["pose"]))
        cameras = [Camera(network, each["zenoh"]["cloud"]) for each in opened]
        stop = threading.Event()

        def put() -> None:
            seq = 0
            while not stop.wait(0.002):
                for camera in cameras:
                    camera.put(f32(blob()), seq)
                seq += 1

        with ThreadPoolExecutor(1) as pool:
            putting = pool.submit(put)
            try:
                for each in opened:
                    inbox(network, each["zenoh"]["pose"]).message(5)
                started_s = time.monotonic()
                service.service.stop()
                assert time.monotonic() - started_s < 20  # what hangs is waited for three times as long
                assert not [thread for thread in threading.enumerate() if thread.name.startswith("captra-stream")]
                assert [inbox.wait_for("closing")["reason"] for inbox in events] == ["shutdown"] * 3
            finally:
                stop.set()
            putting.result()
        assert len(late) > 0
        with pytest.raises(NotReadyError):
            service.service.readiness.check()


def test_stopping_twice_is_harmless() -> None:
    with running("mug") as service:
        service.service.stop()
        assert service.http.post("/v1/sessions", json={}).status_code == 422
        with pytest.raises(httpx.HTTPStatusError, match="503"):
            service.http.get("/v1/health/ready").raise_for_status()


def test_sessions_cannot_be_opened_while_the_service_stops() -> None:
    with running(provider=CentreProvider("mug")) as service:
        assert service.service.readiness.wait_prepared(60)
        service.service.registry.shut_down()
        answer = service.http.post("/v1/sessions", json=session_body())
        assert (answer.status_code, answer.json()["reason"]) == (503, "not-ready")
        service.service.registry.sweep()
        with pytest.raises(Exception, match="no session"):
            service.service.registry.close("f00", CloseReason.DELETED)

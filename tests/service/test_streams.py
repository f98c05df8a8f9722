"""Clouds in and poses out over a real Zenoh router."""

import threading
import time

import pytest
import zenoh

from captra.pose_memory import NO_ERROR
from service.envelopes import Envelope
from service.rejections import UnknownEncodingError
from service.session import Session
from service.transport import Stream
from tests.service.support import (
    I16,
    STAMP_NS,
    Camera,
    Running,
    blob,
    f32,
    free_endpoint,
    i16,
    inbox,
    late_inbox,
    running,
    token_inbox,
    zenoh_client,
)


def test_every_cloud_gets_a_result_with_all_fields(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session(frame_id="camera_color_optical_frame")
    poses = inbox(network, opened["zenoh"]["pose"])
    camera = Camera(network, opened["zenoh"]["cloud"])
    for seq, x in enumerate((0.0, 0.01, 0.02)):
        camera.put(f32(blob((x, 0, 0.5))), seq, STAMP_NS + seq)
        result = poses.message(seq)
        assert list(result) == [
            "session_id", "seq", "stamp_ns", "frame_id", "state", "confidence", "parts", "joints", "looks",
            "timing_ms",
        ]  # fmt: skip
        assert result["session_id"] == opened["session_id"]
        assert (result["seq"], result["stamp_ns"]) == (seq, STAMP_NS + seq)
        assert result["frame_id"] == "camera_color_optical_frame"
        assert result["state"] == "tracking"
        assert 0.5 < result["confidence"] <= 1
        assert [list(part) for part in result["parts"]] == [["name", "translation", "quat_xyzw", "size"]]
        assert result["parts"][0]["name"] == "mug"
        assert result["parts"][0]["translation"] == pytest.approx([x, 0, 0.5], abs=2e-3)
        assert result["parts"][0]["quat_xyzw"] == pytest.approx([0, 0, 0, 1], abs=1e-6)
        assert list(result["timing_ms"]) == ["queue", "sample", "infer", "solve", "total"]
        assert 0 <= result["timing_ms"]["queue"] < result["timing_ms"]["total"]
    assert poses.sample(0).encoding == zenoh.Encoding.APPLICATION_JSON


def test_i16_means_tenths_of_a_millimetre(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session()
    poses = inbox(network, opened["zenoh"]["pose"])
    Camera(network, opened["zenoh"]["cloud"], I16).put(i16(blob((0.01, 0, 0.5))))
    assert poses.message(0)["parts"][0]["translation"] == pytest.approx([0.01, 0, 0.5], abs=2e-3)


def test_articulated_objects_report_parts_and_joints(service: Running, network: zenoh.Session) -> None:
    service.provider.networks["laptop_articulated"].found_error = NO_ERROR  # a blob does not quite fill the boxes
    opened = service.open_session("laptop_articulated")
    poses = inbox(network, opened["zenoh"]["pose"])
    Camera(network, opened["zenoh"]["cloud"]).put(f32(blob()))
    result = poses.message(0)
    assert [part["name"] for part in result["parts"]] == ["base", "display"]
    assert [(joint["name"], joint["kind"]) for joint in result["joints"]] == [("hinge", "revolute")]
    assert result["joints"][0]["value"] == pytest.approx(0, abs=1e-6)


def test_newest_cloud_wins_and_dropped_ones_are_counted(service: Running, network: zenoh.Session) -> None:
    networks = service.provider.networks["mug"]
    opened = service.open_session()
    poses = inbox(network, opened["zenoh"]["pose"])
    camera = Camera(network, opened["zenoh"]["cloud"])
    networks.gate.clear()
    camera.put(f32(blob()), 0)
    assert networks.asked.wait(10)  # frame 0 is in hand; what comes now has to wait
    for seq in range(1, 6):
        camera.put(f32(blob()), seq)
    barrier(service, network)
    networks.gate.set()
    assert [poses.message(0)["seq"], poses.message(1)["seq"]] == [0, 5]
    counters = service.session(opened["session_id"])["counters"]
    assert (counters["processed"], counters["dropped"], counters["rejected"]) == (2, 4, 0)
    assert service.metric("captra_frames_dropped_total") == 4
    assert poses.message(1)["timing_ms"]["queue"] > 0


def barrier(service: Running, network: zenoh.Session) -> None:
    """Wait until the router has passed on all that a client put so far: what one client puts stays in order."""
    with zenoh_client(service.endpoint) as witness:
        witnessed = inbox(witness, "captra/test/barrier")
        camera, patience = Camera(network, "captra/test/barrier"), time.monotonic() + 10
        while not len(witnessed):  # what is put before the router has heard of the witness is lost
            assert time.monotonic() < patience, "nothing came"
            camera.put(b"")
            time.sleep(0.02)


def test_slow_subscriber_never_slows_tracking() -> None:
    endpoint = f"{free_endpoint()}#so_sndbuf=8192"
    with (
        running("mug", endpoint=endpoint) as service,
        zenoh_client(service.endpoint) as slow,
        zenoh_client(service.endpoint) as network,
    ):
        assert service.service.readiness.wait_prepared(30)
        opened = service.open_session()
        stuck = threading.Event()

        def hold(sample: zenoh.Sample) -> None:
            stuck.wait()

        for key in ("pose", "event"):  # reads nothing any more: its link fills up
            slow.declare_subscriber(opened["zenoh"][key], zenoh.handlers.Callback(hold, indirect=False))
        events = inbox(network, opened["zenoh"]["event"])
        session = service.service.registry.get(opened["session_id"])
        bad = Envelope("text/" + 100 * "x", b"", None, 0.0)
        for _ in range(3000):  # each an event; a put that blocked would wait five seconds for the slow one
            with pytest.raises(UnknownEncodingError):
                session.process(bad)
        assert service.post_frame(opened["session_id"], f32(blob())).status_code == 200
        assert events.message(0)["reason"] == "unknown-encoding"
        assert service.metric("captra_events_dropped_total") > 0
        stuck.set()


def test_late_subscriber_gets_the_last_result(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session()
    first = inbox(network, opened["zenoh"]["pose"])
    camera = Camera(network, opened["zenoh"]["cloud"])
    for seq in range(3):
        camera.put(f32(blob()), seq)
        first.message(seq)
    with late_inbox(network, opened["zenoh"]["pose"]) as late:
        assert late.sample(0).payload.to_bytes() == first.sample(2).payload.to_bytes()


def test_two_sessions_side_by_side_do_not_disturb_each_other(service: Running, network: zenoh.Session) -> None:
    starts = {"left": (-0.3, 0.0, 0.5), "right": (0.3, 0.0, 0.8)}
    opened = {name: service.open_session(translation=start) for name, start in starts.items()}
    poses = {name: inbox(network, opened[name]["zenoh"]["pose"]) for name in starts}
    cameras = {name: Camera(network, opened[name]["zenoh"]["cloud"]) for name in starts}
    for seq in range(20):
        for name, start in starts.items():
            step = 0.005 * seq * (1 if name == "left" else -1)
            cameras[name].put(f32(blob((start[0] + step, *start[1:]))), seq, STAMP_NS + seq)
        for name, start in starts.items():
            result = poses[name].message(seq)
            step = 0.005 * seq * (1 if name == "left" else -1)
            assert (result["session_id"], result["seq"]) == (opened[name]["session_id"], seq)
            assert result["parts"][0]["translation"] == pytest.approx([start[0] + step, *start[1:]], abs=5e-3)
        cameras["left"].put(b"\0" * 7, 0)  # a neighbour's broken clouds
    right = service.session(opened["right"]["session_id"])["counters"]
    assert (right["received"], right["processed"], right["rejected"]) == (20, 20, 0)


def test_state_changes_are_told(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session()
    events = inbox(network, opened["zenoh"]["event"])
    poses = inbox(network, opened["zenoh"]["pose"])
    camera = Camera(network, opened["zenoh"]["cloud"])
    camera.put(f32(blob()), 0)
    poses.message(0)
    service.provider.networks["mug"].doubtful = True
    camera.put(f32(blob()), 1, STAMP_NS + 1)
    result = poses.message(1)
    event = events.message(0)
    assert result["state"] != "tracking"
    assert event["kind"] == "state"
    assert (event["previous_state"], event["state"]) == ("tracking", result["state"])
    assert (event["seq"], event["stamp_ns"], event["session_id"]) == (1, STAMP_NS + 1, opened["session_id"])
    assert events.sample(0).encoding == zenoh.Encoding.APPLICATION_JSON
    assert service.metric(f'captra_sessions{{state="{result["state"]}"}}') == 1
    assert service.metric('captra_sessions{state="tracking"}') == 0


def test_tokens_tell_that_service_and_session_are_alive(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session()
    prefix = opened["zenoh"]["cloud"].removesuffix("/cloud")
    tokens = token_inbox(network, "captra/default/**")
    alive = {str(tokens.sample(index).key_expr) for index in range(2)}
    assert alive == {"captra/default/alive", f"{prefix}/alive"}
    service.http.delete(f"/v1/sessions/{opened['session_id']}")
    gone = tokens.sample(2)
    assert (gone.kind, str(gone.key_expr)) == (zenoh.SampleKind.DELETE, f"{prefix}/alive")


def test_whoever_is_told_of_a_session_finds_it(
    service: Running, network: zenoh.Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    attach = service.service.transport.attach

    def attach_slowly(session: Session) -> Stream:
        stream = attach(session)
        time.sleep(0.3)
        return stream

    monkeypatch.setattr(service.service.transport, "attach", attach_slowly)
    tokens = token_inbox(network, "captra/default/sessions/*/alive")
    opening = threading.Thread(target=service.open_session)
    opening.start()
    session_id = str(tokens.sample(0).key_expr).split("/")[-2]
    assert service.http.get(f"/v1/sessions/{session_id}").status_code == 200
    opening.join()


def test_session_follows_its_client_after_a_grace_time() -> None:
    with running("mug", client_grace_s=0.3) as service, zenoh_client(service.endpoint) as network:
        opened = service.open_session()
        events = inbox(network, opened["zenoh"]["event"])
        poses = inbox(network, opened["zenoh"]["pose"])
        with zenoh_client(service.endpoint) as client:
            token = client.liveliness().declare_token(opened["zenoh"]["cloud"].removesuffix("cloud") + "client")
            Camera(client, opened["zenoh"]["cloud"]).put(f32(blob()))
            poses.message(0)
            assert service.session(opened["session_id"])["counters"]["processed"] == 1
            token.undeclare()
        assert events.wait_for("closing")["reason"] == "client-gone"
        assert service.http.get(f"/v1/sessions/{opened['session_id']}").status_code == 404


def test_metrics_tell_of_every_stage(service: Running) -> None:
    session_id = service.open_session()["session_id"]
    for seq in range(3):
        assert service.post_frame(session_id, f32(blob()), seq).status_code == 200
    for stage in ("queue", "decode", "sample", "infer", "solve", "publish", "total"):
        assert service.metric(f'captra_stage_seconds_count{{stage="{stage}"}}') == 3
        assert service.metric(f'captra_stage_seconds_sum{{stage="{stage}"}}') > 0
    assert service.metric("captra_frames_received_total") == 3
    assert service.metric("captra_frames_processed_total") == 3
    assert service.metric("captra_confidence_count") == 3
    assert service.metric('captra_sessions{state="tracking"}') == 1

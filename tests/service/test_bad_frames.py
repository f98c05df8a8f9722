"""Every frame that is refused, by HTTP and by Zenoh: reason, counter, event; and the session stays as it was."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
import zenoh

from service.codecs import CDR
from tests.service.ros2.clouds import cdr
from tests.service.support import F32, I16, STAMP_NS, Camera, Running, blob, f32, i16, inbox, running, zenoh_client

NAN = f32(np.full((20, 3), np.nan))


@pytest.fixture(scope="module")
def limited() -> Iterator[Running]:
    with running("mug", max_points=1000, max_payload_bytes=12_600) as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


@dataclass
class Bad:
    """A frame that must be refused, after frame 5 was tracked."""

    reason: str
    status: int
    payload: bytes
    encoding: str = F32
    seq: int = 6
    options: dict[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.reason}-{len(self.payload)}"


BOTH = [
    Bad("empty-cloud", 422, b""),
    Bad("empty-cloud", 422, b"", I16),
    Bad("wrong-byte-count", 422, f32(blob())[:-1]),
    Bad("wrong-byte-count", 422, i16(blob())[:-2], I16),
    Bad("not-finite", 422, NAN),
    Bad("coordinates-out-of-range", 422, f32(np.full((20, 3), 1e9))),
    Bad("too-many-points", 413, f32(blob(points=1002))),
    Bad("payload-too-large", 413, f32(blob(points=1100))),
    Bad("unknown-encoding", 415, f32(blob()), "image/png"),
    Bad("unknown-encoding", 415, cdr(blob()), "application/cdr;sensor_msgs/msg/Image"),
    Bad("empty-cloud", 422, b"", CDR),
    Bad("empty-cloud", 422, cdr(np.zeros((0, 3))), CDR),
    Bad("malformed-message", 422, f32(blob()), CDR),
    Bad("malformed-message", 422, cdr(blob())[:-20], CDR),
    Bad("unsupported-fields", 422, cdr(blob(), fields=(("x", "f4"), ("y", "f4"))), CDR),
    Bad("wrong-byte-count", 422, cdr(blob(), cut=9), CDR),
    Bad("too-many-points", 413, cdr(np.zeros((1001, 3)), fields=()), CDR),
    Bad("unknown-encoding", 415, f32(blob()), ""),
    Bad("repeated-seq", 409, f32(blob()), seq=5),
    Bad("stale-seq", 409, f32(blob()), seq=4),
    Bad("no-points-near-object", 422, f32(blob((3, 0, 0.5)))),
    Bad("no-points-near-object", 422, f32(blob(points=8))),
]
ZENOH_ONLY = [
    Bad("missing-attachment", 0, f32(blob()), options={"attachment": None}),
    Bad("malformed-attachment", 0, f32(blob()), options={"attachment": b"\0" * 8}),
]


def rejections(service: Running, reason: str) -> float:
    return service.metric(f'captra_frames_rejected_total{{reason="{reason}"}}')


@pytest.mark.parametrize("bad", BOTH, ids=str)
def test_bad_frame_by_http(limited: Running, bad: Bad) -> None:
    session_id = limited.open_session()["session_id"]
    assert limited.post_frame(session_id, f32(blob()), 5).status_code == 200
    before, count = limited.session(session_id), rejections(limited, bad.reason)
    answer = limited.post_frame(session_id, bad.payload, bad.seq, bad.encoding)
    assert answer.headers["Content-Type"] == "application/problem+json"
    assert (answer.status_code, answer.json()["reason"]) == (bad.status, bad.reason)
    assert rejections(limited, bad.reason) == count + 1
    stays_as_it_was(limited, before, bad)
    assert limited.post_frame(session_id, f32(blob()), 6).status_code == 200
    limited.http.delete(f"/v1/sessions/{session_id}")


@pytest.mark.parametrize("bad", BOTH + ZENOH_ONLY, ids=str)
def test_bad_frame_by_zenoh(limited: Running, bad: Bad) -> None:
    with zenoh_client(limited.endpoint) as network:
        opened = limited.open_session()
        poses, events = (inbox(network, opened["zenoh"][key]) for key in ("pose", "event"))
        camera = Camera(network, opened["zenoh"]["cloud"])
        camera.put(f32(blob()), 5)
        poses.message(0)
        before, count = limited.session(opened["session_id"]), rejections(limited, bad.reason)
        encoding = bad.encoding or str(zenoh.Encoding.ZENOH_BYTES)
        camera.put(bad.payload, bad.seq, encoding=encoding, **bad.options)
        event = events.message(0)
        assert (event["kind"], event["reason"]) == ("rejected", bad.reason)
        assert (event["session_id"], event["state"]) == (opened["session_id"], "tracking")
        assert event["detail"]
        header_known = not bad.options and bad.reason not in {"unknown-encoding", "payload-too-large"}
        if not bad.encoding.startswith(CDR):  # what is known of a message depends on how far it could be read
            assert (event["seq"], event["stamp_ns"]) == ((bad.seq, STAMP_NS) if header_known else (None, None))
        assert rejections(limited, bad.reason) == count + 1
        stays_as_it_was(limited, before, bad)
        camera.put(f32(blob()), 6)
        assert poses.message(1)["seq"] == 6
        assert len(events) == 1
        limited.http.delete(f"/v1/sessions/{opened['session_id']}")


def stays_as_it_was(service: Running, before: dict[str, Any], bad: Bad) -> None:
    after = service.session(before["session_id"])
    assert after["last_result"] == before["last_result"]
    assert after["state"] == before["state"]
    assert after["counters"] == {
        "received": 2, "processed": 1, "dropped": 0, "rejected": 1, "rejected_by_reason": {bad.reason: 1},
    }  # fmt: skip


def test_defect_in_the_networks_costs_one_frame(service: Running, network: zenoh.Session) -> None:
    networks = service.provider.networks["mug"]
    opened = service.open_session()
    events, poses = (inbox(network, opened["zenoh"][key]) for key in ("event", "pose"))
    camera = Camera(network, opened["zenoh"]["cloud"])
    networks.broken = True
    camera.put(f32(blob()), 1)
    assert events.message(0)["reason"] == "internal-error"
    answer = service.post_frame(opened["session_id"], f32(blob()), 1)
    assert (answer.status_code, answer.json()["reason"]) == (500, "internal-error")
    networks.broken = False
    camera.put(f32(blob()), 1)
    assert poses.message(0)["seq"] == 1


def test_flood_of_bad_frames_does_not_reach_a_neighbour(service: Running, network: zenoh.Session) -> None:
    bad, good = service.open_session(), service.open_session()
    poses = inbox(network, good["zenoh"]["pose"])
    bad_camera, good_camera = (Camera(network, opened["zenoh"]["cloud"]) for opened in (bad, good))
    rng = np.random.default_rng(2)
    for seq in range(50):
        for _ in range(10):
            bad_camera.put(rng.bytes(int(rng.integers(0, 300))), int(rng.integers(0, 2**63)), attachment=rng.bytes(16))
        good_camera.put(f32(blob()), seq)
        assert poses.message(seq)["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=2e-3)
    counters = service.session(good["session_id"])["counters"]
    assert (counters["processed"], counters["rejected"]) == (50, 0)

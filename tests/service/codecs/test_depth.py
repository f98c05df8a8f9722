import io
from collections.abc import Iterator
from typing import Any

import httpx
import numpy as np
import pytest
import zenoh
from PIL import Image

from service.codecs import DEPTH_F32, DEPTH_PNG, DEPTH_U16
from service.codecs.masks import BOX
from service.envelopes import pack_attachment
from tests.service.support import STAMP_NS, Camera, Inbox, Running, inbox, running, zenoh_client


@pytest.fixture(scope="module")
def service() -> Iterator[Running]:
    with running() as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


@pytest.fixture(scope="module")
def network(service: Running) -> Iterator[zenoh.Session]:
    with zenoh_client(service.endpoint) as session:
        yield session


WIDTH, HEIGHT = 64, 48
CAMERA = {"fx": 60.0, "fy": 60.0, "cx": 31.5, "cy": 23.5, "width": WIDTH, "height": HEIGHT}


def png(pixels: np.ndarray) -> bytes:
    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, "PNG")
    return buffer.getvalue()


def disc() -> np.ndarray:
    """Depth, mm, of a disc of 8 cm at (0, 0, 0.5) m before a wall 3 m away, with pixels without depth in between."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    radius_px = np.hypot(u - CAMERA["cx"], v - CAMERA["cy"])
    return np.select([radius_px < 4.8, radius_px < 8], [500, 0], 3000).astype(np.uint16)


DEPTH_MM = disc()
DEPTH_M = (DEPTH_MM * 1e-3).astype("<f4")
FORMS = {
    DEPTH_PNG: png(DEPTH_MM),
    DEPTH_U16: DEPTH_MM.astype("<u2").tobytes(),
    DEPTH_F32: np.where(DEPTH_M == 0, np.float32(np.nan), DEPTH_M).tobytes(),
}


@pytest.mark.parametrize("encoding", FORMS)
def test_depth_images_are_tracked_by_http(service: Running, encoding: str) -> None:
    opened = service.open_session(camera=CAMERA)
    assert encoding in opened["encodings"]
    answer = service.post_frame(opened["session_id"], FORMS[encoding], 3, encoding)
    assert answer.status_code == 200, answer.text
    assert answer.json()["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=6e-3)
    assert answer.json()["stamp_ns"] == STAMP_NS


def test_depth_images_are_tracked_by_zenoh(service: Running, network: zenoh.Session) -> None:
    opened = service.open_session(camera=CAMERA)
    poses = inbox(network, opened["zenoh"]["pose"])
    Camera(network, opened["zenoh"]["cloud"], DEPTH_PNG).put(FORMS[DEPTH_PNG], 3)
    assert poses.message(0)["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=6e-3)


def test_units_of_depth_are_the_cameras(service: Running) -> None:
    opened = service.open_session(camera=CAMERA | {"metres_per_unit": 0.0005})
    answer = service.post_frame(opened["session_id"], png(2 * DEPTH_MM), 0, DEPTH_PNG)
    assert answer.json()["parts"][0]["translation"] == pytest.approx([0, 0, 0.5], abs=6e-3)


def test_size_may_be_left_to_the_images(service: Running) -> None:
    opened = service.open_session(camera={name: CAMERA[name] for name in ("fx", "fy", "cx", "cy")})
    assert DEPTH_PNG in opened["encodings"]
    assert DEPTH_U16 not in opened["encodings"]
    assert service.post_frame(opened["session_id"], FORMS[DEPTH_PNG], 0, DEPTH_PNG).status_code == 200


def test_without_a_camera_depth_is_an_unknown_encoding(service: Running) -> None:
    opened = service.open_session()
    answer = service.post_frame(opened["session_id"], FORMS[DEPTH_PNG], 0, DEPTH_PNG)
    assert (answer.status_code, answer.json()["reason"]) == (415, "unknown-encoding")
    assert "camera" in answer.json()["detail"]


BAD: list[tuple[str, str, bytes]] = [
    ("empty-cloud", DEPTH_PNG, b""),
    ("malformed-image", DEPTH_PNG, b"\x89PNG\r\n\x1a\n"),
    ("malformed-image", DEPTH_PNG, FORMS[DEPTH_PNG][:-60]),
    ("malformed-image", DEPTH_PNG, b"GIF89a" + bytes(100)),
    ("malformed-image", DEPTH_PNG, png(DEPTH_MM.astype(np.uint8))),
    ("malformed-image", DEPTH_PNG, png(np.zeros((HEIGHT, WIDTH, 3), np.uint8))),
    ("wrong-image-size", DEPTH_PNG, png(DEPTH_MM[:, :-1].copy())),
    ("empty-cloud", DEPTH_U16, b""),
    ("wrong-byte-count", DEPTH_U16, FORMS[DEPTH_U16][:-2]),
    ("wrong-byte-count", DEPTH_F32, FORMS[DEPTH_U16]),
    ("no-points-near-object", DEPTH_PNG, png(np.zeros_like(DEPTH_MM))),
    ("no-points-near-object", DEPTH_F32, np.full((HEIGHT, WIDTH), np.nan, "<f4").tobytes()),
]


@pytest.mark.parametrize(("reason", "encoding", "payload"), BAD)
def test_bad_images_are_refused(service: Running, reason: str, encoding: str, payload: bytes) -> None:
    opened = service.open_session(camera=CAMERA)
    answer = service.post_frame(opened["session_id"], payload, 0, encoding)
    assert (answer.status_code, answer.json()["reason"]) == (422, reason)
    assert service.session(opened["session_id"])["counters"]["rejected_by_reason"] == {reason: 1}


def put_masked(service: Running, network: zenoh.Session, mask: bytes, **options: Any) -> tuple[Inbox, Inbox]:
    """One frame of an articulated object, whose background only a mask can tell."""
    opened = service.open_session("laptop_articulated", camera=CAMERA, **options)
    poses, events = (inbox(network, opened["zenoh"][key]) for key in ("pose", "event"))
    camera = Camera(network, opened["zenoh"]["cloud"], DEPTH_PNG)
    camera.put(FORMS[DEPTH_PNG], 0, attachment=pack_attachment(0, STAMP_NS) + mask)
    return poses, events


HALF = (DEPTH_MM == 500).astype(np.uint8)
HALF[:, :32] = 0
BOX_OF_HALF = BOX.pack(32, 20, 37, 28)


@pytest.mark.parametrize("mask", [png(HALF), png(255 * HALF)])
def test_object_masks_replace_the_networks_word(service: Running, network: zenoh.Session, mask: bytes) -> None:
    poses, _ = put_masked(service, network, mask, masks="object")
    for part in poses.message(0)["parts"]:
        assert part["translation"][0] > 0.005  # the middle of the right half of the disc
        assert part["translation"][2] == pytest.approx(0.5, abs=1e-3)


def test_boxes_say_what_is_outside(service: Running, network: zenoh.Session) -> None:
    poses, _ = put_masked(service, network, BOX_OF_HALF, masks="object")
    assert poses.message(0)["parts"][0]["translation"][0] > 0.005
    assert poses.message(0)["parts"][0]["translation"][2] == pytest.approx(0.5, abs=1e-3)


def test_frames_without_a_mask_are_left_to_the_network(service: Running, network: zenoh.Session) -> None:
    poses, _ = put_masked(service, network, b"", masks="parts")
    assert poses.message(0)["seq"] == 0


@pytest.mark.parametrize(
    ("mask", "options", "reason"),
    [
        (png(HALF), {}, "malformed-mask"),
        (BOX_OF_HALF, {}, "malformed-mask"),
        (bytes(7), {"masks": "object"}, "malformed-attachment"),
        (png(HALF[1:].copy()), {"masks": "object"}, "malformed-mask"),
        (png(HALF)[:40], {"masks": "object"}, "malformed-mask"),
        (png(3 * HALF), {"masks": "parts"}, "malformed-mask"),
        (BOX.pack(32, 0, 32, HEIGHT), {"masks": "object"}, "malformed-mask"),
        (BOX.pack(32, 0, WIDTH + 1, HEIGHT), {"masks": "object"}, "malformed-mask"),
    ],
)
def test_bad_masks_are_refused(
    service: Running, network: zenoh.Session, mask: bytes, options: dict[str, Any], reason: str
) -> None:
    _, events = put_masked(service, network, mask, **options)
    assert events.message(0)["reason"] == reason


def post_masked(service: Running, **options: Any) -> httpx.Response:
    opened = service.open_session("laptop_articulated", camera=CAMERA, masks="object")
    params = {"seq": 0, "stamp_ns": 5} | options.pop("params", {})
    return service.http.post(f"/v1/sessions/{opened['session_id']}/frames", params=params, **options)


@pytest.mark.parametrize(
    "options",
    [
        {"files": {"cloud": ("f", FORMS[DEPTH_PNG], DEPTH_PNG), "mask": ("m", png(HALF), "image/png")}},
        {"content": FORMS[DEPTH_PNG], "headers": {"Content-Type": DEPTH_PNG}, "params": {"box": "32,20,37,28"}},
        {"files": {"cloud": ("f", FORMS[DEPTH_PNG], DEPTH_PNG)}, "params": {"box": "32,20,37,28"}},
    ],
)
def test_masks_and_boxes_by_http(service: Running, options: dict[str, Any]) -> None:
    answer = post_masked(service, **options)
    assert answer.status_code == 200, answer.text
    assert answer.json()["parts"][0]["translation"][0] > 0.005


@pytest.mark.parametrize(
    "options",
    [
        {"files": {"mask": ("m", png(HALF), "image/png")}},
        {"files": {"cloud": ("f", FORMS[DEPTH_PNG], DEPTH_PNG), "masks": ("m", png(HALF), "image/png")}},
        {"files": {"cloud": ("f", FORMS[DEPTH_PNG], DEPTH_PNG)}, "data": {"mask": "m.png"}},
        {"content": b"--", "headers": {"Content-Type": "multipart/form-data; boundary=x"}},
        {"content": b"--", "headers": {"Content-Type": "multipart/form-data"}},
        {"content": FORMS[DEPTH_PNG], "headers": {"Content-Type": DEPTH_PNG}, "params": {"box": "1,2,3"}},
    ],
)
def test_malformed_forms_are_refused(service: Running, options: dict[str, Any]) -> None:
    answer = post_masked(service, **options)
    assert (answer.status_code, answer.json()["reason"]) == (422, "invalid-request")

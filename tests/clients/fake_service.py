"""The service's side of the wire, on real sockets, with scripted answers: what a client meets, without any networks."""

import json
import struct
import threading
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, Self

import numpy as np
import zenoh
from jaxtyping import Float32

from clients.service_process import free_ports

IDENTITY_XYZW = [0.0, 0.0, 0.0, 1.0]
TIMING = {"queue": 0.1, "sample": 1.0, "infer": 5.0, "solve": 0.5, "total": 6.6}
DECODERS: dict[str, Callable[[bytes], np.ndarray]] = {
    "application/vnd.captra.cloud.i16": lambda payload: np.frombuffer(payload, "<i2").reshape(-1, 3) * np.float32(1e-4),
    "application/vnd.captra.cloud.f32": lambda payload: np.frombuffer(payload, "<f4").reshape(-1, 3),
}

Answer = Callable[["FakeService", int, Float32[np.ndarray, "points 3"]], "dict[str, Any] | None"]


def at_centroid(service: "FakeService", seq: int, points: Float32[np.ndarray, "points 3"]) -> dict[str, Any]:
    """A result whose only part is at the mean of the points."""
    return {
        "state": "tracking",
        "confidence": 0.9,
        "parts": [
            {"name": "body", "translation": points.mean(axis=0).tolist(), "quat_xyzw": IDENTITY_XYZW, "size": [0.1] * 3}
        ],
        "joints": [],
    }


def numbers_of(sample: zenoh.Sample) -> tuple[int, int]:
    """Number and stamp of a cloud."""
    assert sample.attachment is not None
    seq, stamp_ns = struct.unpack("<Qq", sample.attachment.to_bytes())
    return seq, stamp_ns


@dataclass
class FakeService:
    """One session; `answer` says what comes of a cloud: members of a result, of an event (with `kind`), or nothing."""

    answer: Answer = at_centroid
    requests: list[tuple[str, str, Any]] = field(default_factory=list)
    clouds: list[tuple[int, int, Float32[np.ndarray, "points 3"]]] = field(default_factory=list)
    token_seen: threading.Event = field(default_factory=threading.Event)
    token_gone: threading.Event = field(default_factory=threading.Event)
    closed: threading.Event = field(default_factory=threading.Event)
    session_id: str = "s1"
    newest: zenoh.Sample | None = None
    arrived_seq: int = -1
    stopped: bool = False
    changed: threading.Condition = field(default_factory=threading.Condition)

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.http.server_port}"

    @property
    def stem(self) -> str:
        return f"captra/fake/sessions/{self.session_id}"

    def __enter__(self) -> Self:
        with ExitStack() as resources:
            self.http = ThreadingHTTPServer(("127.0.0.1", 0), handler_of(self))
            resources.callback(self.http.server_close)
            self.endpoint = f"tcp/127.0.0.1:{free_ports(1)[0]}"
            self.zenoh = resources.enter_context(open_router(self.endpoint))
            self.pose = resources.enter_context(self.zenoh.declare_publisher(f"{self.stem}/pose"))
            self.event = resources.enter_context(self.zenoh.declare_publisher(f"{self.stem}/event"))
            resources.enter_context(self.zenoh.declare_subscriber(f"{self.stem}/cloud", self.take_cloud))
            resources.enter_context(self.zenoh.liveliness().declare_subscriber(f"{self.stem}/client", self.take_token))
            self.worker = threading.Thread(target=self.work, daemon=True)
            self.server = threading.Thread(target=self.http.serve_forever, args=(0.01,), daemon=True)
            self.worker.start()
            self.server.start()
            self.resources = resources.pop_all()
        return self

    def __exit__(self, *exception: object) -> None:
        self.http.shutdown()
        with self.changed:
            self.stopped = True
            self.changed.notify_all()
        self.resources.close()
        self.worker.join(5)

    def take_token(self, sample: zenoh.Sample) -> None:
        (self.token_seen if sample.kind == zenoh.SampleKind.PUT else self.token_gone).set()

    def take_cloud(self, sample: zenoh.Sample) -> None:
        """The newest replaces one that waits, as in the service."""
        with self.changed:
            self.newest = sample
            self.arrived_seq, _ = numbers_of(sample)
            self.changed.notify_all()

    def wait_for_cloud(self, seq: int, timeout_s: float = 20) -> None:
        """Wait until this cloud has arrived, whether it is ever taken up or not."""
        with self.changed:
            assert self.changed.wait_for(lambda: self.arrived_seq >= seq, timeout_s), f"cloud {seq} did not arrive"

    def wait_until_taken(self, seq: int, timeout_s: float = 20) -> None:
        """Wait until this cloud, or a later one, is in hand: none that comes now replaces it."""
        with self.changed:
            taken = self.changed.wait_for(lambda: bool(self.clouds) and self.clouds[-1][0] >= seq, timeout_s)
            assert taken, f"cloud {seq} was not taken"

    def next_cloud(self) -> zenoh.Sample | None:
        """The cloud that waits, as soon as there is one; None at the end."""
        with self.changed:
            self.changed.wait_for(lambda: self.stopped or self.newest is not None)
            sample, self.newest = self.newest, None
            return None if self.stopped else sample

    def work(self) -> None:
        while (sample := self.next_cloud()) is not None:
            seq, stamp_ns = numbers_of(sample)
            points = DECODERS[str(sample.encoding)](sample.payload.to_bytes())
            with self.changed:
                self.clouds.append((seq, stamp_ns, points))
                self.changed.notify_all()
            self.tell(self.answer(self, seq, points), seq=seq, stamp_ns=stamp_ns)

    def tell(self, members: dict[str, Any] | None, **frame: int) -> None:
        """Publish a result or an event."""
        if members is None:
            return
        common = {"session_id": self.session_id, **frame}
        if "kind" in members:
            self.event.put(json.dumps({"state": "tracking", "reason": None, "detail": None} | common | members))
        else:
            self.pose.put(json.dumps({"frame_id": "", "timing_ms": TIMING} | common | members))

    def handle(self, method: str, path: str, body: bytes, media_type: str) -> tuple[int, Any]:
        """Answer to one HTTP request."""
        read: Any = json.loads(body) if body and "json" in media_type else body
        self.requests.append((method, path, read))
        match method, path.partition("?")[0]:
            case "POST", "/v1/sessions" if read["category"] == "unicorn":
                detail = "there is no category 'unicorn': use one of mug, bottle"
                return 422, {"title": "Unknown category", "reason": "unknown-category", "detail": detail}
            case "POST", "/v1/sessions":
                keys = {name: f"{self.stem}/{name}" for name in ("cloud", "pose", "event")}
                zenoh_part = {**keys, "endpoints": [self.endpoint.replace("127.0.0.1", "0.0.0.0")]}
                return 201, {
                    "session_id": self.session_id,
                    "category": read["category"],
                    "state": "tracking",
                    "expires_after_s": 300.0,
                    "encodings": list(DECODERS),
                    "zenoh": zenoh_part,
                }
            case "POST", frames if frames.endswith("/frames"):
                result = at_centroid(self, 0, DECODERS[media_type](body))
                return 200, {"session_id": "s1", "seq": 0, "stamp_ns": 7, "frame_id": "", "timing_ms": TIMING} | result
            case "DELETE", _:
                self.closed.set()
                return 204, None
            case (("GET" | "PUT"), session) if session.startswith(f"/v1/sessions/{self.session_id}"):
                return 200, {"client": self.token_seen.is_set()}
        return 404, {"title": "Not found", "reason": "not-found", "detail": f"there is no {path}"}


def open_router(endpoint: str) -> zenoh.Session:
    """A Zenoh router on one endpoint that looks for nobody."""
    config = zenoh.Config()
    config.insert_json5("mode", '"router"')
    config.insert_json5("listen/endpoints", json.dumps([endpoint]))
    config.insert_json5("scouting/multicast/enabled", "false")
    config.insert_json5("scouting/delay", "0")
    return zenoh.open(config)


def handler_of(service: FakeService) -> type[BaseHTTPRequestHandler]:
    """The request handler class that http.server wants."""

    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def answer(self) -> None:
            body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
            media_type = self.headers.get("Content-Type", "")
            status, members = service.handle(self.command, self.path, body, media_type)
            payload = b"" if members is None else json.dumps(members).encode()
            self.send_response(status)
            self.send_header("Content-Type", "application/json" if status < 400 else "application/problem+json")
            self.send_header("Content-Length", str(len(payload)))
            self.end_headers()
            self.wfile.write(payload)

        do_GET = do_POST = do_PUT = do_DELETE = answer  # noqa: N815 - http.server names them

        def log_message(self, *message: object) -> None:
            """Keep quiet."""

    return Handler

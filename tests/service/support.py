"""A whole service for tests: real sockets, with networks that follow the middle of whatever cloud they see."""

import json
import socket
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import zenoh
from jaxtyping import Float32
from zenoh import ext

from captra import sampling
from captra.categories import CATEGORIES, Category
from captra.joint_projection import UNPROJECTED
from captra.pose_memory import USUAL_ERROR
from captra.rotation_fusion import ROTATION_NET_ALONE
from captra.sampling import InputSampling, Neighborhoods, Profile
from captra.side_by_side import IN_TURN
from service.envelopes import pack_attachment
from service.http_server import HttpServer, bind
from service.networks import Engine, Model
from service.rejections import CategoryWithoutModelError
from service.rest.app import create_app
from service.run import build_transport
from service.settings import Settings
from service.store import InMemorySessionStore, SessionStore
from service.tracking_service import TrackingService
from service.warmup import warm_up

F32 = "application/vnd.captra.cloud.f32"
I16 = "application/vnd.captra.cloud.i16"
PROFILE = Profile("realtime", 64, (16, 4), ((2, 2, 2), (2, 2)))
STAMP_NS = 1_700_000_000_000_000_123
TIMEOUT_S = 10.0
PREPARED_S = 120.0
"""Kernels may have to be compiled first."""


class CentreNetworks:
    """Sees the object at the middle of the points, unturned: a tracker with it follows the centre of a blob.

    While `doubtful` its coordinates fit nothing; while `gate` is closed it keeps whoever asks waiting.
    """

    def __init__(self, category: Category, profile: Profile = PROFILE) -> None:
        self.category = category
        self.profile = profile
        self.input_sampling = InputSampling()
        self.rotation_fusion = ROTATION_NET_ALONE
        self.joint_projection = UNPROJECTED
        self.found_error = USUAL_ERROR
        self.side_by_side = IN_TURN
        self.doubtful = False
        self.broken = False
        self.asked = threading.Event()
        self.gate = threading.Event()
        self.gate.set()

    def coordinates(
        self, points_canonical: Float32[np.ndarray, "points 3"], neighborhoods: Neighborhoods
    ) -> tuple[Float32[np.ndarray, "classes points"], Float32[np.ndarray, "parts points 3"]]:
        self.asked.set()
        assert self.gate.wait(TIMEOUT_S)
        if self.broken:
            raise RuntimeError("the networks broke")
        parts = self.category.num_parts
        order = np.argsort(points_canonical[:, 1])
        segmentation = np.zeros((self.category.num_classes, len(points_canonical)), np.float32)
        coordinates = np.empty((parts, len(points_canonical), 3), np.float32)
        for part, members in enumerate(np.array_split(order, parts)):
            segmentation[part, members] = 1
            coordinates[part] = points_canonical - points_canonical[members].mean(axis=0)
        if self.doubtful:
            coordinates = np.random.default_rng(0).uniform(-0.5, 0.5, coordinates.shape).astype(np.float32)
        return segmentation, coordinates

    def rotations(
        self, points_canonical: Float32[np.ndarray, "parts points 3"], neighborhoods: Sequence[Neighborhoods]
    ) -> Float32[np.ndarray, "parts points width"]:
        unturned = [0, 1, 0] if self.category.symmetric else [1, 0, 0, 0, 1, 0]
        return np.tile(np.array(unturned, np.float32), (*points_canonical.shape[:2], 1))


class CentreProvider:
    """Networks for some categories, made when they are first asked for."""

    def __init__(self, *categories: str) -> None:
        self.networks = {name: CentreNetworks(CATEGORIES[name]) for name in categories}
        self.loading = threading.Event()
        self.loading.set()

    def prepare(self) -> None:
        assert self.loading.wait(TIMEOUT_S)
        sampling.warm_up()
        for networks in self.networks.values():
            warm_up(Engine(networks))
            networks.asked.clear()

    def get(self, category: str, profile: str) -> Engine:
        if category not in self.networks:
            raise CategoryWithoutModelError(f"there is no model of {category} here")
        return Engine(self.networks[category])

    def models(self) -> Sequence[Model]:
        return [Model(name, "float32", "none", ("realtime",), ("realtime",), None, {}) for name in self.networks]


def wait_until(holds: Callable[[], bool], otherwise: str = "it never came about", wait_s: float = TIMEOUT_S) -> None:
    """Look again and again whether something holds by now; `otherwise` says what went wrong where it never does."""
    deadline_s = time.monotonic() + wait_s
    while not holds():
        assert time.monotonic() < deadline_s, otherwise
        time.sleep(0.02)


@dataclass
class Running:
    """A service that runs, and a client of its REST API."""

    service: TrackingService
    provider: CentreProvider
    server: HttpServer
    http: httpx.Client
    endpoint: str

    def open_session(self, category: str = "mug", **options: Any) -> dict[str, Any]:
        """POST a session for an object at (0, 0, 0.5) m, once the service is prepared; returns the answer."""
        assert self.service.readiness.wait_prepared(PREPARED_S)
        answer = self.http.post("/v1/sessions", json=session_body(category, **options))
        assert answer.status_code == 201, answer.text
        opened: dict[str, Any] = answer.json()
        return opened

    def post_frame(
        self, session_id: str, payload: bytes, seq: int = 0, encoding: str = F32, stamp_ns: int = STAMP_NS
    ) -> httpx.Response:
        """POST one cloud."""
        return self.http.post(
            f"/v1/sessions/{session_id}/frames",
            params={"seq": seq, "stamp_ns": stamp_ns},
            content=payload,
            headers={"Content-Type": encoding} if encoding else {},
        )

    def session(self, session_id: str) -> dict[str, Any]:
        """GET a session."""
        shown: dict[str, Any] = self.http.get(f"/v1/sessions/{session_id}").json()
        return shown

    def metric(self, name: str) -> float:
        """Value of one line of /metrics."""
        for line in self.http.get("/metrics").text.splitlines():
            if line.startswith(name + " "):
                return float(line.rpartition(" ")[2])
        raise KeyError(name)


def wait_until_heard(network: zenoh.Session) -> None:
    """Until the router knows of everything that was declared so far: what it answers, it answers afterwards."""
    list(network.liveliness().get("captra/**"))


def free_endpoint() -> str:
    """A Zenoh endpoint on loopback that nobody listens on."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return f"tcp/127.0.0.1:{listener.getsockname()[1]}"


@contextmanager
def running(
    *categories: str,
    provider: CentreProvider | None = None,
    store: SessionStore | None = None,
    endpoint: str | None = None,
    **options: Any,
) -> Iterator[Running]:
    """A service of some categories (mug and laptop_articulated by default), with REST and Zenoh on free ports."""
    provider = provider or CentreProvider(*(categories or ("mug", "laptop_articulated")))
    endpoint = endpoint or free_endpoint()
    settings = Settings(models_dir=Path("/nowhere"), zenoh_listen=(endpoint,), **options)
    transport = build_transport(settings)
    with ExitStack() as resources:
        listener = resources.enter_context(bind("127.0.0.1", 0))
        service = TrackingService(settings, provider, store or InMemorySessionStore(), transport)
        resources.enter_context(service)
        server = HttpServer(create_app(service), settings.shutdown_timeout_s)
        thread = threading.Thread(target=server.run, args=([listener],))
        thread.start()
        resources.callback(thread.join, TIMEOUT_S)
        resources.callback(server.stop)
        url = f"http://127.0.0.1:{listener.getsockname()[1]}"
        http = resources.enter_context(httpx.Client(base_url=url, timeout=TIMEOUT_S))
        yield Running(service, provider, server, http, endpoint)


@contextmanager
def zenoh_client(endpoint: str) -> Iterator[zenoh.Session]:
    """A Zenoh session in client mode."""
    config = zenoh.Config()
    for key, value in {
        "mode": "client",
        "connect/endpoints": [endpoint],
        "scouting/multicast/enabled": False,
    }.items():
        config.insert_json5(key, json.dumps(value))
    with zenoh.open(config) as session:
        yield session


class Inbox:
    """What arrives on a key, in order."""

    def __init__(self, declare: Callable[[Callable[[zenoh.Sample], None]], object]) -> None:
        self._samples: list[zenoh.Sample] = []
        self._changed = threading.Condition()
        self._subscriber = declare(self._take)

    def _take(self, sample: zenoh.Sample) -> None:
        with self._changed:
            self._samples.append(sample)
            self._changed.notify_all()

    def sample(self, index: int) -> zenoh.Sample:
        """The sample at an index, waiting until it is there."""
        with self._changed:
            assert self._changed.wait_for(lambda: len(self._samples) > index, TIMEOUT_S), "nothing came"
            return self._samples[index]

    def message(self, index: int) -> dict[str, Any]:
        """The JSON at an index, waiting until it is there."""
        body: dict[str, Any] = json.loads(self.sample(index).payload.to_bytes())
        return body

    def wait_for(self, kind: str) -> dict[str, Any]:
        """The first event of a kind, waiting until it is there."""
        index = 0
        while (body := self.message(index))["kind"] != kind:
            index += 1
        return body

    def __len__(self) -> int:
        with self._changed:
            return len(self._samples)


def inbox(session: zenoh.Session, key: str) -> Inbox:
    """What is put on a key from now on."""
    return Inbox(lambda take: session.declare_subscriber(key, take))


def token_inbox(session: zenoh.Session, key: str) -> Inbox:
    """Liveliness tokens that are there, and all that come and go."""
    return Inbox(lambda take: session.liveliness().declare_subscriber(key, take, history=True))


@contextmanager
def late_inbox(session: zenoh.Session, key: str) -> Iterator[Inbox]:
    """What was last put on a key, and what is put from now on."""
    history = ext.HistoryConfig(detect_late_publishers=True)
    subscribers = ExitStack()  # an advanced subscriber that is left over keeps its Zenoh session from closing
    with subscribers:
        yield Inbox(
            lambda take: subscribers.enter_context(ext.declare_advanced_subscriber(session, key, take, history=history))
        )


class Camera:
    """Puts clouds of one session, once the service listens."""

    def __init__(self, session: zenoh.Session, key: str, encoding: str = F32) -> None:
        # Blocks instead of dropping, so that tests lose no frame on the way.
        self._publisher = session.declare_publisher(
            key, encoding=encoding, congestion_control=zenoh.CongestionControl.BLOCK, express=True
        )
        matched = threading.Event()
        with self._publisher.declare_matching_listener(lambda status: matched.set() if status.matching else None):
            status: Any = self._publisher.matching_status  # no bool, whatever its type says
            assert status.matching or matched.wait(TIMEOUT_S)

    def put(
        self, payload: bytes, seq: int = 0, stamp_ns: int = STAMP_NS, encoding: str | None = None, **options: Any
    ) -> None:
        """Put one cloud; `attachment=` replaces the right one."""
        options.setdefault("attachment", pack_attachment(seq, stamp_ns))
        self._publisher.put(payload, encoding=encoding, **options)


def session_body(category: str = "mug", translation: tuple[float, ...] = (0, 0, 0.5), **options: Any) -> dict[str, Any]:
    """A valid body of POST /v1/sessions."""
    parts = [part_body(translation=translation) for _ in CATEGORIES[category].parts]
    return {"category": category, "parts": parts} | options


def part_body(**options: Any) -> dict[str, Any]:
    """A valid part."""
    part = {"rotation": {"quat_xyzw": [0, 0, 0, 1]}, "translation": [0, 0, 0.5], "size": [0.1, 0.1, 0.1]}
    return part | options


def blob(centre: Sequence[float] = (0, 0, 0.5), points: int = 300) -> Float32[np.ndarray, "points 3"]:
    """Points of an object of 10 cm, evenly around its centre."""
    half = np.random.default_rng(1).uniform(-0.05, 0.05, (points // 2, 3))
    return (np.concatenate([half, -half]) + centre).astype(np.float32)


def f32(points: np.ndarray[Any, Any]) -> bytes:
    """Points as the f32 encoding has them."""
    return points.astype("<f4").tobytes()


def i16(points: np.ndarray[Any, Any]) -> bytes:
    """Points as the i16 encoding has them."""
    return np.rint(points * 1e4).astype("<i2").tobytes()

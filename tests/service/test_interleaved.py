"""Many sessions at once, each against its own ground truth, while malformed clouds go to others."""

import threading
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import count

import numpy as np
import pytest
import zenoh

from benchmarks.malformed import malformed_clouds
from captra.categories import CATEGORIES
from captra.geometry import Pose
from service.networks import Engine
from tests.seeing import Course, SeeingNetworks
from tests.service.support import Camera, CentreProvider, Inbox, Running, f32, inbox, part_body, running, zenoh_client

SESSIONS, ATTACKED, FRAMES = 64, 8, 12
LONGEST_ENCODING = 200
"""Zenoh's client ends its own process over longer ones, so that none reaches the service."""


class SeeingProvider(CentreProvider):
    """One pair of networks, shared by all sessions as in the service."""

    def get(self, category: str, profile: str) -> Engine:
        return Engine(SeeingNetworks(CATEGORIES[category]))


@dataclass
class Tracked:
    """A session that follows a course of its own."""

    course: Course
    session_id: str
    camera: Camera
    poses: Inbox

    def put(self, frame: int) -> None:
        self.camera.put(f32(self.course.cloud(frame)), frame, stamp_ns=1000 * frame)

    def check(self, frame: int) -> None:
        """The answer is of this session, this frame and this object."""
        answer, truth = self.poses.message(frame), self.course.pose(frame)
        assert (answer["session_id"], answer["seq"], answer["stamp_ns"]) == (self.session_id, frame, 1000 * frame)
        assert answer["state"] == "tracking"
        (part,) = answer["parts"]
        assert part["translation"] == pytest.approx(truth.translation[0], abs=1e-5)
        assert part["size"] == pytest.approx(truth.size[0], abs=1e-5)
        turned = abs(np.dot(part["quat_xyzw"], quat_xyzw(truth)))
        assert turned == pytest.approx(1, abs=1e-6)


def quat_xyzw(pose: Pose) -> np.ndarray:
    """The rotation of a course's pose, which is less than half a turn."""
    R = pose.rotation[0]
    w = np.sqrt(1 + np.trace(R)) / 2
    return np.array([*(R[[2, 0, 1], [1, 2, 0]] - R[[1, 2, 0], [2, 0, 1]]) / (4 * w), w])


@pytest.fixture
def service() -> Iterator[Running]:
    with running(provider=SeeingProvider("mug"), max_sessions=SESSIONS + ATTACKED) as started:
        assert started.service.readiness.wait_prepared(30)
        yield started


def tracked(service: Running, network: zenoh.Session, number: int) -> Tracked:
    course = Course.of(number)
    pose = course.pose(0)
    part = part_body(translation=pose.translation[0].tolist(), size=pose.size[0].tolist())
    opened = service.open_session(parts=[part])
    keys = opened["zenoh"]
    return Tracked(course, opened["session_id"], Camera(network, keys["cloud"]), inbox(network, keys["pose"]))


def attack(session: zenoh.Session, keys: list[str], stop: threading.Event) -> None:
    """Malformed clouds to every session in turn, as fast as they go."""
    publishers = [session.declare_publisher(key, congestion_control=zenoh.CongestionControl.BLOCK) for key in keys]
    for number, envelope in zip(count(), malformed_clouds(seed=7), strict=False):
        if stop.wait(0.0005):
            return
        encoding = envelope.encoding[:LONGEST_ENCODING]
        publishers[number % len(publishers)].put(envelope.payload, encoding=encoding, attachment=envelope.attachment)


def test_not_one_wrong_answer_among_many_sessions_beside_malformed_clouds(service: Running) -> None:
    stop = threading.Event()
    with ExitStack() as resources:
        network, foe = (resources.enter_context(zenoh_client(service.endpoint)) for _ in range(2))
        sessions = [tracked(service, network, number) for number in range(SESSIONS)]
        attacked = [service.open_session() for _ in range(ATTACKED)]
        attacker = threading.Thread(target=attack, args=(foe, [each["zenoh"]["cloud"] for each in attacked], stop))
        attacker.start()
        resources.callback(attacker.join)
        resources.callback(stop.set)
        rng = np.random.default_rng(3)
        for frame in range(FRAMES):
            for index in rng.permutation(SESSIONS):
                sessions[index].put(frame)
            for each in sessions:
                each.check(frame)
    for each in sessions:
        counters = service.session(each.session_id)["counters"]
        assert (counters["received"], counters["processed"]) == (FRAMES, FRAMES)
        assert (counters["dropped"], counters["rejected"]) == (0, 0)
    rejected = [service.session(each["session_id"])["counters"]["rejected"] for each in attacked]
    assert min(rejected) > 0
    assert service.metric('captra_frames_rejected_total{reason="internal-error"}') == 0

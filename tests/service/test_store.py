import numpy as np

from captra.geometry import Pose
from service.store import InMemorySessionStore, SessionRecord, TrustedPose


def pose(x: float) -> Pose:
    return Pose.from_size(np.eye(3)[None], np.array([[x, 0.0, 1.0]]), np.full((1, 3), 0.1))


def record(session_id: str, created_ns: int = 0) -> SessionRecord:
    return SessionRecord(session_id, "mug", "realtime", "camera", 60.0, created_ns, TrustedPose(pose(0), None))


def test_sessions_come_back_oldest_first_with_their_last_trusted_pose() -> None:
    store = InMemorySessionStore()
    store.save(record("b", created_ns=2))
    store.save(record("a", created_ns=1))
    trusted = TrustedPose(pose(5), 17)
    store.trust("b", trusted)
    assert [kept.session_id for kept in store.load()] == ["a", "b"]
    assert store.load()[1].trusted is trusted


def test_removed_sessions_stay_away() -> None:
    store = InMemorySessionStore()
    store.save(record("a"))
    store.remove("a")
    store.remove("a")
    store.trust("a", TrustedPose(pose(1), 1))
    assert store.load() == []

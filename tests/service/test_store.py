import sqlite3
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from captra.depth_images import Intrinsics
from captra.geometry import Pose
from service import sqlite_store
from service.camera import Camera
from service.sqlite_store import SqliteSessionStore
from service.store import InMemorySessionStore, SessionRecord, SessionStore, StoreError, TrustedPose
from service.track_options import Smoothing, TrackOptions

OPTIONS = TrackOptions("constant-velocity", Smoothing(1.5, 10.0, 2.0), {"hinge": (-1.0, 0.0, 0.25)})


def pose(x: float) -> Pose:
    return Pose(np.eye(3)[None], np.array([[x, 0.1 + 0.2, 1.0]]), np.array([0.3]), np.full((1, 3), 0.1))


def record(session_id: str, created_ns: int = 0) -> SessionRecord:
    camera = Camera(Intrinsics(590.0, 591.0, 319.5, 239.5), 0.001, 640, 480)
    trusted = TrustedPose(pose(0), None)
    kept = SessionRecord(session_id, "mug", "realtime", "camera", 60.0, created_ns, trusted)
    return replace(kept, camera=camera, masks="object", options=OPTIONS)


def same(one: SessionRecord, other: SessionRecord) -> bool:
    arrays = all(
        np.array_equal(getattr(one.trusted.pose, name), getattr(other.trusted.pose, name))
        for name in ("rotation", "translation", "scale", "size")
    )
    return arrays and one.trusted.seq == other.trusted.seq and one == replace(other, trusted=one.trusted)


@pytest.fixture(params=["memory", "sqlite"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[SessionStore]:
    make: dict[str, Callable[[], SessionStore]] = {
        "memory": InMemorySessionStore,
        "sqlite": lambda: SqliteSessionStore(tmp_path / "deep" / "store.sqlite"),
    }
    made = make[request.param]()
    yield made
    made.close()


def test_sessions_come_back_oldest_first_with_their_last_trusted_pose(store: SessionStore) -> None:
    store.save(record("b", created_ns=2))
    store.save(replace(record("a", created_ns=1), has_client=True, secret_sha256="f00"))
    for seq in range(17):
        store.trust("b", TrustedPose(pose(seq), seq))
    store.trust("b", TrustedPose(pose(1 / 3), 2**64 - 1))
    kept = store.load()
    assert [each.session_id for each in kept] == ["a", "b"]
    assert same(kept[0], replace(record("a", created_ns=1), has_client=True, secret_sha256="f00"))
    assert same(kept[1], replace(record("b", created_ns=2), trusted=TrustedPose(pose(1 / 3), 2**64 - 1)))


def test_removed_sessions_stay_away(store: SessionStore) -> None:
    store.save(record("a"))
    store.trust("a", TrustedPose(pose(1), 1))
    store.remove("a")
    store.remove("a")
    store.trust("a", TrustedPose(pose(1), 1))
    assert store.load() == []
    store.close()
    store.close()


def test_what_is_trusted_reaches_the_file_by_itself(tmp_path: Path) -> None:
    store = SqliteSessionStore(tmp_path / "store.sqlite", flush_every_s=0.01)
    store.save(record("a"))
    store.trust("a", TrustedPose(pose(5), 17))
    deadline = time.monotonic() + 10
    while (tmp_path / "store.sqlite-wal").read_bytes().find(b'"seq":17') < 0:
        assert time.monotonic() < deadline
        time.sleep(0.01)
    store.close()


def test_what_was_saved_is_there_when_the_process_dies(tmp_path: Path) -> None:
    store = SqliteSessionStore(tmp_path / "store.sqlite", flush_every_s=60)
    store.save(record("a"))
    for file in tmp_path.iterdir():  # as a killed process leaves it
        (tmp_path / f"copy-{file.name}").write_bytes(file.read_bytes())
    copy = SqliteSessionStore(tmp_path / "copy-store.sqlite")
    assert [each.session_id for each in copy.load()] == ["a"]
    copy.close()
    store.close()


def test_two_processes_cannot_have_the_same_sessions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sqlite_store, "TAKEOVER_WAIT_S", 0.1)
    first = SqliteSessionStore(tmp_path / "store.sqlite")
    with pytest.raises(StoreError, match=r"another service process.*CAPTRA_STATE_DIR"):
        SqliteSessionStore(tmp_path / "store.sqlite")
    first.close()
    SqliteSessionStore(tmp_path / "store.sqlite").close()


def test_the_next_process_waits_for_the_one_before(tmp_path: Path) -> None:
    first = SqliteSessionStore(tmp_path / "store.sqlite")
    first.save(record("a"))
    timer = threading.Timer(0.3, first.close)
    timer.start()
    second = SqliteSessionStore(tmp_path / "store.sqlite")
    assert [each.session_id for each in second.load()] == ["a"]
    second.close()
    timer.join()


def test_files_that_are_no_store_are_named_and_left_alone(tmp_path: Path) -> None:
    file = tmp_path / "store.sqlite"
    file.write_bytes(b"not a database" * 1000)
    with pytest.raises(StoreError, match=r"store\.sqlite.*move the file away"):
        SqliteSessionStore(file)
    assert file.read_bytes() == b"not a database" * 1000
    (tmp_path / "file").touch()
    with pytest.raises(StoreError, match="CAPTRA_STATE_DIR"):
        SqliteSessionStore(tmp_path / "file" / "store.sqlite")
    newer = tmp_path / "newer.sqlite"
    with sqlite3.connect(newer) as connection:
        connection.execute("PRAGMA user_version = 99")
    connection.close()
    with pytest.raises(StoreError, match="newer version"):
        SqliteSessionStore(newer)


def test_unreadable_session_costs_no_other(tmp_path: Path) -> None:
    SqliteSessionStore(tmp_path / "store.sqlite").close()
    with sqlite3.connect(tmp_path / "store.sqlite") as connection:
        connection.execute("INSERT INTO sessions VALUES ('odd', 1, '{}', '{')")
    connection.close()
    store = SqliteSessionStore(tmp_path / "store.sqlite")
    store.save(record("a", 2))
    assert [each.session_id for each in store.load()] == ["a"]
    store.close()
    with sqlite3.connect(tmp_path / "store.sqlite") as connection:
        assert connection.execute("SELECT count(*) FROM sessions").fetchone() == (2,)
    connection.close()


def test_what_could_not_be_removed_is_removed_once_the_disk_takes_it(tmp_path: Path) -> None:
    store = SqliteSessionStore(tmp_path / "sessions.sqlite", flush_every_s=0.02)
    store.save(record("gone", 1))
    store.save(record("stays", 2))
    store._connection.execute("PRAGMA query_only = ON")  # as a disk that is full
    store.remove("gone")
    assert [each.session_id for each in store.load()] == ["gone", "stays"]
    store._connection.execute("PRAGMA query_only = OFF")
    deadline_s = time.monotonic() + 10
    while len(store.load()) > 1 and time.monotonic() < deadline_s:
        time.sleep(0.02)
    assert [each.session_id for each in store.load()] == ["stays"]
    store.close()


def test_session_that_cannot_be_stored_is_not_promised_and_every_failure_is_told(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    store, failures = SqliteSessionStore(tmp_path / "store.sqlite", flush_every_s=60), Counter[str]()
    store.watch(lambda: failures.update(["write"]))
    store.save(record("kept"))
    store._connection.execute("PRAGMA query_only = ON")  # as a disk that is full
    with pytest.raises(StoreError, match="CAPTRA_STATE_DIR"):
        store.save(record("a"))
    store.trust("kept", TrustedPose(pose(5), 17))
    for _ in range(3):
        store.flush()
    assert failures["write"] == 4
    assert [(entry.levelname, entry.__dict__["session_ids"]) for entry in caplog.records] == [("ERROR", ["kept"])]
    store._connection.execute("PRAGMA query_only = OFF")
    store.save(record("b", created_ns=1))
    assert [(each.session_id, each.trusted.seq) for each in store.load()] == [("kept", 17), ("b", None)]
    assert failures["write"] == 4
    store.close()
